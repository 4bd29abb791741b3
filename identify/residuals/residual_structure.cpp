#include "identify/residuals/residual_structure.h"

#include <algorithm>
#include <cstddef>

#include "identify/residuals/residual_block.h"

namespace fourpost {
namespace {

const ResidualPartition* PartitionNamed(const std::vector<ResidualPartition>& partitions, const std::string& name) {
  const auto found = std::find_if(partitions.begin(), partitions.end(),
                                  [&](const ResidualPartition& partition) { return partition.name == name; });
  return found == partitions.end() ? nullptr : &*found;
}

void AddBlock(const ResidualBlock& block, const ResidualPartition* part, ResidualPartition& whole) {
  if (part == nullptr || part->cluster_of.empty()) return whole.Add(block.name, block.count);
  for (const std::size_t cluster : part->cluster_of) whole.Add(part->clusters[cluster], 1);
}

Eigen::MatrixXd JoinedColumns(const std::vector<ResidualBlock>& blocks) {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
  for (const ResidualBlock& block : blocks) {
    rows += block.count;
    columns += block.structure.absorbed.cols();
  }
  Eigen::MatrixXd joined = Eigen::MatrixXd::Zero(rows, columns);
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  for (const ResidualBlock& block : blocks) {
    const Eigen::MatrixXd& part = block.structure.absorbed;
    joined.block(row, column, part.rows(), part.cols()) = part;
    row += block.count;
    column += part.cols();
  }
  return joined;
}

}  // namespace

void ResidualPartition::Add(const std::string& cluster, Eigen::Index count) {
  const auto found = std::find(clusters.begin(), clusters.end(), cluster);
  const auto place = static_cast<std::size_t>(found - clusters.begin());
  if (found == clusters.end()) clusters.push_back(cluster);
  cluster_of.insert(cluster_of.end(), static_cast<std::size_t>(count), place);
}

ResidualStructure JoinedStructure(const std::vector<ResidualBlock>& blocks) {
  ResidualStructure whole;
  whole.absorbed = JoinedColumns(blocks);
  Eigen::Index first = 0;
  int record = 0;
  for (const ResidualBlock& block : blocks) {
    int last_record = record;
    for (ResidualSeries series : block.structure.series) {
      series.first += first;
      series.record += record;
      last_record = std::max(last_record, series.record);
      whole.series.push_back(series);
    }
    for (const ResidualPartition& partition : block.structure.partitions)
      if (PartitionNamed(whole.partitions, partition.name) == nullptr)
        whole.partitions.push_back({partition.name, {}, {}});
    first += block.count;
    record = last_record + 1;
  }
  for (const ResidualBlock& block : blocks) {
    AddBlock(block, &block.structure.recordings, whole.recordings);
    for (ResidualPartition& partition : whole.partitions)
      AddBlock(block, PartitionNamed(block.structure.partitions, partition.name), partition);
  }
  return whole;
}

}  // namespace fourpost
