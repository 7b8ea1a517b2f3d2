#include "job/settings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "core/error.h"

namespace bead {
namespace {

std::vector<std::string> all_values(const Settings& settings) {
    std::vector<std::string> values;
    for (const Setting& setting : all_settings()) values.push_back(setting.get(settings));
    return values;
}

Error setting_error(std::string_view name, std::string_view value,
                    std::string_view where = "--set") {
    Settings settings;
    try {
        set(settings, name, value, where);
    } catch (const Error& error) {
        return error;
    }
    return Error("no error", Fault::other);
}

bool is_one_line(std::string_view text) {
    return !text.empty() && text.find_first_of("\r\n") == std::string_view::npos;
}

TEST(Settings, NamesDiffer) {
    std::set<std::string_view> names;
    for (const Setting& setting : all_settings())
        EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    EXPECT_GE(names.size(), 30U);
}

TEST(Settings, DefaultsAreAllowedAndSurviveBeingWritten) {
    for (const Setting& setting : all_settings()) {
        Settings settings;
        const std::vector<std::string> before = all_values(settings);
        set(settings, setting.name, get(settings, setting.name));
        EXPECT_EQ(all_values(settings), before) << setting.name;
    }
}

TEST(Settings, EachChangesItselfAndNothingElse) {
    const std::vector<std::string> before = all_values({});
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Setting& setting = all_settings()[i];
        int changes = 0;
        for (const std::string_view value : {"0.3", "3", "false", "concentric", "90"}) {
            Settings settings;
            if (!setting.set(settings, value)) continue;
            std::vector<std::string> after = all_values(settings);
            EXPECT_EQ(after[i], value) << setting.name;
            changes += after[i] == before[i] ? 0 : 1;
            after[i] = before[i];
            EXPECT_EQ(after, before) << setting.name;
        }
        EXPECT_GT(changes, 0) << setting.name;
    }
}

TEST(Settings, ReachTheOptionsInTheirUnits) {
    Settings settings;
    set(settings, "angle_deg", "180");
    set(settings, "density", "35%");
    set(settings, "infill_overlap", " 10 % ");
    set(settings, "pattern", "hilbert");
    set(settings, "relative_e", "false");
    EXPECT_DOUBLE_EQ(settings.plan.angle, pi);
    EXPECT_DOUBLE_EQ(settings.plan.density, 0.35);
    EXPECT_DOUBLE_EQ(settings.plan.infill_overlap, 0.1);
    EXPECT_EQ(settings.plan.pattern.name, "hilbert");
    EXPECT_FALSE(settings.relative_e);
}

TEST(Settings, SayWhatIsAllowed) {
    const Error error = setting_error("density", "1.7");
    EXPECT_STREQ(error.what(), "--set: density = 1.7 is not a number in 0 … 1 (0 % … 100 %)");
    EXPECT_EQ(error.fault(), Fault::usage);
    EXPECT_EQ(setting_error("density", "1.7", "fast.toml:3").fault(), Fault::input);
    EXPECT_STREQ(setting_error("wals", "2", "fast.toml:3").what(),
                 "fast.toml:3: there is no setting wals; did you mean walls?");
}

TEST(Settings, RefuseWhatIsNotWhollyAValue) {
    for (const std::string_view value :
         {"", " ", "0.2x", "x0.2", "0,2", "nan", "inf", "-inf", "1e999", "0x1", "0.2 0.3", "--1",
          "%", "-1", "101%", "maybe", "nonesuch"})
        for (const Setting& setting : all_settings()) {
            Settings settings;
            const bool is_an_angle = setting.name.ends_with("_deg") && value == "-1";
            EXPECT_EQ(setting.set(settings, value), is_an_angle) << setting.name << " = " << value;
        }
    EXPECT_EQ(setting_error("walls", "2.5").fault(), Fault::usage);
    EXPECT_EQ(setting_error("walls", "99999999999999999999").fault(), Fault::usage);
}

RC_GTEST_PROP(Settings, TakeOrRefuseAnyTextInOneLine, (const std::string& value)) {
    const Setting& setting =
        all_settings()[*rc::gen::inRange<std::size_t>(0, all_settings().size())];
    Settings settings;
    const std::vector<std::string> before = all_values(settings);
    try {
        set(settings, setting.name, value);
    } catch (const Error& error) {
        RC_ASSERT(is_one_line(error.what()));
        RC_ASSERT(std::string_view(error.what()).find(setting.name) != std::string_view::npos);
        RC_ASSERT(all_values(settings) == before);
    }
    RC_ASSERT(is_one_line(setting_error("?" + value, value).what()));
}

RC_GTEST_PROP(Settings, KeepNumbersToTheDigit, ()) {
    const double mm = *rc::gen::inRange(5, 5000) / 100.0;
    Settings settings;
    const std::string text = std::to_string(mm);
    set(settings, "bead_width_mm", text);
    RC_ASSERT(settings.plan.bead_width == mm);
    RC_ASSERT(std::stod(get(settings, "bead_width_mm")) == mm);
}

TEST(Settings, ABeadIsAtLeastAsWideAsHigh) {
    Settings settings;
    EXPECT_NO_THROW(check(settings));
    set(settings, "layer_height_mm", "0.5");
    EXPECT_THROW(check(settings), Error);
    set(settings, "bead_width_mm", "0.5");
    EXPECT_NO_THROW(check(settings));
    set(settings, "first_layer_height_mm", "0.6");
    EXPECT_THROW(
        {
            try {
                check(settings);
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("first_layer_width_mm = 0.45"),
                          std::string::npos);
                EXPECT_NE(std::string(error.what()).find("first_layer_height_mm = 0.6"),
                          std::string::npos);
                EXPECT_EQ(error.fault(), Fault::usage);
                throw;
            }
        },
        Error);
}

}  // namespace
}  // namespace bead
