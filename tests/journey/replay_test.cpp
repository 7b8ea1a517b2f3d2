// The published experiment, all of it, through the program.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace bead {
namespace {

using nlohmann::json;
using test::beadwork;
using test::Folder;

std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(SlowWay, TheThesisIsReproduced) {
    const Folder folder;
    const std::string csv = folder / "runs.csv", scatter = folder / "scatter.svg",
                      angles = folder / "angles.csv";
    const test::Outcome outcome = beadwork("replay somade2023 --json - --csv " + csv +
                                           " --scatter " + scatter + " --angles " + angles);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["rows"].size(), 300U);
    EXPECT_EQ(result["agreement"]["usable"]["rows"], 258);
    EXPECT_EQ(result["mape_percent"], result["agreement"]["usable"]["mape_percent"]);
    EXPECT_LT(double(result["mape_percent"]), 2.1);
    EXPECT_GT(double(result["spearman"]), 0.99);
    for (const auto& [shape, value] : result["spearman_by_shape"].items())
        EXPECT_GT(double(value), 0.85) << shape;
    EXPECT_EQ(result["appendix"]["rows"], 62);
    EXPECT_LT(double(result["appendix"]["worst_relative"]), 1e-6);
    EXPECT_EQ(result["appendix_d"].size(), 32U);
    EXPECT_EQ(result["bracket"].size(), 25U);
    EXPECT_EQ(result["claims"].size(), 6U);
    EXPECT_EQ(std::ranges::count(text_of(csv), '\n'), 301);
    EXPECT_EQ(std::ranges::count(text_of(angles), '\n'), 92);
    EXPECT_NE(text_of(scatter).find("</svg>"), std::string::npos);
}

TEST(SlowWay, AllRowsOfTheThesisCanBeTakenIn) {
    const json result = json::parse(beadwork("replay somade2023 --all --json -").out);
    EXPECT_EQ(result["rows_counted"], "all");
    EXPECT_EQ(result["mape_percent"], result["agreement"]["all"]["mape_percent"]);
    EXPECT_GT(double(result["mape_percent"]),
              double(result["agreement"]["usable"]["mape_percent"]));
}

TEST(WholeWay, AnotherExperimentIsWrongUsage) {
    EXPECT_EQ(beadwork("replay nobody1900").status, 2);
}

}  // namespace
}  // namespace bead
