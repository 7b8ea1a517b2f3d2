#include "study/shaking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace bead {
namespace {

Toolpath ring(double radius, std::size_t chords) {
    Path path{.role = Role::wall, .bead = {0.4, 0.2}, .speed = 50, .points = {}};
    for (std::size_t i = 0; i <= chords; ++i) {
        const Vec2 at = radius * unit(2 * pi * double(i) / double(chords));
        path.points.push_back({at.x, at.y, 0.2});
    }
    return {path};
}

std::vector<ShakenPath> two_parts(double size_of_second) {
    std::vector<ShakenPath> paths;
    for (const std::string part : {"small", "large"})
        for (const std::string name : {"B", "T"}) {
            const double radius = part == "small" ? 8 : 20;
            paths.push_back({name,
                             part,
                             ring(radius * (name == "T" ? size_of_second : 1), 90),
                             {{underfill_name, 1}, {overfill_name, 2}}});
        }
    return paths;
}

double column(const ShakingTable& table, const ShakingLine& line, const std::string& name) {
    const auto found = std::ranges::find(table.columns, name);
    return line.changes.at(std::size_t(found - table.columns.begin())).mean;
}

TEST(Shaking, ComparesWithTheSamePartsBase) {
    const auto cells = shaken(two_parts(0.9), std::span(named_laws).first(2), {});
    const ShakingTable table = changes(cells, {"B", "K0"});
    ASSERT_EQ(table.lines.size(), 4U);
    EXPECT_EQ(table.parts, (std::vector<std::string>{"small", "large"}));
    for (const Change& change : table.lines[0].changes) {
        EXPECT_EQ(change.mean, 0);
        EXPECT_EQ(change.worst, 0);
    }
    const ShakingLine& shorter = table.lines[2];
    EXPECT_EQ(shorter.path + shorter.law, "TK0");
    EXPECT_NEAR(column(table, shorter, volume_name), -10, 1e-6);
    EXPECT_EQ(column(table, shorter, underfill_name), 0);
    EXPECT_LT(column(table, shorter, time_name), -5);
    EXPECT_NE(text_of(table).find("T     K1"), std::string::npos);
}

TEST(Shaking, IsTheSameOnAnyMachinesOrder) {
    const auto paths = two_parts(1);
    const auto first = shaken(paths, named_laws, example_machine(9, 13));
    const auto again = shaken(paths, named_laws, example_machine(9, 13));
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t k = 0; k < first[i].figures.size(); ++k)
            ASSERT_EQ(first[i].figures[k].value, again[i].figures[k].value);
}

TEST(Shaking, RefusesATableThatHidesWhatIsPrinted) {
    const auto cells = shaken(two_parts(1), std::span(named_laws).first(1), {});
    for (const char* name : {time_name, volume_name, underfill_name, overfill_name}) {
        std::vector<ShakingCell> poor = cells;
        std::erase_if(poor.back().figures, [&](const Figure& f) { return f.name == name; });
        try {
            changes(poor, {"B", "K0"});
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
        }
    }
    std::vector<ShakingCell> lawless = cells;
    lawless.front().law.clear();
    EXPECT_THROW(changes(lawless, {"B", "K0"}), Error);
    EXPECT_THROW(changes(cells, {"B0", "K0"}), Error);
}

}  // namespace
}  // namespace bead
