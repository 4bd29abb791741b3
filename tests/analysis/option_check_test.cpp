#include "analysis/option_check.h"

#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost {
namespace {

using testing::StrEq;
using testing::Throws;
using testing::ThrowsMessage;

TEST(OptionCheck, SaysNothingOfAGoodValue) { EXPECT_NO_THROW(RequireOption(true, "factor", 0.5, "in (0, 2]")); }

TEST(OptionCheck, NamesFieldValueAndBound) {
  EXPECT_THAT([] { RequireOption(false, "factor", 2.5, "in (0, 2]"); },
              ThrowsMessage<std::invalid_argument>(StrEq("factor = 2.5, must be in (0, 2]")));
}

TEST(OptionCheck, RefusesNanWhenTheConditionIsWrittenForIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { RequireOption(nan > 0, "factor", nan, "positive"); }, Throws<std::invalid_argument>());
}

}  // namespace
}  // namespace fourpost
