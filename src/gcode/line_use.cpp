#include "gcode/line_use.h"

#include <algorithm>
#include <array>

#include "gcode/move_words.h"
#include "gcode/scanner.h"

namespace bead {
namespace {

constexpr std::array feature_tags{
    "TYPE:", "WIDTH:", "FEATURE:", "LINE_WIDTH:", "WIPE_START", "WIPE_END", "_EXTRUSION_ROLE"};

struct CommandUse {
    char letter;
    int number;
    LineUse use;
};
constexpr std::array uses{
    CommandUse{'G', 0, LineUse::motion},   CommandUse{'G', 1, LineUse::motion},
    CommandUse{'G', 2, LineUse::motion},   CommandUse{'G', 3, LineUse::motion},
    CommandUse{'G', 10, LineUse::recoil},  CommandUse{'G', 11, LineUse::recoil},
    CommandUse{'M', 106, LineUse::fan},    CommandUse{'M', 107, LineUse::fan},
    CommandUse{'M', 204, LineUse::limits}, CommandUse{'M', 205, LineUse::limits},
    CommandUse{'M', 73, LineUse::aside},   CommandUse{'M', 117, LineUse::aside},
    CommandUse{'M', 118, LineUse::aside},  CommandUse{'M', 105, LineUse::aside},
    CommandUse{'M', 155, LineUse::aside},
};

std::string_view stripped(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

bool names_feature(std::string_view comment) {
    const std::string_view text = stripped(comment);
    return std::ranges::any_of(feature_tags,
                               [&](const char* tag) { return text.starts_with(tag); });
}

LineUse use_of_command(const Line& line, const FileState& before, const FileState& after) {
    if (line.letter == 0)
        return line.name == "SET_VELOCITY_LIMIT" ? LineUse::limits : LineUse::other;
    if (line.letter == 'G' && line.number == 92) {
        const Words words(line.rest);
        const bool e_only =
            words.has('E') && !words.any_of(Words::bit('X') | Words::bit('Y') | Words::bit('Z'));
        return e_only ? LineUse::motion : LineUse::other;
    }
    const auto row = std::ranges::find_if(uses, [&](const CommandUse& use) {
        return use.letter == line.letter && use.number == line.number;
    });
    if (row == uses.end()) return LineUse::other;
    // A fan that is not the part's, a second command on the line, a retraction that is none.
    const Words words(line.rest);
    if (words.has('G') || words.has('M')) return LineUse::other;
    if (row->use == LineUse::fan && words.has('P') && words.at('P') != 0) return LineUse::other;
    if (row->use == LineUse::recoil && before == after) return LineUse::other;
    return row->use;
}

}  // namespace

LineUse use_of(std::string_view text, const FileState& before, const FileState& after) {
    if (read_plain_move(text.data()).end != nullptr) return LineUse::motion;
    text.remove_suffix(1);
    const Line line = split_line(text);
    switch (line.kind) {
        case LineKind::blank:
            return LineUse::remark;
        case LineKind::comment:
            return names_feature(line.rest) ? LineUse::feature : LineUse::remark;
        case LineKind::command:
            return use_of_command(line, before, after);
        default:
            return LineUse::other;
    }
}

}  // namespace bead
