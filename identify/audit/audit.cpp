#include "identify/audit/audit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "identify/audit/audit_equations.h"
#include "identify/audit/free_wheelpans.h"

namespace fourpost {
namespace {

using Kind = RigFault::Kind;

constexpr std::size_t kMostFaults = 4;
/// By which the scores of two explanations must differ to be separated: three standard deviations.
constexpr double kApart = 9;
/// And by which share: sizes of large faults are only nearly additive.
constexpr double kShareApart = 0.1;

/// Of the best explanations by derivatives, for which the size is sought.
constexpr std::size_t kRefined = 12;

/// A clock is wrong by some per cent, sensors sit on the car.
bool IsPossible(const RigFault& fault, double size) {
  if (fault.where == RigFault::Where::kClock) return std::abs(size) < 0.3;
  return fault.kind != Kind::kPlace || std::abs(size) < 5;
}

/// Of two faults of one kind, one after the other.
double Together(const RigFault& fault, double first, double second) {
  return fault.kind == Kind::kScale ? (1 + first) * (1 + second) - 1 : first + second;
}

/// Squares of what is left over, over their noise, that bodies which bend a little may have.
constexpr double kExplained = 4;

double StepOf(const RigFault& fault) {
  switch (fault.kind) {
    case Kind::kDelay: return 1e-5;
    case Kind::kPlace: return 1e-3;
    case Kind::kWheelpan: return 1e-2;
    default: return 1e-4;
  }
}

struct Explanation {
  std::size_t fault = 0;
  double size = 0;
  double variance = 0;
  double fall = 0;
};

/// The equations at the unknown numbers that fit best, and how faults move what is left over.
class Stand {
 public:
  Stand(const AuditSubject& subject, const RigTolerance& tolerance, const std::vector<RigFault>& faults)
      : subject_(subject), tolerance_(tolerance), equations_(subject, tolerance), faults_(faults) {
    Solve();
    AddDirections();
  }

  const AuditEquations& equations() const { return equations_; }
  const Eigen::VectorXd& rest() const { return rest_; }
  double degrees() const { return degrees_; }

  /// An unknown parameter of AuditedCar::reach, beside its value in the file.
  double Parameter(Eigen::Index j) const { return unknowns_[FirstParameter() + j]; }
  /// Its standard deviation: of noise, `widened` times, and of what a good rig may be off by.
  double ParameterSd(Eigen::Index j, double widened) const {
    const Eigen::Index row = FirstParameter() + j;
    const double noise = scale_[row] * free_->PseudoInverse().row(row).norm();
    return std::hypot(widened * noise, moved_.row(row).cwiseProduct(allowed_.transpose()).norm());
  }

  /// Sum of squares with what a good rig may be off by as noise.
  double Squares() const { return SquaresOf(rest_); }

  /// Fall of the sum of squares by the size that the derivative at no fault gives.
  Explanation By(std::size_t fault) const {
    const auto j = static_cast<Eigen::Index>(fault);
    const RigFault& one = faults_[fault];
    if (one.kind == Kind::kExchange) {
      const AuditSubject exchanged = Corrected(subject_, one, 0);
      // Rates of tyres follow their load cells, far beyond derivatives.
      const bool moves_unknowns = one.where == RigFault::Where::kCells;
      const Eigen::VectorXd rest = moves_unknowns ? Stand(exchanged, tolerance_, {}).rest() : RestOf(exchanged);
      return {.fault = fault, .fall = Squares() - SquaresOf(rest)};
    }
    if (!(information_[j] > 0)) return {.fault = fault};
    const double size = gradient_[j] / information_[j];
    return {.fault = fault, .size = size, .variance = 1 / information_[j], .fall = gradient_[j] * size};
  }

  /// Number of neighbouring frequencies whose misclosures count as one, once a fault is taken out: (1 + r) / (1 - r), r
  /// their correlation. Noise has 1; bodies that bend, or a geometry that is not the car's, have many.
  double Correlated(const Explanation& one) const {
    using RowKind = AuditEquations::Row::Kind;
    const Eigen::VectorXd rest = RestOf(Corrected(subject_, faults_[one.fault], one.size));
    std::map<std::tuple<RowKind, std::size_t, std::size_t, bool>, double> before;
    double products = 0;
    double squares = 0;
    bool is_second = false;
    for (Eigen::Index i = 0; i < rest.size(); ++i, is_second = !is_second) {
      const AuditEquations::Row& row = equations_.rows()[static_cast<std::size_t>(i)];
      if (row.kind == RowKind::kWeight || row.kind == RowKind::kPrior) break;
      const auto key = std::make_tuple(row.kind, row.member, row.run, is_second);
      if (const auto found = before.find(key); found != before.end()) products += found->second * rest[i];
      squares += rest[i] * rest[i];
      before[key] = rest[i];
    }
    constexpr double kMost = 0.95;
    const double correlation = squares > 0 ? std::clamp(products / squares, 0.0, kMost) : 0;
    return (1 + correlation) / (1 - correlation);
  }

  /// By the size that explains most: signs, units and delays are beyond derivatives.
  Explanation Refined(Explanation one) const {
    const RigFault& fault = faults_[one.fault];
    if (fault.kind == Kind::kExchange) return one;
    constexpr int kMostSteps = 6;
    const double step = StepOf(fault);
    double size = one.size;
    for (int i = 0; i < kMostSteps; ++i) {
      const Eigen::VectorXd here = RestOf(Corrected(subject_, fault, size));
      const double fall = Squares() - SquaresOf(here);
      if (i > 0 && !(fall > one.fall)) break;
      one.size = size;
      one.fall = fall;
      const Eigen::VectorXd slope = (here - RestOf(Corrected(subject_, fault, size + step))) / step;
      const Eigen::VectorXd g = directions_.transpose() * slope;
      const double information = slope.squaredNorm() - g.dot(inner_ * g);
      if (!(information > 0)) break;
      const double change = (slope.dot(here) - g.dot(inner_ * (directions_.transpose() * here))) / information;
      // What is allowed of this fault is in the noise, and does not change the best size, only its information.
      size += change;
      one.variance = 1 / information;
      if (std::abs(change) < 0.1 * fault.allowed) break;
    }
    return one;
  }

 private:
  Eigen::Index FirstParameter() const { return 3 * static_cast<Eigen::Index>(subject_.car.tyres.size()); }

  /// Of the whole car the unknown numbers, by Gauss-Newton: only products of two small ones are not linear.
  void Solve() {
    unknowns_ = Eigen::VectorXd::Zero(equations_.unknowns());
    for (std::size_t t = 0; t < subject_.car.tyres.size(); ++t) unknowns_[3 * static_cast<Eigen::Index>(t)] = 1;
    for (int round = 0; round < 3; ++round) {
      Linearise();
      unknowns_ -= scale_.asDiagonal() * free_->Solve(equations_.Misclosures(subject_, unknowns_));
      Bound();
    }
    Linearise();
    rest_ = Projected(equations_.Misclosures(subject_, unknowns_));
    degrees_ = equations_.degrees() - static_cast<double>(free_->rank());
  }

  /// Masses stay near those of the vehicle's file, whatever loads and forces claim.
  void Bound() {
    constexpr double kMost = 3;
    const Eigen::Index first = 3 * static_cast<Eigen::Index>(subject_.car.tyres.size());
    for (Eigen::Index j = 0; j < subject_.car.reach.size(); ++j) {
      const double most = kMost * subject_.car.reach[j];
      if (std::abs(unknowns_[first + j]) <= most) continue;
      unknowns_[first + j] = std::copysign(most, unknowns_[first + j]);
      bounded_.insert(first + j);
    }
  }

  void Linearise() {
    const Eigen::VectorXd here = equations_.Misclosures(subject_, unknowns_);
    Eigen::MatrixXd slopes(here.size(), unknowns_.size());
    scale_.resize(unknowns_.size());
    for (Eigen::Index j = 0; j < unknowns_.size(); ++j) {
      const Eigen::Index parameter = j - 3 * static_cast<Eigen::Index>(subject_.car.tyres.size());
      const bool is_parameter = parameter >= 0 && parameter < subject_.car.reach.size();
      const double step = 1e-3 * (is_parameter ? subject_.car.reach[parameter] : 1);
      Eigen::VectorXd moved = unknowns_;
      moved[j] += step;
      slopes.col(j) = (equations_.Misclosures(subject_, moved) - here) / step;
      const double norm = slopes.col(j).norm();
      scale_[j] = norm > 0 && !bounded_.count(j) ? 1 / norm : 0;
      slopes.col(j) *= scale_[j];
    }
    slopes_ = slopes;
    free_ = std::make_unique<LeastNorm>(slopes, 1e-9);
  }

  Eigen::VectorXd Projected(const Eigen::VectorXd& misclosures) const {
    return misclosures - slopes_ * free_->Solve(misclosures);
  }
  Eigen::VectorXd RestOf(const AuditSubject& subject) const {
    return Projected(equations_.Misclosures(subject, unknowns_));
  }

  void AddDirections() {
    if (faults_.empty()) return;
    const auto count = static_cast<Eigen::Index>(faults_.size());
    const Eigen::VectorXd here = equations_.Misclosures(subject_, unknowns_);
    directions_.setZero(rest_.size(), count);
    allowed_.setZero(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const RigFault& fault = faults_[static_cast<std::size_t>(j)];
      if (fault.kind == Kind::kExchange) continue;
      const double step = StepOf(fault);
      directions_.col(j) = (here - equations_.Misclosures(Corrected(subject_, fault, step), unknowns_)) / step;
      allowed_[j] = fault.allowed;
    }
    const Eigen::MatrixXd moved = free_->Solve(directions_);
    moved_ = scale_.asDiagonal() * moved;
    directions_ -= slopes_ * moved;
    const Eigen::MatrixXd products = directions_.transpose() * directions_;
    const Eigen::MatrixXd t = allowed_.asDiagonal();
    inner_ =
        t * Solved(Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count) + t * products * t), Eigen::MatrixXd(t));
    const Eigen::VectorXd g = directions_.transpose() * rest_;
    gradient_ = g - products * (inner_ * g);
    information_ = (products - products * inner_ * products).diagonal();
    // What differences leave of nothing.
    for (Eigen::Index j = 0; j < count; ++j)
      if (information_[j] < 1e-9 * std::max(1.0, products(j, j))) information_[j] = 0;
  }

  double SquaresOf(const Eigen::VectorXd& rest) const {
    if (faults_.empty()) return rest.squaredNorm();
    const Eigen::VectorXd g = directions_.transpose() * rest;
    return rest.squaredNorm() - g.dot(inner_ * g);
  }

  AuditSubject subject_;
  RigTolerance tolerance_;
  AuditEquations equations_;
  std::vector<RigFault> faults_;
  Eigen::VectorXd unknowns_;
  /// Unknowns that are at a bound.
  std::set<Eigen::Index> bounded_;
  Eigen::MatrixXd slopes_;
  Eigen::VectorXd scale_;
  std::unique_ptr<LeastNorm> free_;
  Eigen::VectorXd rest_;
  double degrees_ = 0;
  Eigen::MatrixXd directions_;
  Eigen::VectorXd allowed_;
  /// How far each fault moves the unknown numbers.
  Eigen::MatrixXd moved_;
  /// With which products of directions give what tolerances explain.
  Eigen::MatrixXd inner_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd information_;
};

std::vector<Explanation> ExplanationsOf(const Stand& stand, const std::vector<RigFault>& faults) {
  std::vector<Explanation> all;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    all.push_back(stand.By(i));
  }
  const auto more = [](const Explanation& a, const Explanation& b) { return a.fall > b.fall; };
  std::stable_sort(all.begin(), all.end(), more);
  for (std::size_t i = 0; i < std::min(kRefined, all.size()) && all[i].fall > kSuspicious * kSuspicious; ++i)
    all[i] = stand.Refined(all[i]);
  std::erase_if(all, [&](const Explanation& one) { return !IsPossible(faults[one.fault], one.size); });
  std::stable_sort(all.begin(), all.end(), more);
  return all;
}

Suspicion SuspicionOf(const std::vector<Explanation>& all, const std::vector<RigFault>& faults, double noise) {
  const Explanation& best = all.front();
  const double allowed = faults[best.fault].allowed;
  Suspicion found{.fault = faults[best.fault], .size = best.size, .score = best.fall / noise};
  found.sd = std::sqrt(std::max(0.0, noise * (best.variance - allowed * allowed)));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double score = all[i].fall / noise;
    if (found.score - score < std::max(kApart, kShareApart * found.score))
      found.rivals.push_back({faults[all[i].fault], all[i].size, score});
    else {
      found.next_score = score;
      break;
    }
  }
  return found;
}

/// What is left of a fault that was found before belongs to it.
void Add(const Suspicion& suspicion, std::vector<Suspicion>& suspicions) {
  for (Suspicion& other : suspicions) {
    if (other.fault.name != suspicion.fault.name || other.fault.kind != suspicion.fault.kind ||
        other.fault.axis != suspicion.fault.axis)
      continue;
    other.size = Together(other.fault, other.size, suspicion.size);
    other.sd = suspicion.sd;
    return;
  }
  suspicions.push_back(suspicion);
}

double NoiseOf(const AuditSubject& subject, const RigTolerance& tolerance) {
  const Stand stand(subject, tolerance, {});
  return stand.degrees() > 0 ? stand.Squares() / stand.degrees() : std::numeric_limits<double>::infinity();
}

bool IsOfOneChannel(const RigFault& fault) {
  return fault.kind == Kind::kScale && fault.members.size() == 1 && fault.where != RigFault::Where::kPosts;
}

/// Of signs and units: true values over readings, less one.
std::vector<double> UnitSizes() {
  std::vector<double> sizes;
  for (const double factor : {-1.0, 1000.0, 25.4, 9.80665, 4.4482216})
    for (const double one : {factor, 1 / factor}) sizes.push_back(one - 1);
  return sizes;
}

/// Of one channel signs alone, for each takes its time.
std::vector<double> UsualSizes(const RigFault& fault) {
  if (fault.kind != Kind::kScale) return {};
  if (IsOfOneChannel(fault)) return {-2};
  return fault.members.size() < 2 ? std::vector<double>() : UnitSizes();
}

/// Where no derivative leads to what explains the readings, as with the sign of a force, which rates of tyres follow:
/// the sign or unit with which least is left over, if that is a matter of noise then.
std::optional<Suspicion> UsualFault(const AuditSubject& subject, const RigTolerance& tolerance,
                                    const std::vector<RigFault>& faults) {
  std::optional<Suspicion> found;
  double least = kExplained;
  for (const RigFault& fault : faults)
    for (const double size : UsualSizes(fault)) {
      const double noise = NoiseOf(Corrected(subject, fault, size), tolerance);
      if (noise >= least) continue;
      least = noise;
      found = Suspicion{.fault = fault, .size = size};
    }
  return found;
}

/// Likewise the channel without which least is left over, in another unit if that explains it.
std::optional<Suspicion> ForeignChannel(const AuditSubject& subject, const RigTolerance& tolerance,
                                        const std::vector<RigFault>& faults) {
  std::optional<Suspicion> found;
  double least = kExplained;
  for (const RigFault& fault : faults) {
    if (!IsOfOneChannel(fault)) continue;
    RigFault foreign = fault;
    foreign.kind = Kind::kOther;
    const double noise = NoiseOf(Corrected(subject, foreign, 0), tolerance);
    if (noise >= least) continue;
    least = noise;
    found = Suspicion{.fault = foreign};
  }
  if (!found) return found;
  RigFault scale = found->fault;
  scale.kind = Kind::kScale;
  for (const double size : UnitSizes())
    if (NoiseOf(Corrected(subject, scale, size), tolerance) < kExplained)
      return Suspicion{.fault = scale, .size = size};
  return found;
}

/// Mean of the masses in the file [kg]; 0 of another fault.
double WheelpanOf(const AuditSubject& subject, const RigFault& fault) {
  if (fault.kind != Kind::kWheelpan) return 0;
  double sum = 0;
  for (const std::size_t t : fault.members) sum += subject.car.tyres[t].wheelpan;
  return sum / static_cast<double>(fault.members.size());
}

/// As large a fault would be no fault of this kind: all of a reading, a period of the lowest frequency.
double LargestOf(const RigFault& fault, const AuditSubject& subject) {
  constexpr double kHeaviest_kg = 1000;
  constexpr double kCar_m = 5;
  double slowest_Hz = std::numeric_limits<double>::infinity();
  for (const AuditedRun& run : subject.runs)
    for (const double frequency : run.frequency_Hz) slowest_Hz = std::min(slowest_Hz, frequency);
  switch (fault.kind) {
    case Kind::kDelay: return 1 / slowest_Hz;
    case Kind::kPlace: return kCar_m;
    case Kind::kWheelpan: return kHeaviest_kg;
    default: return 1;
  }
}

std::vector<Resolution> ResolutionsOf(const std::vector<Explanation>& all, const std::vector<RigFault>& faults,
                                      const AuditSubject& subject, double widened) {
  std::vector<Resolution> resolutions;
  for (const Explanation& one : all) {
    const RigFault& fault = faults[one.fault];
    if (fault.kind == Kind::kExchange) continue;
    Resolution resolution{fault, widened * std::sqrt(one.variance)};
    if (!(one.variance > 0) || resolution.Seen() > LargestOf(fault, subject))
      resolution.sd = std::numeric_limits<double>::infinity();
    resolutions.push_back(resolution);
  }
  return resolutions;
}

std::vector<ChannelRest> RestsOf(const AuditSubject& subject, const Stand& stand) {
  using RowKind = AuditEquations::Row::Kind;
  struct Sum {
    double rest = 0;
    double noise = 0;
    double reading = 0;
  };
  std::map<std::pair<bool, std::pair<std::size_t, std::size_t>>, Sum> sums;
  const std::vector<AuditEquations::Row>& rows = stand.equations().rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AuditEquations::Row& row = rows[i];
    if (row.kind != RowKind::kSensor && row.kind != RowKind::kTyre) continue;
    const bool is_tyre = row.kind == RowKind::kTyre;
    const AuditedRun& run = subject.runs[row.run];
    const auto f = static_cast<Eigen::Index>(row.frequency);
    const auto m = static_cast<Eigen::Index>(row.member);
    // Of a tyre as the squeeze that its force makes.
    const double reading =
        is_tyre ? subject.car.tyres[row.member].compliance * std::abs(run.forces(m, f)) : std::abs(run.motions(m, f));
    Sum& sum = sums[{is_tyre, {row.member, row.run}}];
    sum.rest += std::pow(row.sd * stand.rest()[static_cast<Eigen::Index>(i)], 2);
    sum.noise += row.sd * row.sd;
    sum.reading += 0.5 * reading * reading;
  }
  std::vector<ChannelRest> rests;
  for (const auto& [key, sum] : sums)
    rests.push_back(
        {.name = key.first ? subject.car.tyres[key.second.first].cell : subject.car.sensors[key.second.first].name,
         .is_force = key.first,
         .run = subject.runs[key.second.second].name,
         .share = std::sqrt(sum.rest / sum.reading),
         .expected = std::sqrt(sum.noise / sum.reading)});
  return rests;
}

}  // namespace

double Resolution::Seen() const { return kSuspicious * sd; }

namespace {

/// What is known of the parameters of AuditedCar::reach once suspicions are corrected.
struct FoundParameters {
  std::vector<double> changes;
  std::vector<double> sds;
};

/// With wheelpans as stated, or as the subject frees them.
Audit SearchFaults(const AuditSubject& subject, const RigTolerance& tolerance, FoundParameters* parameters = nullptr) {
  Audit audit;
  const std::vector<RigFault> faults = PossibleFaults(subject, tolerance);
  AuditSubject corrected = subject;
  for (std::size_t round = 0; round <= kMostFaults; ++round) {
    const Stand stand(corrected, tolerance, faults);
    if (round == 0) {
      audit.channels = RestsOf(subject, stand);
      audit.is_redundant = stand.degrees() > 0;
      audit.is_noise_known = std::all_of(subject.runs.begin(), subject.runs.end(),
                                         [](const AuditedRun& run) { return run.is_noise_known; });
    }
    if (!audit.is_redundant) break;
    const std::vector<Explanation> all = ExplanationsOf(stand, faults);
    const Explanation& best = all.front();
    // Of what the best explanation leaves over.
    const double noise = std::max(1.0, (stand.Squares() - best.fall) / stand.degrees());
    Suspicion suspicion = SuspicionOf(all, faults, noise * stand.Correlated(best));
    if (noise > kExplained && NoiseOf(Corrected(corrected, suspicion.fault, suspicion.size), tolerance) >= kExplained) {
      std::optional<Suspicion> other = UsualFault(corrected, tolerance, faults);
      if (!other) other = ForeignChannel(corrected, tolerance, faults);
      if (other) {
        suspicion = *other;
        suspicion.score = stand.Squares() / noise;
      }
    }
    if (!(suspicion.score > kSuspicious * kSuspicious) || round == kMostFaults) {
      audit.misfit = std::sqrt(std::max(0.0, stand.Squares() / stand.degrees()));
      const double widened = std::max(1.0, audit.misfit);
      audit.resolutions = ResolutionsOf(all, faults, subject, widened);
      for (Eigen::Index j = 0; parameters != nullptr && j < subject.car.reach.size(); ++j) {
        parameters->changes.push_back(stand.Parameter(j));
        parameters->sds.push_back(stand.ParameterSd(j, widened));
      }
      break;
    }
    suspicion.wheelpan_kg = WheelpanOf(subject, suspicion.fault);
    Add(suspicion, audit.suspicions);
    corrected = Corrected(std::move(corrected), suspicion.fault, suspicion.size);
  }
  const auto is_seen = [](const Resolution& one) { return std::isfinite(one.sd); };
  if (audit.suspicions.empty() && std::none_of(audit.resolutions.begin(), audit.resolutions.end(), is_seen))
    audit.is_redundant = false;
  return audit;
}

/// Wheelpans of other masses than stated, with the audit once they are corrected; null unless no more than
/// `most_misfit` is left over then. With a delay or a dead channel beside it, a wheelpan alone explains little.
std::optional<Audit> WithOtherWheelpans(const AuditSubject& subject, const RigTolerance& tolerance,
                                        double most_misfit) {
  // Three times that is the most.
  constexpr double kReach_kg = 30;
  const std::vector<std::size_t> tyres = StatedWheelpans(subject);
  if (tyres.empty()) return std::nullopt;
  FoundParameters found;
  SearchFaults(WithFreeWheelpans(subject, tyres, kReach_kg), tolerance, &found);
  if (found.changes.empty()) return std::nullopt;
  const std::size_t first = found.changes.size() - tyres.size();
  AuditSubject corrected = subject;
  std::vector<Suspicion> suspicions;
  for (const RigFault& fault : PossibleFaults(subject, tolerance)) {
    if (fault.kind != Kind::kWheelpan || fault.members.size() > 1) continue;
    const auto place = std::find(tyres.begin(), tyres.end(), fault.members.front()) - tyres.begin();
    const double size = found.changes[first + static_cast<std::size_t>(place)];
    const double sd = found.sds[first + static_cast<std::size_t>(place)];
    const double score = std::pow(size / std::hypot(sd, fault.allowed), 2);
    if (score <= kSuspicious * kSuspicious) continue;
    suspicions.push_back(
        {.fault = fault, .size = size, .sd = sd, .wheelpan_kg = WheelpanOf(subject, fault), .score = score});
    corrected = Corrected(std::move(corrected), fault, size);
  }
  if (suspicions.empty()) return std::nullopt;
  Audit audit = SearchFaults(corrected, tolerance);
  if (audit.misfit > most_misfit) return std::nullopt;
  for (const Suspicion& suspicion : audit.suspicions) Add(suspicion, suspicions);
  audit.suspicions = std::move(suspicions);
  return audit;
}

}  // namespace

Audit AuditRig(const AuditSubject& subject, const RigTolerance& tolerance) {
  Audit audit = SearchFaults(subject, tolerance);
  // Rates of tyres follow a wheelpan beyond derivatives: its mass is that of both together.
  constexpr double kSame = 1.1;
  constexpr double kResolved = 0.5;
  const bool has_wheelpan = std::any_of(audit.suspicions.begin(), audit.suspicions.end(),
                                        [](const Suspicion& one) { return one.fault.kind == Kind::kWheelpan; });
  if (!has_wheelpan && audit.misfit * audit.misfit <= kExplained) return audit;
  std::optional<Audit> other =
      WithOtherWheelpans(subject, tolerance, (has_wheelpan ? kSame : kResolved) * audit.misfit);
  if (!other) return audit;
  // As recorded.
  other->channels = std::move(audit.channels);
  return *std::move(other);
}

std::optional<FoundWheelpan> WheelpanBy(const Audit& audit, const std::string& cell, double least_kg) {
  const auto is_it = [&](const RigFault& fault) {
    return fault.kind == Kind::kWheelpan && (fault.name == cell || fault.members.size() > 1);
  };
  std::optional<FoundWheelpan> found;
  for (const Resolution& one : audit.resolutions)
    if (is_it(one.fault) && one.fault.name == cell && one.Seen() < least_kg) found = FoundWheelpan{.sd = one.sd};
  for (const Suspicion& one : audit.suspicions)
    if (is_it(one.fault)) found = FoundWheelpan{(found ? found->kg : 0) + one.size, one.sd};
  return found;
}

bool ClearsChannels(const Audit& audit, const std::vector<std::string>& channels) {
  constexpr double kScale = 0.1;
  constexpr double kDelay_s = 0.005;
  const auto is_seen = [&](const std::string& channel, RigFault::Kind kind, double size) {
    return std::any_of(audit.resolutions.begin(), audit.resolutions.end(), [&](const Resolution& one) {
      return one.fault.kind == kind && one.fault.name == channel && one.Seen() <= size;
    });
  };
  return audit.is_redundant && audit.suspicions.empty() &&
         std::all_of(channels.begin(), channels.end(), [&](const std::string& channel) {
           return is_seen(channel, RigFault::Kind::kScale, kScale) &&
                  is_seen(channel, RigFault::Kind::kDelay, kDelay_s);
         });
}

}  // namespace fourpost
