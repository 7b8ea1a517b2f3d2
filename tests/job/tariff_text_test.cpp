#include "job/tariff_text.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

void expect_refused(const std::string& text, const std::string& words) {
    try {
        tariff_of(text);
        FAIL() << text;
    } catch (const Error& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find(words), said.npos) << said;
        EXPECT_EQ(said.find('\n'), said.npos);
        EXPECT_EQ(error.fault(), Fault::usage);
    }
}

TEST(TariffText, IsOnePrice) {
    const Tariff tariff = tariff_of("0.30");
    ASSERT_EQ(tariff.size(), 1U);
    EXPECT_EQ(tariff[0].price, 0.30);
    EXPECT_EQ(tariff[0].to, day);
}

TEST(TariffText, IsPricesByTimeOfDayInAnyOrder) {
    const Tariff tariff = tariff_of("06:00-24:00=0.30, 00:00-06:00=0.12");
    ASSERT_EQ(tariff.size(), 2U);
    EXPECT_EQ(tariff[0].price, 0.12);
    EXPECT_EQ(tariff[1].from, 6 * 3600);
}

TEST(TariffText, GoesOverMidnight) {
    const Tariff tariff = tariff_of("22:30-6:00=0.12,6:00-22:30=0.30");
    ASSERT_EQ(tariff.size(), 3U);
    EXPECT_EQ(tariff[0].to, 6 * 3600);
    EXPECT_EQ(tariff[2].price, 0.12);
    EXPECT_EQ(clock_text(tariff[2].from), "22:30");
}

TEST(TariffText, ThatIsWrongIsNamed) {
    expect_refused("cheap", "cheap is no tariff");
    expect_refused("-1", "is no tariff");
    expect_refused("nan", "is no tariff");
    expect_refused("00:00-06:00=0.12", "06:00 to 24:00 has no price");
    expect_refused("00:00-06:00=0.12,07:00-24:00=0.3", "06:00 to 07:00 has no price");
    expect_refused("00:00-07:00=0.12,06:00-24:00=0.3", "06:00 to 07:00 has two prices");
    expect_refused("00:00-25:00=0.12", "00:00-25:00 is no stretch of the day");
    expect_refused("06:00-06:00=0.12", "is no stretch of the day");
    expect_refused("00:00-24:00=-3", "is no price");
    expect_refused("00:00-24:00=0.3,,", "is no price");
}

TEST(TimeOfDay, IsHoursAndMinutes) {
    EXPECT_EQ(time_of_day("22:15"), 22 * 3600 + 15 * 60);
    for (const char* wrong : {"24:00", "7", "7:5", "12:60", "-1:00", "noon", ""})
        EXPECT_THROW(time_of_day(wrong), Error) << wrong;
}

}  // namespace
}  // namespace bead
