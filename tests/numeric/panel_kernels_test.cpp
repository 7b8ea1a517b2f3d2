// The quick loops against the plain ones, one right side after the other: the same bits, whichever
// registers the processor has.
#include "numeric/panel_kernels.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace bead {
namespace {

struct PanelCase {
    std::ptrdiff_t own, border;
    std::vector<double> columns;        // one after the other, all their rows
    std::vector<double> strips, sides;  // the sides' rows: those of `own`, then of `border`
    [[nodiscard]] DensePanel panel() const { return {strips.data(), own, border}; }
    [[nodiscard]] double at(std::ptrdiff_t row, std::ptrdiff_t column) const {
        return columns[std::size_t(column * (own + border) + row)];
    }
};

PanelCase any_panel() {
    PanelCase one{*rc::gen::inRange<std::ptrdiff_t>(1, 23),
                  *rc::gen::inRange<std::ptrdiff_t>(0, 19),
                  {},
                  {},
                  {}};
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::uniform_real_distribution<double> number(-1, 1);
    const std::ptrdiff_t size = one.own + one.border;
    one.columns.resize(std::size_t(size * one.own));
    for (double& value : one.columns) value = number(random);
    for (std::ptrdiff_t j = 0; j < one.own; ++j) one.columns[std::size_t(j * size + j)] += 3;
    for (std::ptrdiff_t first = 0; first < one.own; first += 4)
        for (std::ptrdiff_t row = first; row < size; ++row)
            for (std::ptrdiff_t j = first; j < std::min(first + 4, one.own); ++j)
                one.strips.push_back(one.at(row, j));
    one.sides.resize(std::size_t(size * panel_width));
    for (double& value : one.sides) value = number(random);
    return one;
}

std::vector<double> plain_forward(const PanelCase& one) {
    std::vector<double> rows = one.sides;
    const std::ptrdiff_t size = one.own + one.border;
    for (std::ptrdiff_t side = 0; side < panel_width; ++side) {
        const auto x = [&](std::ptrdiff_t i) -> double& {
            return rows[std::size_t(i * panel_width + side)];
        };
        for (std::ptrdiff_t j = 0; j < one.own; ++j) {
            x(j) /= one.at(j, j);
            for (std::ptrdiff_t i = j + 1; i < size; ++i) x(i) -= one.at(i, j) * x(j);
        }
    }
    return rows;
}

// Four unknowns are found together: what lies behind all four comes first.
std::vector<double> plain_backward(const PanelCase& one) {
    std::vector<double> rows = one.sides;
    const std::ptrdiff_t whole_fours = one.own / 4 * 4;
    for (std::ptrdiff_t side = 0; side < panel_width; ++side) {
        const auto x = [&](std::ptrdiff_t i) -> double& {
            return rows[std::size_t(i * panel_width + side)];
        };
        for (std::ptrdiff_t j = one.own - 1; j >= 0; --j) {
            const std::ptrdiff_t behind = j < whole_fours ? j / 4 * 4 + 4 : j + 1;
            for (std::ptrdiff_t i = one.own; i < one.own + one.border; ++i)
                x(j) -= one.at(i, j) * x(i);
            for (std::ptrdiff_t i = behind; i < one.own; ++i) x(j) -= one.at(i, j) * x(i);
            for (std::ptrdiff_t i = behind - 1; i > j; --i) x(j) -= one.at(i, j) * x(i);
            x(j) /= one.at(j, j);
        }
    }
    return rows;
}

RC_GTEST_PROP(PanelKernels, EightSidesForwardAreThePlainLoopsBits, ()) {
    const PanelCase one = any_panel();
    std::vector<double> rows = one.sides;
    solve_forward(one.panel(), panel_width, rows.data(), rows.data() + one.own * panel_width);
    RC_ASSERT(rows == plain_forward(one));
}

RC_GTEST_PROP(PanelKernels, EightSidesBackwardAreThePlainLoopsBits, ()) {
    const PanelCase one = any_panel();
    std::vector<double> rows = one.sides;
    solve_backward(one.panel(), panel_width, rows.data(), rows.data() + one.own * panel_width);
    RC_ASSERT(rows == plain_backward(one));
}

RC_GTEST_PROP(PanelKernels, KnowHowLargeAPanelIs, ()) {
    const PanelCase one = any_panel();
    RC_ASSERT(std::size_t(panel_size(one.own, one.border)) == one.strips.size());
}

RC_GTEST_PROP(PanelKernels, OneSideIsTheFirstOfEightToTheBit, ()) {
    const PanelCase one = any_panel();
    std::vector<double> alone;
    for (std::size_t i = 0; i < one.sides.size(); i += panel_width) alone.push_back(one.sides[i]);
    std::vector<double> back = alone;
    solve_forward(one.panel(), 1, alone.data(), alone.data() + one.own);
    solve_backward(one.panel(), 1, back.data(), back.data() + one.own);
    const std::vector<double> forward_rows = plain_forward(one), back_rows = plain_backward(one);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        RC_ASSERT(alone[i] == forward_rows[i * panel_width]);
        RC_ASSERT(back[i] == back_rows[i * panel_width]);
    }
}

}  // namespace
}  // namespace bead
