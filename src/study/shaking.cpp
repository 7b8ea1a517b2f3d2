#include "study/shaking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/expects.h"
#include "core/parallel.h"

namespace bead {
namespace {

const Figure* find(const ShakingCell& cell, const std::string& name) {
    const auto found = std::ranges::find(cell.figures, name, &Figure::name);
    return found == cell.figures.end() ? nullptr : &*found;
}

void check(const ShakingCell& cell) {
    if (cell.law.empty())
        throw Error(fmt::format("{} of {}: says no time law; name it", cell.path, cell.part));
    for (const char* name : {time_name, volume_name, underfill_name, overfill_name})
        if (find(cell, name) == nullptr)
            throw Error(
                fmt::format("{} of {} by {}: has no {}; without it the table would compare "
                            "unlike prints",
                            cell.path, cell.part, cell.law, name));
}

const ShakingCell& base_of(std::span<const ShakingCell> cells, const ShakingBase& base,
                           const std::string& part) {
    const auto found = std::ranges::find_if(cells, [&](const ShakingCell& cell) {
        return cell.path == base.path && cell.law == base.law && cell.part == part;
    });
    if (found == cells.end())
        throw Error(fmt::format("{}: has no {} by {} to compare with", part, base.path, base.law));
    return *found;
}

// %, of coverage mm²: of nothing to nothing no change.
double change(const std::string& column, double before, double after) {
    if (before == after) return 0;
    if (column.ends_with("mm²")) return after - before;
    return before == 0 ? std::numeric_limits<double>::infinity() : 100 * (after / before - 1);
}

void add_once(std::vector<std::string>& list, const std::string& name) {
    if (std::ranges::find(list, name) == list.end()) list.push_back(name);
}

ShakingLine line_of(std::span<const ShakingCell> cells, const ShakingBase& base,
                    const std::vector<std::string>& columns, const ShakingCell& first) {
    ShakingLine line{first.path, first.law, {}};
    for (const std::string& column : columns) {
        double sum = 0, worst = -std::numeric_limits<double>::infinity();
        int count = 0;
        for (const ShakingCell& cell : cells) {
            if (cell.path != first.path || cell.law != first.law) continue;
            const Figure* const before = find(base_of(cells, base, cell.part), column);
            const Figure* const after = find(cell, column);
            if (before == nullptr || after == nullptr) continue;
            const double percent = change(column, before->value, after->value);
            sum += percent;
            worst = std::max(worst, percent);
            ++count;
        }
        line.changes.push_back(count > 0 ? Change{sum / count, worst} : Change{NAN, NAN});
    }
    return line;
}

}  // namespace

ShakenMachine example_machine(double x, double y) {
    ShakenMachine machine;
    const std::array frequencies{x, y};
    for (std::size_t k = 0; k < 2; ++k) {
        DriveAxis& axis = machine.model.axes[k];
        const double omega = 2 * std::numbers::pi * frequencies[k];
        axis.flexure = axis.table_mass * omega * omega;
    }
    return machine;
}

std::vector<Figure> figures_of(const Response& r) {
    return {{time_name, r.time},
            {volume_name, r.volume},
            {"rms, mm/s²", r.rms_acceleration},
            {"5-40 Hz, mm/s²", r.rms_5_40hz},
            {"psd top 3", r.psd_top3},
            {"dev max, mm", r.deviation.max},
            {"dev mean, mm", r.deviation.mean},
            {"contour max, mm", r.contour.max},
            {"contour p99, mm", r.contour.p99},
            {"contour mean, mm", r.contour.mean},
            {"energy, J", total(r.energy)},
            {"servo, J", r.energy.servo},
            {"copper, J", r.energy.copper},
            {"melt, J", r.energy.melt},
            {"base, J", r.energy.base},
            {"CO2, g", r.co2},
            {"off nominal", r.off_nominal}};
}

std::vector<ShakingCell> shaken(std::span<const ShakenPath> paths, std::span<const NamedLaw> laws,
                                const ShakenMachine& machine, const AssessOptions& options) {
    std::vector<ShakingCell> cells(paths.size() * laws.size());
    parallel_for(cells.size(), 0, [&](std::size_t i) {
        const ShakenPath& path = paths[i / laws.size()];
        const NamedLaw& law = laws[i % laws.size()];
        ShakingCell& cell = cells[i];
        cell = {path.name, std::string(law.name), path.part, path.figures};
        std::ranges::move(figures_of(assess(path.toolpath, machine, law.law, options)),
                          std::back_inserter(cell.figures));
    });
    return cells;
}

ShakingTable changes(std::span<const ShakingCell> cells, const ShakingBase& base) {
    ShakingTable table;
    for (const ShakingCell& cell : cells) {
        check(cell);
        add_once(table.parts, cell.part);
        for (const Figure& figure : cell.figures) add_once(table.columns, figure.name);
    }
    for (const ShakingCell& cell : cells) {
        const bool known = std::ranges::any_of(table.lines, [&](const ShakingLine& line) {
            return line.path == cell.path && line.law == cell.law;
        });
        if (!known) table.lines.push_back(line_of(cells, base, table.columns, cell));
    }
    return table;
}

std::string text_of(const ShakingTable& table) {
    std::string text = fmt::format("{:<5} {:<9}", "path", "law");
    for (const std::string& column : table.columns) text += fmt::format(" | {}", column);
    text += '\n';
    for (const ShakingLine& line : table.lines) {
        text += fmt::format("{:<5} {:<9}", line.path, line.law);
        for (const Change& change : line.changes)
            text += std::isnan(change.mean)
                        ? std::string(" |      -  ")
                        : fmt::format(" | {:+.0f}/{:+.0f}", change.mean, change.worst);
        text += '\n';
    }
    return text;
}

}  // namespace bead
