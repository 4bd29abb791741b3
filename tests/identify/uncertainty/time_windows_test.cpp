#include "identify/uncertainty/time_windows.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace fourpost::time_windows_test {
namespace {

using ::testing::ElementsAre;

constexpr Eigen::Index kSamples = 100;

/// Two channels of each recording, at 100 Hz from 2 s on.
ResidualStructure Structure(int recordings) {
  ResidualStructure structure;
  for (int r = 0; r < recordings; ++r) {
    structure.recordings.Add("run " + std::to_string(r + 1), 2 * kSamples);
    for (Eigen::Index c = 0; c < 2; ++c)
      structure.series.push_back({.first = (2 * r + c) * kSamples,
                                  .count = kSamples,
                                  .step = 1,
                                  .is_over_time = true,
                                  .record = r,
                                  .start_s = 2,
                                  .interval_s = 0.01});
  }
  return structure;
}

TEST(TimeWindows, SayEquallyMuchEach) {
  const ResidualPartition even = WindowsOfTime(Structure(1), Eigen::VectorXd::Ones(2 * kSamples));
  EXPECT_THAT(even.clusters, ElementsAre("2 to 2.2 s", "2.2 to 2.4 s", "2.4 to 2.6 s", "2.6 to 2.8 s", "2.8 to 3 s"));
  // Nine tenths of all in the first ten samples.
  Eigen::VectorXd leverage = Eigen::VectorXd::Constant(2 * kSamples, 1.0 / 9);
  leverage.head(10).setConstant(9);
  leverage.segment(kSamples, 10).setConstant(9);
  const ResidualPartition early = WindowsOfTime(Structure(1), leverage);
  // 18 a sample of 200 in all: 40, 80, 120 and 160 are passed by samples 3, 5, 7 and 9.
  EXPECT_THAT(early.clusters,
              ElementsAre("2 to 2.03 s", "2.03 to 2.05 s", "2.05 to 2.07 s", "2.07 to 2.09 s", "2.09 to 3 s"));
  // Both channels of a sample in one window.
  for (Eigen::Index k = 0; k < kSamples; ++k)
    EXPECT_EQ(early.cluster_of[static_cast<std::size_t>(k)], early.cluster_of[static_cast<std::size_t>(k + kSamples)]);
}

TEST(TimeWindows, LeaveManyRecordingsWholeAndCutFewOfThem) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(10 * kSamples);
  EXPECT_THAT(WindowsOfTime(Structure(5), ones).clusters, ElementsAre("run 1", "run 2", "run 3", "run 4", "run 5"));
  EXPECT_EQ(WindowsOfTime(Structure(2), ones.head(4 * kSamples)).clusters.size(), 6U);
}

TEST(TimeWindows, AreFewerWhereOneSampleSaysAll) {
  Eigen::VectorXd leverage = Eigen::VectorXd::Zero(2 * kSamples);
  leverage[50] = 1;
  const ResidualPartition parted = WindowsOfTime(Structure(1), leverage);
  EXPECT_EQ(parted.cluster_of.size(), static_cast<std::size_t>(2 * kSamples));
  EXPECT_LE(parted.clusters.size(), 3U);
}

}  // namespace
}  // namespace fourpost::time_windows_test
