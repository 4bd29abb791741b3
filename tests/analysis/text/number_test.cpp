#include "analysis/text/number.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::number_test {
namespace {

TEST(ParseNumber, ReadsDecimalNumbers) {
  EXPECT_EQ(ParseNumber("0.3"), 0.3);
  EXPECT_EQ(ParseNumber("-1.5e-3"), -0.0015);
  EXPECT_EQ(ParseNumber("+2"), 2);
  EXPECT_EQ(ParseNumber("1E+3"), 1000);
  EXPECT_EQ(ParseNumber(".5"), 0.5);
}

TEST(ParseNumber, MustFillTheText) {
  for (const char* text : {"", " 1", "1 ", "1,5", "1.5.2", "0x10", "+-1", "1e", "e3", "1e3.5", "one"})
    EXPECT_FALSE(ParseNumber(text)) << text;
}

TEST(ParseNumber, MustBeFinite) {
  for (const char* text : {"nan", "NaN", "inf", "-infinity", "1e400"}) EXPECT_FALSE(ParseNumber(text)) << text;
}

TEST(ParseNumber, AppliesAPowerOfTenWithoutARoundingOfItsOwn) {
  EXPECT_EQ(ParseNumber("1.1", -3), 0.0011);
  EXPECT_EQ(ParseNumber("1.1e2", -3), 0.11);
  EXPECT_EQ(ParseNumber("+0.7", 3), 700);
}

TEST(ParseNumber, WithAPowerOfTenTakesTheSameTexts) {
  for (const char* text : {"", "nan", "inf", "1e", "1e400", "1e99999999999", "1e5e5", "mm"})
    EXPECT_FALSE(ParseNumber(text, -3)) << text;
  // Only together are they in range.
  EXPECT_EQ(ParseNumber("1e310", -10), 1e300);
}

TEST(FormatNumber, TakesTheFewestDigitsThatReadBack) {
  EXPECT_EQ(FormatNumber(31.42), "31.42");
  EXPECT_EQ(FormatNumber(0.1), "0.1");
  EXPECT_EQ(FormatNumber(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(FormatNumber(-2), "-2");
  EXPECT_EQ(FormatNumber(0), "0");
}

TEST(FormatNumber, IsPlainWhileAPersonCanTakeItIn) {
  EXPECT_EQ(FormatNumber(123456789012), "123456789012");
  EXPECT_EQ(FormatNumber(1234567890123), "1.234567890123e12");
  EXPECT_EQ(FormatNumber(0.000012), "0.000012");
  EXPECT_EQ(FormatNumber(0.0000012), "1.2e-6");
  EXPECT_EQ(FormatNumber(1e-7), "1e-7");
}

TEST(FormatNumber, AppliesAPowerOfTen) {
  EXPECT_EQ(FormatNumber(0.0011, 3), "1.1");
  EXPECT_EQ(FormatNumber(31420, -3), "31.42");
}

TEST(FormatNumber, ReadsBackToTheSameDouble) {
  const double extremes[] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(), -1.0 / 3, 2e22 / 3};
  for (const double value : extremes) EXPECT_EQ(ParseNumber(FormatNumber(value)), value) << value;
  for (const double value : {-1.0 / 3, 2e22 / 3, 1e-9 / 7})
    for (const int power : {-6, -3, -2, 3, 6}) EXPECT_EQ(ParseNumber(FormatNumber(value, power), -power), value);
}

TEST(FormatNumber, NamesWhatIsNotFinite) {
  EXPECT_EQ(FormatNumber(kNan), "nan");
  EXPECT_EQ(FormatNumber(-kInfinity), "-inf");
}

}  // namespace
}  // namespace fourpost::number_test
