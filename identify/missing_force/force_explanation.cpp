#include "identify/missing_force/force_explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Kind = ForceMechanism::Kind;

constexpr std::size_t kMostExplanations = 3;
/// Standard deviations below which nothing is named; as in an audit.
constexpr double kSuspicious = 4.5;
/// Of the fall of squares, for each number that is chosen beside the amount.
constexpr double kPerNumber = 9;
/// Scores that differ by less, or by this share, do not separate mechanisms.
constexpr double kApart = 9;
constexpr double kShareApart = 0.1;
/// Of what noise does not explain, below which an explanation is none.
constexpr double kLeastShare = 0.1;

struct Tried {
  ForceMechanism mechanism;
  double amount = 0;
  double information = 0;
  /// Less kPerNumber for each number.
  double fall = 0;
};

/// Forces as vectors over all samples, each entry over its noise, and products of them in which what parameters and the
/// rig may be off by counts as noise: a . b = a' C^-1 b, C = I + N N'.
class WeighedForces {
 public:
  explicit WeighedForces(const ForceRecord& record) : record_(record) {
    Eigen::Index rows = 0;
    for (const ForceSample& sample : record.samples) rows += 2 * sample.motion.size();
    rest_.resize(rows);
    Eigen::MatrixXd nuisances(rows, record.samples.empty() ? 0 : record.samples.front().nuisance.cols());
    Eigen::Index next = 0;
    for (const ForceSample& sample : record.samples) {
      weights_.push_back(WeightOf(sample));
      const Eigen::Index count = weights_.back().rows();
      rest_.segment(next, count) = weights_.back() * Stacked(sample.force);
      nuisances.middleRows(next, count) = weights_.back() * sample.nuisance;
      degrees_ += 2 * (MotionCovariance(sample) * sample.information).trace();
      next += count;
    }
    FindFree();
    // C^-1 = I - B B' with B = N (I + N' N)^-1/2.
    const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(nuisances.transpose() * nuisances);
    const Eigen::VectorXd roots = (1 + pairs.values.array().max(0)).rsqrt();
    shared_ = nuisances * (pairs.vectors * roots.asDiagonal());
    degrees_ -= shared_.squaredNorm();
    whole_ = rest_;
  }

  double degrees() const { return degrees_; }
  double Squares() const { return Product(rest_, rest_); }

  Eigen::VectorXd Weighed(const ForceMechanism& mechanism) const {
    Eigen::VectorXd all(rest_.size());
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const Eigen::Index count = weights_[i].rows();
      all.segment(next, count) = weights_[i] * Stacked(ForceOf(mechanism, record_, record_.samples[i]));
      next += count;
    }
    return all;
  }

  /// Whether free parameters can do the same in the model's own motion: then the fit has found how much of it there is.
  /// In the measured one they could multiply the whole force down to nothing together.
  bool IsFree(const ForceMechanism& mechanism) const {
    constexpr double kOwn = 1e-4;
    Eigen::VectorXd all = Eigen::VectorXd::Zero(rest_.size());
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      ForceSample own = record_.samples[i];
      own.motion = own.modelled;
      const Eigen::Index count = weights_[i].rows();
      if (own.motion.size() > 0) all.segment(next, count) = weights_[i] * Stacked(ForceOf(mechanism, record_, own));
      next += count;
    }
    return all.squaredNorm() - (free_.transpose() * all).squaredNorm() <= kOwn * all.squaredNorm();
  }

  /// How much of it lowers the squares that are left most.
  Tried Try(const ForceMechanism& mechanism) const {
    const Eigen::VectorXd force = Weighed(mechanism);
    Tried tried{.mechanism = mechanism};
    const double whole = Product(force, force);
    tried.information = whole;
    for (const Eigen::VectorXd& taken : directions_) tried.information -= std::pow(Product(force, taken), 2);
    // What rounding leaves of one that others can stand for.
    constexpr double kNothing = 1e-9;
    if (!(tried.information > kNothing * whole)) return tried;
    const double gradient = Product(force, rest_);
    tried.amount = gradient / tried.information;
    if (!mechanism.Allows(tried.amount, record_)) return tried;
    tried.fall = gradient * tried.amount - kPerNumber * mechanism.ShapeNumbers();
    return tried;
  }

  /// With all that was taken out before.
  void TakeOut(const ForceMechanism& mechanism) {
    forces_.push_back(Weighed(mechanism));
    Eigen::VectorXd direction = forces_.back();
    for (const Eigen::VectorXd& taken : directions_) direction -= Product(direction, taken) * taken;
    direction /= std::sqrt(Product(direction, direction));
    rest_ -= Product(direction, rest_) * direction;
    directions_.push_back(std::move(direction));
  }

  /// Amounts of all that were taken out, and their covariance where noise is as stated.
  std::pair<Eigen::VectorXd, Eigen::MatrixXd> Amounts() const {
    const auto count = static_cast<Eigen::Index>(forces_.size());
    Eigen::MatrixXd products(count, count);
    Eigen::VectorXd gradient(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      gradient[i] = Product(forces_[static_cast<std::size_t>(i)], whole_);
      for (Eigen::Index j = 0; j < count; ++j)
        products(i, j) = Product(forces_[static_cast<std::size_t>(i)], forces_[static_cast<std::size_t>(j)]);
    }
    const Eigen::MatrixXd covariance = Solved(products, Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count)));
    return {covariance * gradient, covariance};
  }

  /// Number of neighbouring frequencies whose rests count as one, (1 + r) / (1 - r) of their correlation r, once this
  /// much of a mechanism is taken out: rests of a model that lacks more are smooth.
  double Correlated(const Tried& tried) const {
    Eigen::VectorXd rest = rest_ - tried.amount * Weighed(tried.mechanism);
    rest -= shared_ * (shared_.transpose() * rest);
    double products = 0;
    double squares = 0;
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const Eigen::Index count = weights_[i].rows();
      squares += rest.segment(next, count).squaredNorm();
      if (i + 1 < weights_.size() && record_.samples[i].run == record_.samples[i + 1].run)
        products += rest.segment(next, count).dot(rest.segment(next + count, count));
      next += count;
    }
    constexpr double kMost = 0.95;
    const double correlation = squares > 0 ? std::clamp(products / squares, 0.0, kMost) : 0;
    return (1 + correlation) / (1 - correlation);
  }

  /// What each sample contributes to the fall of squares by a mechanism.
  std::vector<double> FallBySample(const Tried& tried) const {
    const Eigen::VectorXd force = tried.amount * Weighed(tried.mechanism);
    const Eigen::VectorXd inverse = force - shared_ * (shared_.transpose() * force);
    const Eigen::VectorXd of_rest = rest_ - shared_ * (shared_.transpose() * rest_);
    std::vector<double> falls;
    Eigen::Index next = 0;
    for (const Eigen::MatrixXd& weight : weights_) {
      const Eigen::Index count = weight.rows();
      falls.push_back(2 * force.segment(next, count).dot(of_rest.segment(next, count)) -
                      force.segment(next, count).dot(inverse.segment(next, count)));
      next += count;
    }
    return falls;
  }

 private:
  /// Orthonormal columns: all that changes of free parameters do to the force in the model's own motion.
  void FindFree() {
    const auto parameters = [](const ForceSample& sample) { return sample.by_parameters.cols(); };
    Eigen::Index count = 0;
    for (const ForceSample& sample : record_.samples) count = std::max(count, parameters(sample));
    Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(rest_.size(), count);
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const ForceSample& sample = record_.samples[i];
      if (parameters(sample) > 0) changes.middleRows(next, weights_[i].rows()) = weights_[i] * sample.by_parameters;
      next += weights_[i].rows();
    }
    for (auto change : changes.colwise())
      if (change.norm() > 0) change.normalize();
    const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(changes.transpose() * changes);
    constexpr double kNothing = 1e-10;
    const Eigen::Index kept = (pairs.values.array() > kNothing).count();
    free_ = changes * pairs.vectors.rightCols(kept) * pairs.values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
  }

  static Eigen::VectorXd Stacked(const Eigen::VectorXcd& force) {
    Eigen::VectorXd all(2 * force.size());
    all << force.real(), force.imag();
    return all;
  }

  /// To the motion that the force stands for, over its standard deviations.
  static Eigen::MatrixXd WeightOf(const ForceSample& sample) {
    const Eigen::Index n = sample.motion.size();
    const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(MotionCovariance(sample));
    const Eigen::MatrixXd root =
        pairs.vectors * pairs.values.cwiseInverse().cwiseSqrt().asDiagonal() * pairs.vectors.transpose();
    Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    both.topLeftCorner(n, n) = root;
    both.bottomRightCorner(n, n) = root;
    return both * LeastNorm(sample.slope).PseudoInverse();
  }

  double Product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return a.dot(b) - (shared_.transpose() * a).dot(shared_.transpose() * b);
  }

  const ForceRecord& record_;
  std::vector<Eigen::MatrixXd> weights_;
  Eigen::MatrixXd shared_;
  Eigen::MatrixXd free_;
  /// At first, and less what was taken out.
  Eigen::VectorXd whole_;
  Eigen::VectorXd rest_;
  std::vector<Eigen::VectorXd> forces_;
  /// Of what was taken out: of length 1, at right angles.
  std::vector<Eigen::VectorXd> directions_;
  double degrees_ = 0;
};

/// The best of its shape, by steps that shrink.
Tried Refined(const WeighedForces& forces, Tried best) {
  if (best.mechanism.ShapeNumbers() == 0) return best;
  constexpr int kRounds = 40;
  double frequency_step = 1.15;
  double ratio_step = 1.7;
  double place_step = 0.3;
  for (int round = 0; round < kRounds; ++round) {
    bool is_better = false;
    const auto consider = [&](const ForceMechanism& changed) {
      const Tried tried = forces.Try(changed);
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
std::vector<Tried> BestOfEach(const WeighedForces& forces, const std::vector<ForceMechanism>& all,
                              const std::vector<ForceExplanation>& before) {
  std::vector<Tried> best;
  for (const ForceMechanism& mechanism : all) {
    if (std::any_of(before.begin(), before.end(),
                    [&](const ForceExplanation& one) { return IsSamePlace(one.mechanism, mechanism); }))
      continue;
    const Tried tried = forces.Try(mechanism);
    const auto same = std::find_if(best.begin(), best.end(),
                                   [&](const Tried& other) { return IsSamePlace(other.mechanism, mechanism); });
    if (same == best.end()) best.push_back(tried);
    else if (tried.fall > same->fall) *same = tried;
  }
  for (Tried& one : best)
    if (one.fall > 0) one = Refined(forces, one);
  std::stable_sort(best.begin(), best.end(), [](const Tried& a, const Tried& b) { return a.fall > b.fall; });
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
std::optional<ForceExplanation> Next(const ForceRecord& record, const WeighedForces& forces,
                                     const std::vector<ForceMechanism>& all,
                                     const std::vector<ForceExplanation>& before, double excess) {
  const std::vector<Tried> best = BestOfEach(forces, all, before);
  if (best.empty() || !(best.front().fall > 0)) return std::nullopt;
  const Tried& first = best.front();
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
