#include "analysis/files/recording_summary.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "analysis/signals/random_stream.h"
#include "tests/temporary_folder.h"

namespace fourpost::recording_summary_test {
namespace {

/// A drop from 40 mm at 1.5 s, at 1 kHz over 8.5 s: a displacement, an acceleration, and one that drifts by 0.03 g.
RecordingSummary OfADrop(const std::filesystem::path& folder) {
  RandomStream random(1, "noise");
  std::ofstream file(folder / "drop.csv");
  file << "time (s),axle (mm),body acc (g),drifting acc (g)\n";
  for (int k = 0; k < 8500; ++k) {
    const double t_s = 1e-3 * k;
    const double swing = t_s < 1.5 ? 0 : std::exp(-5 * (t_s - 1.5)) * std::cos(15 * (t_s - 1.5));
    file << t_s << ',' << (t_s < 1.5 ? 40 : 40 * swing) + 0.05 * random.Normal() << ','
         << -0.5 * swing + 0.004 * random.Normal() << ',' << 0.02 * swing + 0.003 * random.Normal() + 0.03 * t_s / 8.5
         << '\n';
  }
  file.close();
  Diagnostics unheard;
  return Summarise(*ReadRecordedTable(folder / "drop.csv", unheard));
}

TEST(RecordingSummary, ADropIsNoDrift) {
  const TemporaryFolder folder;
  const RecordingSummary summary = OfADrop(folder.path());
  ASSERT_EQ(summary.releases.size(), 1u);
  EXPECT_DOUBLE_EQ(summary.releases[0].rest_from_s, 0);
  EXPECT_DOUBLE_EQ(summary.releases[0].let_go_s, 1.5);
  EXPECT_DOUBLE_EQ(summary.releases[0].end_s, 8.499);
  // Means over a second and more, and what is left of the swing: some noise.
  EXPECT_NEAR(summary.columns[0].above_rest.at(0), 40, 0.05);
  // 1.7 rms is what counts as a drift; a line through all of it rises by 2 rms.
  EXPECT_LT(std::abs(summary.columns[0].drift), 0.01 * summary.columns[0].rms);
  EXPECT_LT(std::abs(summary.columns[1].drift), 0.01);
  // Six deviations of a slope through n = 6000 samples at rest, noise sqrt(12 / n^3), times all samples.
  EXPECT_NEAR(summary.columns[2].drift, 0.03, 6 * 0.003 * std::sqrt(12 / std::pow(6000, 3)) * 8500);
}

}  // namespace
}  // namespace fourpost::recording_summary_test
