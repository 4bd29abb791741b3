#include "analysis/deadline.h"

#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace fourpost {
namespace {

TEST(Deadline, PassesInItsTime) {
  const Deadline deadline = Deadline::In(0.02);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NO_THROW(Deadline::In(60).Check());
  while (!deadline.HasPassed()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(19));
  EXPECT_THROW(deadline.Check(), TimedOut);
}

TEST(Deadline, NeverPassesUnlessTold) {
  EXPECT_FALSE(Deadline().HasPassed());
  EXPECT_FALSE(Deadline::In(std::numeric_limits<double>::infinity()).HasPassed());
  EXPECT_FALSE(Deadline::In(1e300).HasPassed());
}

TEST(Deadline, RefusesTheNoTimeAndTheNotANumber) {
  EXPECT_THROW(Deadline::In(0), std::invalid_argument);
  EXPECT_THROW(Deadline::In(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost
