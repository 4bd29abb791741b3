#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost {

/// A way to part residuals into clusters: by groups of sensors, by octaves, ... A model that lacks something fits no
/// two of them by the same parameters, see EstimateModelError().
struct ResidualPartition {
  std::string name;
  std::vector<std::string> clusters;
  /// Of each residual, in their order: place in `clusters`.
  std::vector<std::size_t> cluster_of;

  /// The next `count` residuals belong to this cluster, which is made when it is new.
  void Add(const std::string& cluster, Eigen::Index count);
};

/// Residuals that follow one another: number first, first + step, ...
struct ResidualSeries {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
  Eigen::Index step = 1;
  /// At equal intervals of time, so that noise may be correlated; else one per frequency.
  bool is_over_time = false;
  /// Series over time of one record were measured at once: their noise may have common causes.
  int record = 0;
  /// Time of the first, and from one to the next; where is_over_time.
  double start_s = 0;
  double interval_s = 0;
  /// Of `count`, those that are 0 whatever the vehicle: samples that were not measured. They say nothing.
  Eigen::Index unmeasured = 0;

  Eigen::Index measured() const { return count - unmeasured; }
};

/// How the residuals of a block, or of several, belong together. Residuals outside all series are independent.
struct ResidualStructure {
  std::vector<ResidualPartition> partitions;
  /// Clusters are recordings.
  ResidualPartition recordings = {"recordings", {}, {}};
  std::vector<ResidualSeries> series;
  /// What a block fits along with the parameters, such as the state at the start of a record: columns, a row for each
  /// residual; no rows: nothing.
  Eigen::MatrixXd absorbed = {};
};

struct ResidualBlock;

/// Of blocks one after the other: partitions of one name become one. A block that is not parted in a way is a cluster
/// of its own there, by its name.
ResidualStructure JoinedStructure(const std::vector<ResidualBlock>& blocks);

}  // namespace fourpost
