#include "identify/experiments/four_post/lacking_force.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "identify/audit/audit_equations.h"
#include "identify/audit/rig_fault.h"
#include "identify/experiments/fit_balance.h"
#include "identify/search/parallel.h"
#include "vehicles/loops/motion_name.h"
#include "vehicles/response/contact_cycle.h"
#include "vehicles/response/needed_force.h"
#include "vehicles/response/reduced_march.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

Eigen::Index RowOf(std::size_t index) { return static_cast<Eigen::Index>(index); }

/// How sensors see the coordinates at one frequency of one recording, per metre of the reference post.
struct Sight {
  std::vector<std::size_t> sensors;
  Eigen::VectorXd sd;
  /// Sensors x n.
  Eigen::MatrixXd rows;
  /// n x sensors: the coordinates that come nearest to all readings.
  Eigen::MatrixXd to_motion;

  Eigen::VectorXcd Motion(const AuditedRun& run, std::size_t f) const {
    Eigen::VectorXcd readings(sd.size());
    for (std::size_t i = 0; i < sensors.size(); ++i) readings[RowOf(i)] = run.motions(RowOf(sensors[i]), RowOf(f));
    return to_motion.cast<Complex>() * readings;
  }
  /// With other rows of the sensors, to first order.
  Eigen::VectorXcd MotionBy(const AuditSubject& changed, std::size_t r, std::size_t f, double omega) const {
    const Eigen::VectorXcd motion = Motion(changed.runs[r], f);
    Eigen::VectorXcd missed(sd.size());
    for (std::size_t i = 0; i < sensors.size(); ++i)
      missed[RowOf(i)] =
          ((MotionRow(changed.car.sensors[sensors[i]], omega) - rows.row(RowOf(i))).cast<Complex>() * motion)(0);
    return motion - to_motion.cast<Complex>() * missed;
  }
};

Sight SightOf(const AuditSubject& audited, std::size_t r, std::size_t f, double omega) {
  const AuditedRun& run = audited.runs[r];
  Sight sight;
  for (std::size_t s = 0; s < audited.car.sensors.size(); ++s) {
    const Complex reading = run.motions(RowOf(s), RowOf(f));
    if (std::isfinite(reading.real()) && std::isfinite(reading.imag())) sight.sensors.push_back(s);
  }
  const Eigen::Index n = audited.car.coordinates;
  const Eigen::Index count = RowOf(sight.sensors.size());
  sight.sd.resize(count);
  sight.rows.resize(count, n);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t s = sight.sensors[static_cast<std::size_t>(i)];
    sight.rows.row(i) = MotionRow(audited.car.sensors[s], omega);
    sight.sd[i] = ReadingSd(audited.car, run, {}, s, f);
  }
  const Eigen::VectorXd weights = sight.sd.cwiseInverse();
  // With a bound on coordinates that no sensor sees.
  Eigen::MatrixXd bounded(count + n, n);
  bounded << weights.asDiagonal() * sight.rows, Eigen::MatrixXd::Identity(n, n) / kMostMotion;
  sight.to_motion = LeastNorm(bounded, 1e-12).PseudoInverse().leftCols(count) * weights.asDiagonal();
  return sight;
}

/// Coordinates by the names of what moves.
std::vector<NamedCoordinate> NamedCoordinates(const std::vector<LinkMotion>& links, Eigen::Index n) {
  using Direction = NamedMotion::Direction;
  std::vector<NamedCoordinate> named;
  for (const NamedMotion& motion : NameMotions(links, Eigen::MatrixXd::Identity(n, n))) {
    NamedCoordinate one{.name = motion.Text(), .is_turn = motion.direction >= Direction::kRoll};
    for (const LinkMotion& link : links) {
      if (link.name != motion.link) continue;
      const auto row = static_cast<Eigen::Index>(motion.direction);
      const double moved = row < 3 ? link.com_jacobian.row(row).dot(motion.shape.transpose())
                                   : link.spin_jacobian.row(row - 3).dot(motion.shape.transpose());
      one.shape = motion.shape / moved;
    }
    named.push_back(std::move(one));
  }
  return named;
}

/// What free parameters may be off by.
struct ParameterDoubts {
  /// With one parameter moved by its step, a share of its reach, which counts as a standard deviation.
  std::vector<CondensedModel> moved;
  std::vector<double> shares;
  /// All masses, rates and dampings multiplied by one factor, as changes over reaches of length 1. It changes no motion
  /// unless some are held, but multiplies the noise of the force: its effect is that on the model's own motion.
  Eigen::VectorXd common;
  std::optional<CondensedModel> scaled;
};

constexpr double kShareOfReach = 1e-3;

ParameterDoubts DoubtsOf(const Subject& subject, const std::vector<double>& values) {
  ParameterDoubts doubts;
  std::vector<double> common;
  std::vector<std::pair<std::size_t, double>> free;
  for (const std::size_t j : subject.free()) {
    const Parameter& parameter = subject.vehicle().parameters[j];
    const double reach = parameter.prior_sd.value_or(0.5 * std::max(0.0, parameter.upper - parameter.lower));
    if (!(reach > 0)) continue;
    // Inwards, for a bound may be what is physical.
    const double share = values[j] + kShareOfReach * reach > parameter.upper ? -kShareOfReach : kShareOfReach;
    std::vector<double> there = values;
    there[j] += share * reach;
    doubts.moved.push_back(subject.Condensed()->At(there));
    doubts.shares.push_back(share);
    common.push_back(parameter.dimension.kilogram == 1 ? values[j] / reach : 0);
    free.emplace_back(j, reach);
  }
  doubts.common = Eigen::Map<const Eigen::VectorXd>(common.data(), RowOf(common.size()));
  const double length = doubts.common.norm();
  if (!(length > 0)) return doubts;
  doubts.common /= length;
  std::vector<double> there = values;
  for (std::size_t i = 0; i < free.size(); ++i)
    there[free[i].first] -= kShareOfReach * doubts.common[RowOf(i)] * free[i].second;
  doubts.scaled = subject.Condensed()->At(there);
  return doubts;
}

/// Records with what a good rig may be off by, by a small share of it.
struct FaultyRecords {
  AuditSubject subject;
  double share = 0;
};

std::vector<FaultyRecords> RigDoubts(const AuditSubject& audited) {
  constexpr double kShare = 0.01;
  std::vector<FaultyRecords> all;
  for (const RigFault& fault : PossibleFaults(audited, {})) {
    if (fault.kind == RigFault::Kind::kExchange) continue;
    if (fault.where != RigFault::Where::kSensors && fault.where != RigFault::Where::kPosts) continue;
    all.push_back({.subject = Corrected(audited, fault, kShare * fault.allowed), .share = kShare});
  }
  return all;
}

Eigen::VectorXd Stacked(const Eigen::VectorXcd& complex) {
  Eigen::VectorXd all(2 * complex.size());
  all << complex.real(), complex.imag();
  return all;
}

/// One recording against the vehicle.
class RunForce {
 public:
  RunForce(const CondensedModel& model, const ParameterDoubts& doubts, const std::vector<FaultyRecords>& faulty,
           const AuditSubject& audited, const MeasuredRun& run, std::size_t r)
      : model_(model),
        doubts_(doubts),
        faulty_(faulty),
        audited_(audited),
        run_(run),
        r_(r),
        needed_(model, run.excitation.shape) {
    if (!HasHysteresis(model)) cycle_ = std::make_unique<ContactCycle>(model, run.excitation.shape, kFitBalance);
    for (const CondensedModel& moved : doubts.moved)
      at_doubts_.push_back(std::make_unique<NeededForce>(moved, run.excitation.shape));
    if (doubts.scaled) scaled_.emplace(*doubts.scaled, run.excitation.shape);
  }

  /// Nothing where an element has no periodic force.
  std::optional<ForceSample> At(std::size_t f) {
    ForceSample sample{
        .run = r_, .frequency_Hz = run_.excitation.frequency_Hz[f], .amplitude_m = run_.excitation.amplitude_m[f]};
    const double amplitude = sample.amplitude_m;
    const Sight sight = SightOf(audited_, r_, f, sample.omega());
    sample.motion = amplitude * sight.Motion(audited_.runs[r_], f);
    sample.posts = amplitude * audited_.runs[r_].posts.col(RowOf(f));
    sample.overtones = Overtones(sample.frequency_Hz, amplitude);
    samples_ = needed_.SamplesFor(sample.frequency_Hz, amplitude, Harmonics(sample, sample.motion));
    if (modelled_.size() > 0)
      samples_ = std::max(samples_, needed_.SamplesFor(sample.frequency_Hz, amplitude, Harmonics(sample, modelled_)));
    const Eigen::MatrixXd weighed = sight.sd.cwiseInverse().asDiagonal() * sight.rows / amplitude;
    sample.information = weighed.transpose() * weighed;
    const std::optional<Eigen::VectorXd> force = Force(needed_, sample, sample.motion, {});
    if (!force) return std::nullopt;
    yielded_ = needed_.Yielded();
    const Eigen::Index n = sample.motion.size();
    sample.force = force->head(n) + Complex(0, 1) * force->tail(n);
    if (!AddSlope(sample) || !AddDoubts(*force, sight, f, sample)) return std::nullopt;
    return sample;
  }

 private:
  /// Of the model's own motion; none where it has no periodic one.
  Eigen::MatrixXcd Overtones(double frequency_Hz, double amplitude) {
    const Eigen::Index n = model_.mass.rows();
    Eigen::MatrixXcd overtones = Eigen::MatrixXcd::Zero(NeededForce::kHarmonics + 1, n);
    modelled_.resize(0);
    if (!cycle_ || !cycle_->Solve(frequency_Hz, amplitude)) return overtones;
    overtones = cycle_->cycle().Coordinates(NeededForce::kHarmonics).leftCols(n);
    modelled_ = overtones.row(1).transpose();
    overtones.row(1).setZero();
    return overtones;
  }

  static Eigen::MatrixXcd Harmonics(const ForceSample& sample, const Eigen::VectorXcd& motion) {
    Eigen::MatrixXcd harmonics = sample.overtones;
    harmonics.row(1) = motion.transpose();
    return harmonics;
  }

  /// `start`: NeededForce::Yielded() of a motion or a model next to it.
  std::optional<Eigen::VectorXd> Force(NeededForce& needed, const ForceSample& sample, const Eigen::VectorXcd& motion,
                                       const Eigen::MatrixXcd& start, Complex posts = 1) const {
    const std::optional<Eigen::VectorXcd> force =
        needed.At(sample.frequency_Hz, posts * sample.amplitude_m, Harmonics(sample, motion), samples_, start);
    if (!force) return std::nullopt;
    return Stacked(*force);
  }

  bool AddSlope(ForceSample& sample) {
    constexpr double kStep = 1e-4;
    const double step = kStep * std::max(sample.motion.cwiseAbs().maxCoeff(), sample.amplitude_m);
    std::optional<Eigen::MatrixXd> slope =
        needed_.Slope(sample.frequency_Hz, sample.amplitude_m, Harmonics(sample, sample.motion), samples_, step);
    if (!slope) return false;
    sample.slope = *std::move(slope);
    return true;
  }

  bool AddDoubts(const Eigen::VectorXd& force, const Sight& sight, std::size_t f, ForceSample& sample) {
    const Eigen::Index parameters = RowOf(doubts_.moved.size());
    Eigen::MatrixXd by_parameter(force.size(), parameters);
    for (Eigen::Index j = 0; j < parameters; ++j) {
      const std::optional<Eigen::VectorXd> there =
          Force(*at_doubts_[static_cast<std::size_t>(j)], sample, sample.motion, yielded_);
      if (!there) return false;
      by_parameter.col(j) = (*there - force) / doubts_.shares[static_cast<std::size_t>(j)];
    }
    if (!AddOwn(sample)) return false;
    if (scaled_) {
      by_parameter -= (by_parameter * doubts_.common) * doubts_.common.transpose();
      by_parameter += ByCommon(sample) * doubts_.common.transpose();
    }
    sample.nuisance.resize(force.size(), parameters + RowOf(faulty_.size()));
    sample.nuisance.leftCols(parameters) = by_parameter;
    Eigen::Index next = parameters;
    for (const FaultyRecords& faulty : faulty_) {
      const Eigen::VectorXcd motion = sample.amplitude_m * sight.MotionBy(faulty.subject, r_, f, sample.omega());
      const Complex posts = PostsOver(faulty.subject.runs[r_], f);
      std::optional<Eigen::VectorXd> there = Stacked(motion - sample.motion);
      Eigen::VectorXd change = sample.slope * *there;
      if (posts != 1.0) {
        there = Force(needed_, sample, sample.motion, yielded_, posts);
        if (!there) return false;
        change += *there - force;
      }
      sample.nuisance.col(next++) = change / faulty.share;
    }
    return true;
  }

  /// What parameters change of the force on the model's own motion; nothing where it has none.
  bool AddOwn(ForceSample& sample) {
    sample.modelled = modelled_;
    if (modelled_.size() == 0) return true;
    const std::optional<Eigen::VectorXd> here = Force(needed_, sample, modelled_, {});
    if (!here) return false;
    const Eigen::MatrixXcd start = needed_.Yielded();
    sample.by_parameters.resize(here->size(), RowOf(doubts_.moved.size()));
    for (std::size_t j = 0; j < doubts_.moved.size(); ++j) {
      const std::optional<Eigen::VectorXd> there = Force(*at_doubts_[j], sample, modelled_, start);
      if (!there) return false;
      sample.by_parameters.col(RowOf(j)) = (*there - *here) / doubts_.shares[j];
    }
    return true;
  }

  /// Change by the common factor of all parameters, of the force on the model's own motion; zero where it has none.
  Eigen::VectorXd ByCommon(const ForceSample& sample) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(2 * sample.motion.size());
    if (modelled_.size() == 0) return none;
    const std::optional<Eigen::VectorXd> here = Force(needed_, sample, modelled_, {});
    const std::optional<Eigen::VectorXd> there = Force(*scaled_, sample, modelled_, needed_.Yielded());
    if (!here || !there) return none;
    return (*there - *here) / -kShareOfReach;
  }

  /// Posts of other records over those of these.
  Complex PostsOver(const AuditedRun& other, std::size_t f) const {
    const AuditedRun& here = audited_.runs[r_];
    for (Eigen::Index p = 0; p < here.posts.rows(); ++p)
      if (const Complex own = here.posts(p, RowOf(f)); own != 0.0) return other.posts(p, RowOf(f)) / own;
    return 1;
  }

  const CondensedModel& model_;
  const ParameterDoubts& doubts_;
  const std::vector<FaultyRecords>& faulty_;
  const AuditSubject& audited_;
  const MeasuredRun& run_;
  std::size_t r_;
  NeededForce needed_;
  std::unique_ptr<ContactCycle> cycle_;
  std::vector<std::unique_ptr<NeededForce>> at_doubts_;
  std::optional<NeededForce> scaled_;
  /// First harmonic of the model's own motion at the frequency at hand; empty: it has none.
  Eigen::VectorXcd modelled_;
  /// NeededForce::Yielded() of the measured motion at that frequency.
  Eigen::MatrixXcd yielded_;
  /// Per cycle, for all motions at that frequency.
  int samples_ = 0;
};

/// Names of what sensors do not determine at a middle frequency of a recording.
std::vector<std::string> NotMeasured(const ForceRecord& record, std::size_t run) {
  std::vector<const ForceSample*> samples;
  for (const ForceSample& sample : record.samples)
    if (sample.run == run) samples.push_back(&sample);
  std::vector<std::string> names;
  if (samples.empty()) return names;
  for (const NamedMotion& motion : NameMotions(record.links, UnmeasuredMotion(*samples[samples.size() / 2])))
    names.push_back(motion.Text());
  return names;
}

}  // namespace

ForceRecord LackingForce(const Subject& subject, const std::vector<double>& values,
                         const std::vector<MeasuredRun>& runs, const AuditSubject& audited, int threads) {
  const CondensedVehicle& vehicle = *subject.Condensed();
  const CondensedModel model = vehicle.At(values);
  ForceRecord record;
  record.lines = ElementLines(subject.vehicle());
  record.links = vehicle.LinkMotions(values);
  record.coordinates = NamedCoordinates(record.links, vehicle.size());
  const ParameterDoubts doubts = DoubtsOf(subject, values);
  const std::vector<FaultyRecords> faulty = RigDoubts(audited);
  std::vector<std::vector<ForceSample>> of_run(runs.size());
  ForEachInParallel(runs.size(), ThreadCount(threads), [&](std::size_t r) {
    RunForce force(model, doubts, faulty, audited, runs[r], r);
    for (std::size_t f = 0; f < runs[r].excitation.frequency_Hz.size(); ++f)
      if (std::optional<ForceSample> sample = force.At(f)) of_run[r].push_back(*std::move(sample));
  });
  for (std::size_t r = 0; r < runs.size(); ++r) {
    record.runs.push_back(runs[r].name);
    for (ForceSample& sample : of_run[r]) record.samples.push_back(std::move(sample));
    record.not_measured.push_back(NotMeasured(record, r));
  }
  return record;
}

}  // namespace fourpost
