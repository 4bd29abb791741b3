#include "analysis/text/option_check.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/rounding.h"

namespace fourpost::option_check_test {
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
  EXPECT_THAT([] { RequireOption(kNan > 0, "factor", kNan, "positive"); }, Throws<std::invalid_argument>());
}

}  // namespace
}  // namespace fourpost::option_check_test
