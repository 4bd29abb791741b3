#include "identify/missing_force/force_explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "identify/missing_force/weighed_forces.h"

namespace fourpost {
namespace {

using Kind = ForceMechanism::Kind;

constexpr std::size_t kMostExplanations = 3;
/// Standard deviations below which nothing is named; as in an audit.
constexpr double kSuspicious = 4.5;
/// Scores that differ by less, or by this share, do not separate mechanisms.
constexpr double kApart = 9;
constexpr double kShareApart = 0.1;
/// Of what noise does not explain, below which an explanation is none.
constexpr double kLeastShare = 0.1;

/// The best of its shape, by steps that shrink.
TriedForce Refined(WeighedForces& forces, TriedForce best) {
  if (best.mechanism.ShapeNumbers() == 0) return best;
  constexpr int kRounds = 40;
  double frequency_step = 1.15;
  double ratio_step = 1.7;
  double place_step = 0.3;
  for (int round = 0; round < kRounds; ++round) {
    bool is_better = false;
    const auto consider = [&](const ForceMechanism& changed) {
      const TriedForce tried = forces.Try(changed);
      if (!(tried.fall > best.fall)) return;
      best = tried;
      is_better = true;
    };
    for (const int sign : {-1, 1}) {
      ForceMechanism changed = best.mechanism;
      changed.frequency_Hz *= std::pow(frequency_step, sign);
      consider(changed);
      changed = best.mechanism;
      changed.damping_ratio *= std::pow(ratio_step, sign);
      consider(changed);
      changed = best.mechanism;
      changed.place_m += sign * place_step;
      consider(changed);
    }
    if (is_better) continue;
    frequency_step = std::sqrt(frequency_step);
    ratio_step = std::sqrt(ratio_step);
    place_step /= 2;
  }
  return best;
}

bool IsSamePlace(const ForceMechanism& a, const ForceMechanism& b) {
  return a.kind == b.kind && a.lines == b.lines && a.link == b.link;
}

/// Of each kind and place the best, the best of all first.
std::vector<TriedForce> BestOfEach(WeighedForces& forces, const std::vector<ForceMechanism>& all,
                                   const std::vector<ForceExplanation>& before) {
  std::vector<TriedForce> best;
  for (const ForceMechanism& mechanism : all) {
    if (std::any_of(before.begin(), before.end(),
                    [&](const ForceExplanation& one) { return IsSamePlace(one.mechanism, mechanism); }))
      continue;
    const TriedForce tried = forces.Try(mechanism);
    const auto same = std::find_if(best.begin(), best.end(),
                                   [&](const TriedForce& other) { return IsSamePlace(other.mechanism, mechanism); });
    if (same == best.end()) best.push_back(tried);
    else if (tried.fall > same->fall) *same = tried;
  }
  for (TriedForce& one : best)
    if (one.fall > 0) one = Refined(forces, one);
  std::stable_sort(best.begin(), best.end(), [](const TriedForce& a, const TriedForce& b) { return a.fall > b.fall; });
  return best;
}

/// Nine tenths of the fall lie between them.
std::pair<double, double> BandOf(const ForceRecord& record, const std::vector<double>& falls) {
  constexpr double kTail = 0.05;
  std::vector<std::pair<double, double>> by_frequency;
  double whole = 0;
  for (std::size_t i = 0; i < falls.size(); ++i) {
    by_frequency.emplace_back(record.samples[i].frequency_Hz, std::max(0.0, falls[i]));
    whole += by_frequency.back().second;
  }
  std::sort(by_frequency.begin(), by_frequency.end());
  double below = 0;
  std::pair<double, double> band(by_frequency.front().first, by_frequency.back().first);
  bool is_inside = false;
  for (const auto& [frequency, fall] : by_frequency) {
    below += fall;
    if (!is_inside && below > kTail * whole) {
      band.first = frequency;
      is_inside = true;
    }
    if (below >= (1 - kTail) * whole) {
      band.second = frequency;
      break;
    }
  }
  return band;
}

/// Largest force of an explanation in its band.
double MostOf(const ForceRecord& record, const ForceExplanation& one) {
  double most = 0;
  for (const ForceSample& sample : record.samples) {
    if (sample.frequency_Hz < one.lower_Hz || sample.frequency_Hz > one.upper_Hz) continue;
    const Eigen::VectorXcd force = one.amount * ForceOf(one.mechanism, record, sample);
    double here = force.cwiseAbs().maxCoeff();
    for (const std::size_t line : one.mechanism.lines)
      here = force.norm() / record.lines[line].direction.norm() / std::sqrt(double(one.mechanism.lines.size()));
    most = std::max(most, here);
  }
  return most;
}

/// The next explanation; nothing where what is left is within noise, or no mechanism explains it.
std::optional<ForceExplanation> Next(const ForceRecord& record, WeighedForces& forces,
                                     const std::vector<ForceMechanism>& all,
                                     const std::vector<ForceExplanation>& before, double excess) {
  const std::vector<TriedForce> best = BestOfEach(forces, all, before);
  if (best.empty() || !(best.front().fall > 0)) return std::nullopt;
  const TriedForce& first = best.front();
  const double left = forces.Squares() - first.fall;
  const double noise = std::max(1.0, left / forces.degrees()) * forces.Correlated(first);
  ForceExplanation found{.mechanism = first.mechanism, .amount = first.amount, .score = first.fall / noise};
  found.share = first.fall / std::max(first.fall, excess);
  if (!(found.score > kSuspicious * kSuspicious) || found.share < kLeastShare) return std::nullopt;
  for (std::size_t i = 1; i < best.size(); ++i)
    if (found.score - best[i].fall / noise < std::max(kApart, kShareApart * found.score))
      found.rivals.push_back(best[i].mechanism);
  found.sd = std::sqrt(noise / first.information);
  std::tie(found.lower_Hz, found.upper_Hz) = BandOf(record, forces.FallBySample(first));
  found.most_N = MostOf(record, found);
  return found;
}

}  // namespace

ForceExplanations ExplainForce(const ForceRecord& record) {
  ForceExplanations explanations{.found = {}, .misfit = std::numeric_limits<double>::quiet_NaN()};
  if (record.samples.empty()) return explanations;
  WeighedForces forces(record);
  if (!(forces.degrees() > 0)) return explanations;
  explanations.misfit = std::sqrt(std::max(0.0, forces.Squares() / forces.degrees()));
  std::vector<ForceMechanism> all = PossibleMechanisms(record);
  std::erase_if(all, [&](const ForceMechanism& one) { return forces.IsFree(one); });
  const double excess = forces.Squares() - forces.degrees();
  while (explanations.found.size() < kMostExplanations) {
    const std::optional<ForceExplanation> next = Next(record, forces, all, explanations.found, excess);
    if (!next) break;
    explanations.found.push_back(*next);
    forces.TakeOut(next->mechanism);
  }
  if (explanations.found.size() < 2) return explanations;
  const auto [amounts, covariance] = forces.Amounts();
  const double noise = std::max(1.0, forces.Squares() / forces.degrees());
  for (std::size_t i = 0; i < explanations.found.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    explanations.found[i].amount = amounts[j];
    explanations.found[i].sd = std::sqrt(noise * covariance(j, j));
  }
  // Beside the others one may no longer be there.
  std::erase_if(explanations.found,
                [&](const ForceExplanation& one) { return !one.mechanism.Allows(one.amount, record); });
  return explanations;
}

}  // namespace fourpost
