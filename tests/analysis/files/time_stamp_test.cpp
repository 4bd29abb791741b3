#include "analysis/files/time_stamp.h"

#include <gtest/gtest.h>

namespace fourpost::time_stamp_test {
namespace {

double Between(std::string_view from, std::string_view to) {
  return ParseTimeStamp(to).value().After(ParseTimeStamp(from).value());
}

// Two seconds of a day below 2^17, each rounded by up to 2^-37.
constexpr double kRounding = 2e-11;

TEST(TimeStamp, OfEveryKindOfDate) {
  EXPECT_NEAR(Between("2025-11-14 20:09:00.563811", "2025-11-14 20:09:00.564811"), 0.001, kRounding);
  EXPECT_NEAR(Between("2025-11-14T20:09:00Z", "2025-11-15T20:09:00Z"), 86400, kRounding);
  EXPECT_NEAR(Between("2024-02-28 00:00:00", "2024-03-01 00:00:00"), 2 * 86400, kRounding);
  EXPECT_NEAR(Between("11/14/2025 8:09:00.5 PM", "11/15/2025 8:09:01 AM"), 43200.5, kRounding);
  EXPECT_NEAR(Between("14.11.2025 20:09:00,5", "14.11.2025 20:09:00,75"), 0.25, kRounding);
  EXPECT_NEAR(Between("28/02/2025 00:00", "01/03/2025 00:00"),
              ParseTimeStamp("2025-01-03 00:00")->After(*ParseTimeStamp("2025-02-28 00:00")), kRounding);
}

TEST(TimeStamp, OfTwelveHoursKnowsNoonAndMidnight) {
  EXPECT_EQ(Between("12:00:00 AM", "12:00:00 PM"), 43200);
  EXPECT_EQ(Between("11:59:59 am", "12:00:00 pm"), 1);
}

TEST(TimeStamp, WithoutADatePassesMidnight) { EXPECT_NEAR(Between("23:59:59.9", "00:00:00.1"), 0.2, kRounding); }

TEST(TimeStamp, IsNoOtherText) {
  for (const char* text : {"", "1.5", "2025-11-14", "12", "a:b", "2025-13-14 20:09:00", "25:00:00", "10:61", "10:10:99",
                           "20:09:00 x", "1:2:3:4"})
    EXPECT_FALSE(ParseTimeStamp(text)) << text;
}

}  // namespace
}  // namespace fourpost::time_stamp_test
