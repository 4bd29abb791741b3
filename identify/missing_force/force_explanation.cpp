#include "identify/missing_force/force_explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "identify/missing_force/joint_amounts.h"
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
/// Share of what noise does not explain, below which an explanation is none.
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

/// The best of each kind and place, the best of all first.
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

using BySample = std::vector<std::pair<double, double>>;

/// Sums of a number of each sample by frequency, over all recordings, in rising order.
BySample ByFrequency(const ForceRecord& record, const std::vector<double>& of_samples) {
  constexpr double kSame = 1e-3;
  BySample all;
  for (std::size_t i = 0; i < of_samples.size(); ++i) all.emplace_back(record.samples[i].frequency_Hz, of_samples[i]);
  std::sort(all.begin(), all.end());
  BySample joined;
  for (const auto& [frequency, number] : all)
    if (!joined.empty() && frequency < (1 + kSame) * joined.back().first) joined.back().second += number;
    else joined.emplace_back(frequency, number);
  return joined;
}

/// Frequency of the largest.
double PeakOf(const BySample& by_frequency) {
  return std::max_element(by_frequency.begin(), by_frequency.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Nine tenths of the sum lie between them; what is negative does not count.
std::pair<double, double> BandOf(const BySample& by_frequency) {
  constexpr double kTail = 0.05;
  double whole = 0;
  for (const auto& [frequency, number] : by_frequency) whole += std::max(0.0, number);
  double below = 0;
  std::pair<double, double> band(by_frequency.front().first, by_frequency.back().first);
  bool is_inside = false;
  for (const auto& [frequency, number] : by_frequency) {
    below += std::max(0.0, number);
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

constexpr double kLeastScore = kSuspicious * kSuspicious;

/// By how much chance would let it fall: widened where what is left is correlated or exceeds noise.
double NoiseOf(WeighedForces& forces, const TriedForce& tried) {
  const double left = forces.Squares() - tried.fall;
  return std::max(1.0, left / forces.degrees()) * forces.Correlated(tried);
}

/// The same record without one frequency, for whether a mechanism rests on that alone.
class WithoutOne {
 public:
  WithoutOne(const ForceRecord& record, const std::vector<ForceExplanation>& before)
      : record_(record), before_(before) {}

  /// Whether it is beyond noise without the frequency that speaks for it most.
  bool Stands(WeighedForces& forces, const TriedForce& tried) {
    WeighedForces& others = Without(PeakOf(ByFrequency(record_, forces.FallBySample(tried)))).forces;
    if (!(others.degrees() > 0)) return false;
    const TriedForce again = others.Try(tried.mechanism);
    return again.fall > kLeastScore * NoiseOf(others, again);
  }

 private:
  struct Rest {
    ForceRecord record;
    WeighedForces forces;
    explicit Rest(ForceRecord of) : record(std::move(of)), forces(record) {}
  };

  Rest& Without(double frequency) {
    std::unique_ptr<Rest>& rest = rests_[frequency];
    if (rest) return *rest;
    constexpr double kSame = 1e-3;
    ForceRecord record = record_;
    std::erase_if(record.samples, [&](const ForceSample& sample) {
      return std::abs(sample.frequency_Hz - frequency) < kSame * frequency;
    });
    rest = std::make_unique<Rest>(std::move(record));
    for (const ForceExplanation& one : before_) rest->forces.TakeOut(one.mechanism);
    return *rest;
  }

  const ForceRecord& record_;
  const std::vector<ForceExplanation>& before_;
  std::map<double, std::unique_ptr<Rest>> rests_;
};

/// The next explanation; nothing where what is left is within noise, or no mechanism explains it.
std::optional<ForceExplanation> Next(const ForceRecord& record, WeighedForces& forces,
                                     const std::vector<ForceMechanism>& all,
                                     const std::vector<ForceExplanation>& before, double excess) {
  std::vector<TriedForce> best = BestOfEach(forces, all, before);
  std::erase_if(best, [&](const TriedForce& tried) {
    return !(tried.fall / std::max(tried.fall, excess) >= kLeastShare) ||
           !(tried.fall > kLeastScore * NoiseOf(forces, tried));
  });
  WithoutOne others(record, before);
  const auto named =
      std::find_if(best.begin(), best.end(), [&](const TriedForce& tried) { return others.Stands(forces, tried); });
  if (named == best.end()) return std::nullopt;
  const TriedForce& first = *named;
  const double noise = NoiseOf(forces, first);
  ForceExplanation found{.mechanism = first.mechanism, .amount = first.amount, .score = first.fall / noise};
  found.share = first.fall / std::max(first.fall, excess);
  for (auto other = named + 1; other != best.end(); ++other)
    if (found.score - other->fall / noise < std::max(kApart, kShareApart * found.score))
      found.rivals.push_back(other->mechanism);
  found.sd = std::sqrt(noise / first.information);
  std::tie(found.lower_Hz, found.upper_Hz) = BandOf(ByFrequency(record, forces.FallBySample(first)));
  found.most_N = MostOf(record, found);
  return found;
}

/// Where it is beyond noise.
std::optional<UnexplainedForce> LeftOf(const ForceRecord& record, const WeighedForces& forces) {
  constexpr double kBeyondNoise = 1.5;
  if (!(std::sqrt(std::max(0.0, forces.Squares() / forces.degrees())) > kBeyondNoise)) return std::nullopt;
  const BySample squares = ByFrequency(record, forces.SquaresBySample());
  UnexplainedForce left{.frequency_Hz = PeakOf(squares)};
  std::tie(left.lower_Hz, left.upper_Hz) = BandOf(squares);
  return left;
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
  explanations.left = explanations.found.size() > 1 ? LeftOf(record, EstimateTogether(record, explanations.found))
                                                    : LeftOf(record, forces);
  return explanations;
}

}  // namespace fourpost
