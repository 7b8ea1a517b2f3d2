#include "job/power_log.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace bead {
namespace {

std::string seconds(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += std::to_string(2 * i) + "," + std::to_string(i) + "\n";
    return text;
}

std::string log_fault(const std::string& text) {
    try {
        parsed_power_log(text, "plug.csv");
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "no fault";
}

TEST(PowerLog, MayHaveAHeaderOrNot) {
    for (const std::string head : {"", "time,watts\n", "# my plug\nt;P\n"}) {
        std::string body = seconds(12);
        if (head.find(';') != std::string::npos)
            for (char& c : body) c = c == ',' ? ';' : c;
        const PowerLog log = parsed_power_log(head + body, "plug.csv");
        ASSERT_EQ(log.trace.samples.size(), 12U) << head;
        EXPECT_EQ(log.trace.samples[3].time, 6);
        EXPECT_EQ(log.trace.samples[3].watts, 3);
        EXPECT_EQ(log.trace.usual_interval, 2);
    }
}

// The same instants, written in five ways, across a leap day.
TEST(PowerLog, UnderstandsIso8601) {
    std::string text = "time,W\n";
    const char* times[] = {"2024-02-28T23:59:58Z",     "2024-02-28 23:59:59",
                           "2024-02-29T00:00:00.500Z", "2024-02-29T02:00:01,25+02:00",
                           "2024-02-28T22:00:02-0200", "2024-03-01T00:00:00Z",
                           "2024-03-01T00:00:01+00",   "2024-03-01T00:00:02Z",
                           "2024-03-01T00:00:03Z",     "2024-03-01T00:01Z"};
    for (const char* time : times) text += '"' + std::string(time) + "\",5\n";
    const PowerLog log = parsed_power_log(text, "plug.csv");
    const double zero = log.trace.samples[0].time;
    const double expected[] = {0, 1, 2.5, 3.25, 4, 86402, 86403, 86404, 86405, 86462};
    for (std::size_t i = 0; i < std::size(expected); ++i)
        EXPECT_NEAR(log.trace.samples[i].time - zero, expected[i], 1e-6) << times[i];
}

TEST(PowerLog, CountsRowsWithoutPower) {
    const PowerLog log =
        parsed_power_log(seconds(12) + "30,\n32,unavailable\n34,unknown\n36,7\n", "plug.csv");
    EXPECT_EQ(log.missing, 3U);
    EXPECT_EQ(log.trace.samples.size(), 13U);
    EXPECT_TRUE(is_gap(log.trace, 36 - 22));
}

TEST(PowerLog, NamesWhatIsWrongAndWhere) {
    const struct {
        std::string text, words;
    } faults[] = {
        {"", "at least 10"},
        {seconds(5), "5 samples"},
        {seconds(12) + "20,5\n", "plug.csv:13: the clock goes back by 2 s"},
        {seconds(12) + "40,-3\n", "-3 W"},
        {seconds(12) + "40,1e9\n", "watts?"},
        {seconds(12) + "40,lots\n", "lots"},
        {seconds(12) + "later,5\n", "later is no time"},
        {seconds(12) + "2024-02-30T00:00:00Z,5\n", "no time"},
        {seconds(12) + "2024-02-20T25:00:00Z,5\n", "no time"},
        {seconds(12) + "40,5,6\n", "3 columns"},
        {seconds(12) + "40\n", "1 columns"},
    };
    for (const auto& fault : faults) {
        const std::string message = log_fault(fault.text);
        EXPECT_NE(message.find(fault.words), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace bead
