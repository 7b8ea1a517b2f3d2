// beadwork post-process: the file's own words about time made true, in place, as slicers call
// scripts: options first, the path last.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>

#include "command.h"
#include "core/error.h"
#include "core/output_file.h"
#include "gcode/time_marks.h"
#include "gcode/time_text.h"
#include "json_result.h"
#include "time_rewrite.h"

namespace bead::cli {
namespace {

struct PostProcessCall {
    std::string file;
    bool dry_run = false;
    MachineOptions machine;
    OutputOptions output;
};

// What can be simulated but not be rewritten in place, by its first bytes.
struct Packed {
    std::string_view magic, complaint;
};
constexpr std::array packed{
    Packed{"\x1f\x8b", "is gzipped; unpack it first, only plain text is rewritten in place"},
    Packed{"PK\3\4", "is an archive; export plain G-code, only that is rewritten in place"}};

void refuse_unsuitable(const std::string& file) {
    if (file.empty())
        throw Error("post-process: the path of the G-code file is empty; slicers give it last");
    if (std::filesystem::is_directory(file))
        throw Error(file + ": is a folder; name a G-code file");
    if (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file))
        throw Error(file + ": is no file that could be rewritten in place");
    std::array<char, 4> start{};
    std::ifstream(file, std::ios::binary).read(start.data(), start.size());
    for (const Packed& row : packed)
        if (std::string_view(start.data(), start.size()).starts_with(row.magic))
            throw Error(fmt::format("{}: {}", file, row.complaint));
}

void rewrite(const std::string& file, const std::vector<Edit>& edits) {
    std::ifstream text(file, std::ios::binary);
    OutputFile out(file);
    copy_edited(text, out.stream(), edits, file);
    out.keep();
}

bool is_one_of_many(const Edit& edit) {
    return !progress_numbers(edit.was).empty() || edit.was.starts_with(";TIME_ELAPSED:");
}

std::string diff_of(char sign, std::string_view lines) {
    std::string text;
    while (!lines.empty()) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
        text += fmt::format("  {} {}\n", sign, line.substr(0, line.find('\r')));
    }
    return text;
}

std::string counted(std::ptrdiff_t count, const std::string& what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string what_changed(const PostProcessCall& options, const TimeRewrite& result) {
    if (result.edits.empty()) return "all of the file says so already";
    const auto many = std::ranges::count_if(result.edits, is_one_of_many);
    return fmt::format("{} of progress and {} {}", counted(many, "line"),
                       counted(std::ssize(result.edits) - many, "other place"),
                       options.dry_run ? "would change" : "changed");
}

void print_text(const Console& console, const PostProcessCall& options, const TimeRewrite& result) {
    const auto& estimate = result.slicer_estimate;
    console.say("{}: printing time {}{}; {}\n", options.file,
                console.strong(time_text(result.told)),
                estimate ? fmt::format(", the file said {}", time_text(*estimate)) : "",
                what_changed(options, result));
    if (!options.dry_run) return;
    for (const Edit& edit : result.edits)
        if (!is_one_of_many(edit))
            console.say("{}{}", diff_of('-', edit.was), diff_of('+', edit.now));
}

void write_json(const PostProcessCall& options, const TimeRewrite& result) {
    const auto many = std::ranges::count_if(result.edits, is_one_of_many);
    Json json = result_head("post-process", {options.file});
    json["time_s"] = result.told;
    json["simulated_s"] = result.simulated;
    if (result.slicer_estimate) json["slicer_estimate_s"] = *result.slicer_estimate;
    json["changed"] = {{"progress_lines", many}, {"other_places", std::ssize(result.edits) - many}};
    json["written"] = !options.dry_run && !result.edits.empty();
    json["firmware"] = name_of(result.choice.firmware.firmware);
    write_result(options.output.json, json);
}

void post_process(const PostProcessCall& options) {
    const Console console = console_of(options.output);
    refuse_unsuitable(options.file);
    const TimeRewrite result = time_rewrite(options.file, options.machine);
    for (const std::string& warning : result.warnings) console.warn(warning);
    if (!options.dry_run && !result.edits.empty()) rewrite(options.file, result.edits);
    print_text(console, options, result);
    write_json(options, result);
}

}  // namespace

void add_post_process(CLI::App& app) {
    const auto options = std::make_shared<PostProcessCall>();
    CLI::App& command =
        *app.add_subcommand("post-process", "put true times into a G-code file, in place");
    command.footer(
        "Example: as a post-processing script of PrusaSlicer or OrcaSlicer, which add the path\n"
        "  beadwork post-process --printer prusa-mk3s");
    command.add_option("FILE", options->file, "G-code of any slicer")->required();
    command.add_flag("--dry-run", options->dry_run, "say what would change and write nothing");
    declare(command, options->machine);
    declare(command, options->output);
    command.callback([options] { post_process(*options); });
}

}  // namespace bead::cli
