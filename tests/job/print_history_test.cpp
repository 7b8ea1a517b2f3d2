#include "job/print_history.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace bead {
namespace {

std::string reading(const std::string& value, const std::string& units,
                    const std::string& name = "energy") {
    return R"({"provider": "sensor plug", "name": ")" + name + R"(", "value": )" + value +
           R"(, "units": )" + (units.empty() ? "null" : '"' + units + '"') + "}";
}

std::string job(const std::string& status, const std::string& readings,
                const std::string& duration = "3600.5") {
    return R"({"job_id": "00001A", "filename": "sub/box.gcode", "status": ")" + status +
           R"(", "print_duration": )" + duration + R"(, "filament_used": 1234.5,)" +
           R"("metadata": {"size": 5}, "auxiliary_data": [)" + readings + "]}";
}

std::string answer(const std::string& jobs) {
    return R"({"result": {"count": 1, "jobs": [)" + jobs + "]}}";
}

std::string fault_of_history(const std::string& text, const std::string& sensor = "") {
    try {
        parsed_print_history(text, "h.json", sensor);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "no fault";
}

TEST(PrintHistory, ReadsACompletedJob) {
    const std::string one =
        job("completed", reading("2.8", "A", "max_current") + "," + reading("0.119977", "kWh"));
    for (const std::string& text : {answer(one), R"({"jobs": [)" + one + "]}", "[" + one + "]"}) {
        const PrintHistory history = parsed_print_history(text, "h.json");
        ASSERT_EQ(history.jobs.size(), 1U);
        EXPECT_EQ(history.jobs[0].id, "00001A");
        EXPECT_EQ(history.jobs[0].file, "sub/box.gcode");
        EXPECT_NEAR(history.jobs[0].energy, 0.119977 * 3.6e6, 1e-6);
        EXPECT_EQ(history.jobs[0].duration, 3600.5);
        EXPECT_EQ(history.jobs[0].filament, 1234.5);
        EXPECT_EQ(history.sensor, "energy of sensor plug");
    }
    EXPECT_EQ(parsed_print_history(answer(job("completed", reading("100", "Wh"))), "h.json")
                  .jobs[0]
                  .energy,
              360000);
}

TEST(PrintHistory, CountsWhatItLeavesOut) {
    const std::string good = job("completed", reading("1", "Wh"));
    const PrintHistory history = parsed_print_history(
        answer(good + "," + job("cancelled", reading("1", "Wh")) + "," +
               job("cancelled", reading("1", "Wh")) + "," + job("completed", "") + "," +
               job("completed", reading("0", "Wh")) + "," +
               job("completed", reading("null", "Wh")) + "," +
               job("completed", reading("1", "Wh"), "null") + ",7," + job("klippy_shutdown", "")),
        "h.json");
    EXPECT_EQ(history.jobs.size(), 1U);
    EXPECT_EQ(history.skipped.at("cancelled"), 2U);
    EXPECT_EQ(history.skipped.at("klippy_shutdown"), 1U);
    EXPECT_EQ(history.skipped.at("without a reading in kWh, Wh or J"), 2U);
    EXPECT_EQ(history.skipped.at("whose energy is not above 0"), 1U);
    EXPECT_EQ(history.skipped.at("without a print_duration above 0"), 1U);
    EXPECT_EQ(history.skipped.at("not a job"), 1U);
}

TEST(PrintHistory, AsksWhichOfSeveralReadings) {
    const std::string text =
        answer(job("completed", reading("1", "Wh", "printer") + "," + reading("9", "Wh", "lamp")));
    const std::string message = fault_of_history(text);
    EXPECT_NE(message.find("--sensor"), std::string::npos) << message;
    EXPECT_NE(message.find("lamp of sensor plug"), std::string::npos) << message;
    EXPECT_EQ(parsed_print_history(text, "h.json", "printer").jobs[0].energy, 3600);
}

TEST(PrintHistory, RefusesWhatIsNone) {
    EXPECT_NE(fault_of_history("{").find("JSON"), std::string::npos);
    EXPECT_NE(fault_of_history("{}").find("list of jobs"), std::string::npos);
    EXPECT_NE(fault_of_history("[]").find("no completed job"), std::string::npos);
    EXPECT_NE(fault_of_history(answer(job("cancelled", ""))).find("1 cancelled"),
              std::string::npos);
    EXPECT_NE(fault_of_history(answer(job("completed", reading("1e400", "Wh")))), "no fault");
    EXPECT_NE(fault_of_history(std::string(100000, '[')), "no fault");
}

}  // namespace
}  // namespace bead
