// At which angle of the fill does which machine work least? One layer of lines in a part of
// 40 x 40 mm, and in a disc of the same area, which has no angle of its own, at 0° to 90° in steps
// of 5°, on cartesian, CoreXY and delta machines. Prints the table of docs/kinematics.md (solid
// layers), draws its picture and writes every number: angles OUT.svg OUT.csv
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "core/output_file.h"
#include "measure.h"
#include "picture.h"

namespace bead::angles {
namespace {

constexpr int step = 5, count = 90 / step + 1;  // degrees

struct Fill {
    const char* name;
    double spacing;  // mm
};
constexpr std::array fills{Fill{"100 %", 0.45}, Fill{"20 %", 2.25}};
constexpr std::array speeds{50.0, 100.0, 200.0};

std::vector<Cost> swept(const Rig& rig, Task task) {
    std::vector<Cost> costs;
    for (int i = 0; i < count; ++i) {
        task.angle = i * step * pi / 180;
        costs.push_back(measured(rig, task));
    }
    return costs;
}

template <class Quantity>
std::vector<double> values_of(const std::vector<Cost>& costs, const Quantity& quantity) {
    std::vector<double> values(costs.size());
    std::ranges::transform(costs, values.begin(), quantity);
    return values;
}

// Per metre of line: how many lines just fit is no matter of the machine.
double time_of(const Cost& cost) { return cost.time / cost.length * 1000; }
double head_of(const Cost& cost) { return cost.head / cost.length * 1000; }
double machine_of(const Cost& cost) { return total(cost.energy) / cost.length * 1000; }

// The best angle, the worst one and how much more that is.
std::string spread(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax_element(values);
    return fmt::format("{}° to {}°: {:+.1f} %", (least - values.begin()) * step,
                       (most - values.begin()) * step, 100 * (*most / *least - 1));
}

void print_row(const Rig& rig, double speed, const std::vector<Cost>& square,
               const std::vector<Cost>& disc) {
    fmt::print("| {} | {:.0f} |", rig.name, speed);
    for (const std::vector<Cost>& costs : {square, disc})
        for (const auto quantity : {time_of, head_of, machine_of})
            fmt::print(" {} |", spread(values_of(costs, quantity)));
    fmt::print("\n");
}

void write_rows(std::ostream& out, const Rig& rig, const Fill& fill, double speed,
                const char* shape, const std::vector<Cost>& costs) {
    for (int i = 0; const Cost& c : costs)
        out << fmt::format(
            "\"{}\",{},{},{:.0f},{},{:.2f},{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},"
            "{:.3f}\n",
            rig.name, shape, fill.name, speed, step * i++, c.length, c.time, c.head,
            c.energy.motors, c.energy.hotend, c.energy.bed, c.energy.fans, c.energy.electronics,
            total(c.energy));
}

void study(const std::string& svg, const std::string& csv) {
    OutputFile rows(csv), drawing(svg);
    rows.stream() << "machine,shape,fill,speed_mm_s,angle_deg,length_mm,time_s,xy_motors_j,"
                     "motors_j,hotend_j,bed_j,fans_j,electronics_j,machine_j\n";
    fmt::print(
        "| machine, limits | mm/s | square: time | X and Y motors | machine | disc: time | "
        "X "
        "and Y motors | machine |\n|---|---|---|---|---|---|---|---|\n");
    Panel square_head{"square: X and Y motors", {}}, square_machine{"square: machine", {}},
        disc_head{"disc: X and Y motors", {}}, disc_machine{"disc: machine", {}};
    for (const Rig& rig : rigs())
        for (const Fill& fill : fills)
            for (const double speed : speeds) {
                const auto square = swept(rig, {Shape::square, fill.spacing, speed});
                const auto disc = swept(rig, {Shape::disc, fill.spacing, speed});
                if (fill.spacing < 1) print_row(rig, speed, square, disc);
                write_rows(rows.stream(), rig, fill, speed, "square", square);
                write_rows(rows.stream(), rig, fill, speed, "disc", disc);
                if (&fill != &fills.front() || speed != 100) continue;
                square_head.curves.push_back({rig.name, values_of(square, head_of)});
                square_machine.curves.push_back({rig.name, values_of(square, machine_of)});
                disc_head.curves.push_back({rig.name, values_of(disc, head_of)});
                disc_machine.curves.push_back({rig.name, values_of(disc, machine_of)});
            }
    drawing.stream() << picture({square_head, square_machine, disc_head, disc_machine});
    drawing.keep();
    rows.keep();
}

}  // namespace
}  // namespace bead::angles

int main(int argc, char** argv) {
    if (argc != 3) {
        fmt::print(stderr, "usage: angles OUT.svg OUT.csv\n");
        return 2;
    }
    bead::angles::study(argv[1], argv[2]);
}
