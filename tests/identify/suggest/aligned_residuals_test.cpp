#include "identify/suggest/aligned_residuals.h"

#include <gtest/gtest.h>

namespace fourpost::aligned_residuals_test {
namespace {

using Eigen::VectorXd;

/// Two channels of one record, then a prior.
ResidualStructure TwoChannels(Eigen::Index count, double start_s) {
  ResidualStructure structure;
  for (const Eigen::Index first : {Eigen::Index(0), count})
    structure.series.push_back(
        {.first = first, .count = count, .is_over_time = true, .start_s = start_s, .interval_s = 0.01});
  return structure;
}

const VectorXd kKnown = (VectorXd(9) << 1, 2, 3, 4, 5, 6, 7, 8, 9).finished();

TEST(AlignedResiduals, KeepWhatIsKnownWhereARecordEndsEarlier) {
  const VectorXd shorter = (VectorXd(7) << 10, 20, 30, 50, 60, 70, 90).finished();
  const auto aligned = AlignedTo({kKnown, TwoChannels(4, 2)}, {shorter, TwoChannels(3, 2)});
  ASSERT_TRUE(aligned);
  EXPECT_EQ(*aligned, (VectorXd(9) << 10, 20, 30, 4, 50, 60, 70, 8, 90).finished());
}

TEST(AlignedResiduals, StandAtTheirTimesWhereARecordBeginsLater) {
  const VectorXd shorter = (VectorXd(7) << 20, 30, 40, 60, 70, 80, 90).finished();
  const auto aligned = AlignedTo({kKnown, TwoChannels(4, 2)}, {shorter, TwoChannels(3, 2.01)});
  ASSERT_TRUE(aligned);
  EXPECT_EQ(*aligned, (VectorXd(9) << 1, 20, 30, 40, 5, 60, 70, 80, 90).finished());
}

TEST(AlignedResiduals, AreNoneOfOtherChannels) {
  ResidualStructure one = TwoChannels(4, 2);
  one.series.pop_back();
  const VectorXd fewer = VectorXd::Zero(5);
  EXPECT_FALSE(AlignedTo({kKnown, TwoChannels(4, 2)}, {fewer, one}));
}

}  // namespace
}  // namespace fourpost::aligned_residuals_test
