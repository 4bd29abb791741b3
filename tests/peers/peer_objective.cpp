#include "tests/peers/peer_objective.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fourpost {
namespace {

std::int64_t CellIndex(const LatticeAxis& axis, std::int64_t count, double unit, bool logarithmic) {
  const double last = static_cast<double>(count - 1);
  if (logarithmic && axis.lower > 0 && !axis.discrete) {
    const double value = axis.lower * std::pow(axis.upper / axis.lower, unit);
    return static_cast<std::int64_t>(std::clamp(std::round((value - axis.lower) / axis.precision), 0.0, last)) + 1;
  }
  return static_cast<std::int64_t>(std::min(std::floor(unit * static_cast<double>(count)), last)) + 1;
}

}  // namespace

LatticePoint PointInCube(const Lattice& lattice, std::span<const double> unit, bool logarithmic) {
  if (unit.size() != lattice.size()) throw std::invalid_argument("a peer asked for a point of another problem");
  LatticePoint point(lattice.size());
  for (std::size_t j = 0; j < lattice.size(); ++j) {
    if (std::isnan(unit[j])) throw std::invalid_argument("a peer asked for NaN");
    point[j] = CellIndex(lattice.axes()[j], lattice.count(j), std::clamp(unit[j], 0.0, 1.0), logarithmic);
  }
  return point;
}

double PeerCost(const Score& score) {
  if (score.ok()) return score.cost;
  if (score.violation > 0) return 1e100 * (1 + score.violation / (1 + score.violation));
  return 1e101;
}

PeerObjective::PeerObjective(Archive& archive, const StopRules& rules, const PeerRules& peer,
                             const std::function<bool()>& stop)
    : archive_(archive), rules_(rules), peer_(peer), stop_(stop), paid_before_(archive.counts().paid) {}

double PeerObjective::operator()(std::span<const double> unit) {
  const LatticePoint point = PointInCube(archive_.lattice(), unit, peer_.logarithmic);
  EndBefore(point);
  ++requests_;
  const Score score = archive_.Evaluate({point}).front();
  EndAfter(score);
  const double cost = PeerCost(score);
  CountGain(cost);
  return cost;
}

void PeerObjective::StartAnew() {
  best_ = std::numeric_limits<double>::infinity();
  without_gain_ = 0;
}

void PeerObjective::End(SearchEnd end) {
  end_ = end;
  throw PeerStop{};
}

void PeerObjective::EndBefore(const LatticePoint& point) {
  if (stop_ && stop_()) End(SearchEnd::kStopped);
  if (std::chrono::duration<double>(Clock::now() - start_).count() >= rules_.max_seconds) End(SearchEnd::kOutOfTime);
  free_requests_ = archive_.Find(point) ? free_requests_ + 1 : 0;
  if (free_requests_ >= 20 * static_cast<std::int64_t>(rules_.max_free_generations)) End(SearchEnd::kNothingNew);
  const bool spent = archive_.counts().paid - paid_before_ >= rules_.max_evaluations;
  if (spent && free_requests_ == 0) End(SearchEnd::kEvaluations);
}

void PeerObjective::EndAfter(const Score& score) {
  if (score.ok() && rules_.target_cost && score.cost <= *rules_.target_cost) End(SearchEnd::kTarget);
}

void PeerObjective::CountGain(double cost) {
  if (cost < best_) {
    best_ = cost;
    without_gain_ = 0;
  } else if (++without_gain_ >= peer_.patience) {
    throw PeerStop{};
  }
}

}  // namespace fourpost
