#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fourpost::api {

/// One variable of a search: lower, lower + precision, ... up to upper.
struct Axis {
  std::string name;
  double lower = 0;
  double upper = 0;
  double precision = 0;
  /// Nothing lies between its values: a number of teeth, a place in a catalogue.
  bool is_discrete = false;
};

struct SearchOptions {
  /// As `fourpost compare --methods`.
  std::string method = "dvhde";
  std::uint64_t seed = 1;
  std::int64_t evaluations = 10000;
  /// Ends the search where the cost is as low.
  std::optional<double> target = {};
  /// 0: one per processor. No influence on the result.
  int threads = 1;
  /// True ends the search with what it has; asked before each batch of evaluations, from the calling thread.
  std::function<bool()> stop = {};
};

struct Minimum {
  /// In the order of the axes.
  Eigen::VectorXd values;
  double cost = 0;
  /// Distinct points that were evaluated.
  std::int64_t evaluations = 0;
  /// Which rule ended the search, with its numbers.
  std::string reason;
};

/// Residuals at values in the order of the axes; their squares are summed. Called from `threads` threads at once; what
/// it throws, NaN and infinity count as a failed evaluation.
using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& values)>;

/// Finds the values of least cost. Throws Error (codes `search-axes`, `search-method`), and of kSimulation where every
/// evaluation fails.
Minimum Minimise(const std::vector<Axis>& axes, const Residuals& residuals, const SearchOptions& options = {});

}  // namespace fourpost::api
