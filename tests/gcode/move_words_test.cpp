#include "gcode/move_words.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.h"
#include "gcode/text.h"

namespace bead {
namespace {

rc::Gen<std::string> numbers() {
    using rc::gen::arbitrary;
    const auto digits = [](int most) {
        return rc::gen::mapcat(rc::gen::inRange(0, most), [](int count) {
            return rc::gen::container<std::string>(std::size_t(count), rc::gen::inRange('0', ':'));
        });
    };
    return rc::gen::map(
        rc::gen::tuple(rc::gen::element<std::string>("", "", "-", "+", "--"), digits(7),
                       rc::gen::element<std::string>(".", ".", ""), digits(14)),
        [](const auto& parts) {
            const auto& [sign, whole, point, rest] = parts;
            return sign + whole + point + rest;
        });
}

rc::Gen<std::string> lines() {
    const auto word = rc::gen::map(
        rc::gen::tuple(
            rc::gen::element<std::string>(" ", " ", " ", " ", "  ", "\t", "", " (x)"),
            rc::gen::element<std::string>("X", "Y", "Z", "E", "F", "x", "I", "S", "e", ";"),
            numbers()),
        [](const auto& parts) {
            const auto& [blank, letter, number] = parts;
            return blank + letter + number;
        });
    return rc::gen::map(
        rc::gen::tuple(rc::gen::element<std::string>("G1", "G1", "G0", "G01", "g1", "G11", "G1.1"),
                       rc::gen::container<std::vector<std::string>>(word),
                       rc::gen::element<std::string>("", "", "", "\r", " ", " ; end")),
        [](const auto& parts) {
            const auto& [command, words, end] = parts;
            std::string line = command;
            for (const std::string& each : words) line += each;
            return line + end;
        });
}

struct Outcome {
    std::vector<Position> places;
    std::vector<double> feeds;
    std::int64_t lines = 0, malformed = 0;
    std::map<std::string, std::int64_t> ignored;
    std::string complaint;
    bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(const std::string& text) {
    Outcome outcome;
    std::istringstream stream(text);
    try {
        const GcodeReport report = read_gcode(stream, {}, [&](const Command& command) {
            if (const Move* const move = std::get_if<Move>(&command.what)) {
                outcome.places.push_back(move->to);
                outcome.feeds.push_back(move->feed);
            }
        });
        outcome.lines = report.lines;
        outcome.malformed = report.malformed;
        outcome.ignored = report.ignored;
    } catch (const Error& error) {
        outcome.complaint = error.what();
    }
    return outcome;
}

// Twin: a line that begins with a blank is always read by the scanner.
RC_GTEST_PROP(PlainMove, is_read_as_the_scanner_reads_it, ()) {
    const auto text = *rc::gen::container<std::vector<std::string>>(lines());
    std::string as_it_is = "G28\n", by_the_scanner = "G28\n";
    for (const std::string& line : text) {
        as_it_is += line + "\n";
        by_the_scanner += " " + line + "\n";
    }
    RC_ASSERT(outcome_of(as_it_is) == outcome_of(by_the_scanner));
}

TEST(PlainMove, is_what_slicers_write) {
    const auto is_plain = [](std::string line) {
        line += "\n";
        return read_plain_move(line.c_str()).end == line.c_str() + line.size();
    };
    for (const char* line : {"G1 X105.123 Y99 E.02221", "G0 X1", "G1 E-.8 F2100", "G1 Z0.2",
                             "G1 F9000", "G1 X123456789.123456", "G1"})
        EXPECT_TRUE(is_plain(line)) << line;
    for (const char* line :
         {"G1 X1 ; on", "G1 X1e3", "G1X1", "G1 X", "G1 X-", "G1 X1 ", "G1 X1.2.3", "G1 X1234567890",
          "G1 X1.123456789012345", "G10 X1", "G92 X1", ""})
        EXPECT_FALSE(is_plain(line)) << line;
}

}  // namespace
}  // namespace bead
