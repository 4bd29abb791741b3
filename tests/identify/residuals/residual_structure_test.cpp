#include "identify/residuals/residual_structure.h"

#include <gmock/gmock.h>

#include "identify/residuals/residual_block.h"

namespace fourpost::residual_structure_test {
namespace {

using testing::ElementsAre;

TEST(ResidualStructure, JoinsPartitionsOfOneNameAndMakesAClusterOfABlockWithout) {
  ResidualBlock sines = {.name = "sines", .count = 3};
  sines.structure.partitions = {{"groups", {}, {}}, {"octaves", {}, {}}};
  sines.structure.partitions[0].Add("struts", 2);
  sines.structure.partitions[0].Add("forces", 1);
  sines.structure.partitions[1].Add("1 .. 2 Hz", 3);
  sines.structure.series = {{.first = 0, .count = 3, .step = 1, .is_over_time = true, .record = 0}};
  const ResidualBlock loads = {.name = "loads", .count = 2};
  ResidualBlock later = {.name = "later", .count = 1};
  later.structure.partitions = {{"groups", {}, {}}};
  later.structure.partitions[0].Add("forces", 1);
  later.structure.recordings.Add("sweep", 1);
  later.structure.series = {{.first = 0, .count = 1, .step = 1, .is_over_time = true, .record = 0}};

  const ResidualStructure whole = JoinedStructure({sines, loads, later});

  ASSERT_EQ(whole.partitions.size(), 2U);
  EXPECT_THAT(whole.partitions[0].clusters, ElementsAre("struts", "forces", "loads"));
  EXPECT_THAT(whole.partitions[0].cluster_of, ElementsAre(0, 0, 1, 2, 2, 1));
  EXPECT_THAT(whole.partitions[1].clusters, ElementsAre("1 .. 2 Hz", "loads", "later"));
  EXPECT_THAT(whole.partitions[1].cluster_of, ElementsAre(0, 0, 0, 1, 1, 2));
  EXPECT_THAT(whole.recordings.clusters, ElementsAre("sines", "loads", "sweep"));
  EXPECT_THAT(whole.recordings.cluster_of, ElementsAre(0, 0, 0, 1, 1, 2));
  ASSERT_EQ(whole.series.size(), 2U);
  EXPECT_EQ(whole.series[1].first, 5);
  EXPECT_NE(whole.series[1].record, whole.series[0].record);
}

}  // namespace
}  // namespace fourpost::residual_structure_test
