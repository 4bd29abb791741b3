#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "identify/search/archive.h"
#include "identify/search/stop_rules.h"

namespace fourpost {

/// Leaves the loop of a peer; PeerObjective::end() tells whether for good.
struct PeerStop {};

/// How a peer meets the lattice and when it starts anew.
struct PeerRules {
  /// Requests without a better cost after which the peer starts anew.
  std::int64_t patience = 1000;
  /// Axes that are positive and not discrete are spaced by ratios.
  bool logarithmic = false;
};

/// The lattice point of the cell that a point of the unit cube lies in, all cells of an axis alike in size, or for
/// logarithmic axes in ratio; what leaves the cube goes to its bound.
/// Throws std::invalid_argument for NaN or a wrong number of coordinates.
LatticePoint PointInCube(const Lattice& lattice, std::span<const double> unit, bool logarithmic);

/// What a peer is told: the cost, or for a failure 1e100 and more, the more the constraints are violated, and 1e101
/// where nobody says by how much. Never infinite nor NaN, which some peers keep for ever. Peers that compare costs and
/// do no arithmetic with them thus rank as IsBetter() does.
double PeerCost(const Score& score);

/// A problem as the peers' libraries want it: a cost on the unit cube. Points are rounded to the lattice and go through
/// the archive, so that only distinct ones are paid for. Throws PeerStop when a rule ends the search, and when the
/// peer's patience does. Of the rules, target, evaluations and time hold as they do for our methods; generations,
/// stagnation and collapse are a peer's own affair; nothing new are `max_free_generations` of 20 requests.
class PeerObjective {
 public:
  /// Everything must outlive it.
  PeerObjective(Archive& archive, const StopRules& rules, const PeerRules& peer, const std::function<bool()>& stop);

  /// Coordinates of a point.
  std::size_t size() const { return archive_.lattice().size(); }

  /// The cost for the peer. Throws PeerStop, and std::invalid_argument as PointInCube().
  double operator()(std::span<const double> unit);

  /// Forgets the best cost, not the archive.
  void StartAnew();

  /// Requests of all starts.
  std::int64_t requests() const { return requests_; }
  /// Which rule ended the search; kNotRun while none has.
  SearchEnd end() const { return end_; }

 private:
  using Clock = std::chrono::steady_clock;

  [[noreturn]] void End(SearchEnd end);
  void EndBefore(const LatticePoint& point);
  void EndAfter(const Score& score);
  void CountGain(double cost);

  Archive& archive_;
  const StopRules& rules_;
  const PeerRules& peer_;
  const std::function<bool()>& stop_;
  const std::int64_t paid_before_;
  const Clock::time_point start_ = Clock::now();
  SearchEnd end_ = SearchEnd::kNotRun;
  std::int64_t requests_ = 0;
  // In a row.
  std::int64_t free_requests_ = 0;
  std::int64_t without_gain_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace fourpost
