#include "vehicles/response/port_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "vehicles/response/port_newton.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Of Anderson acceleration.
constexpr int kHistory = 8;

/// Of a law with memory, whose steps err to the second order: with these no more than the samples do.
int StepsPerSample(int samples) {
  constexpr int kMany = 400;
  return samples < kMany ? 4 : 2;
}

/// With harmonics 0..H, where those that are missing are zero.
void Resize(const Eigen::MatrixXcd& harmonics, Eigen::Index last, Eigen::MatrixXcd& resized) {
  const Eigen::Index known = std::min(harmonics.rows(), last + 1);
  resized.resize(last + 1, harmonics.cols());
  resized.topRows(known) = harmonics.topRows(known);
  resized.bottomRows(last + 1 - known).setZero();
}

/// Of the signals whose harmonics are given.
void FindRates(const Eigen::MatrixXcd& extension, double omega, Eigen::MatrixXcd& rate) {
  rate.resize(extension.rows(), extension.cols());
  for (Eigen::Index j = 0; j < extension.cols(); ++j)
    for (Eigen::Index h = 0; h < extension.rows(); ++h) {
      const double w = static_cast<double>(h) * omega;
      rate(h, j) = Complex(-w * extension(h, j).imag(), w * extension(h, j).real());
    }
}
Eigen::MatrixXcd RateOf(const Eigen::MatrixXcd& extension, double omega) {
  Eigen::MatrixXcd rate;
  FindRates(extension, omega, rate);
  return rate;
}

}  // namespace

PortCycle::PortCycle(const std::vector<Port>& ports, const Receptance& receptance, int harmonics, int samples)
    : ports_(ports),
      receptance_(receptance),
      transform_(CycleTransform::Shared(harmonics, samples)),
      steps_(CycleTransform::Shared(harmonics, StepsPerSample(samples) * samples)),
      uses_extension_(
          std::any_of(ports.begin(), ports.end(), [](const Port& port) { return UsesExtension(port.law); })) {
  for (const Port& port : ports) kinks_.push_back(KinksOf(port.law));
  has_friction_ =
      std::any_of(ports.begin(), ports.end(), [](const Port& port) { return std::isfinite(StepOfRate(port.law)); });
  has_memory_ = std::any_of(ports.begin(), ports.end(), [](const Port& port) { return HasMemory(port.law); });
  remainder_time_.setZero(transform_.samples(), static_cast<Eigen::Index>(ports.size()));
}

bool PortCycle::Solve(double omega, const Eigen::MatrixXcd& driven, const Eigen::MatrixXcd& start, double tolerance,
                      int max_iterations, const Deadline& deadline) {
  // For many motions at one frequency.
  if (omega != std::exchange(omega_, 0)) receptance_.Ports(omega, harmonics(), ports_receptance_);
  omega_ = omega;
  Resize(driven, harmonics(), driven_);
  // The start may be this cycle's own solution.
  if (&start != &extension_) Resize(start, harmonics(), extension_);
  iterations_ = 0;
  means_help_ = has_friction_;
  const Eigen::MatrixXcd from = extension_;
  if (Iterate(tolerance, max_iterations, deadline)) return true;
  if (!preconditioner_) return false;
  // Where friction sticks for most of a cycle its mean slope says little.
  means_help_ = false;
  extension_ = from;
  return Iterate(tolerance, iterations_ + max_iterations, deadline);
}

bool PortCycle::Iterate(double tolerance, int most, const Deadline& deadline) {
  FindRemainders();
  if (ports_.empty()) return true;
  std::optional<AndersonAcceleration> acceleration;
  preconditioner_.reset();
  Method method = FirstMethod();
  // The last two sizes: motion and its reaction may take turns.
  double before = 0;
  double earlier = 0;
  while (true) {
    double change = FindStep() / SizeOf(extension_);
    if (!std::isfinite(change)) return false;
    if (IsEnough(change, earlier, method, tolerance)) return true;
    if (method == Method::kAnderson && IsPreconditioned()) {
      change = Precondition();
      if (!std::isfinite(change)) return false;
      if (IsEnough(change, earlier, method, tolerance)) return true;
    }
    if (iterations_ == most) return false;
    ++iterations_;
    deadline.Check();
    if (method == Method::kPlain && (method = Choose(change, before, earlier, tolerance)) == Method::kAnderson &&
        IsPreconditioned())
      Precondition();
    earlier = std::exchange(before, change);
    switch (method) {
      case Method::kPlain: extension_ += step_; break;
      case Method::kNewton: TakeNewtonStep(); continue;
      case Method::kAnderson:
        if (!acceleration) acceleration.emplace(kHistory);
        AndersonStep(*acceleration);
        break;
    }
    FindRemainders();
  }
}

/// The plain iteration may leave the motion that it starts from where a knee, a stop or a lift takes part, and barely
/// moves where friction does.
PortCycle::Method PortCycle::FirstMethod() const {
  if (IsTouched()) return Newton();
  return means_help_ && HasSteepFriction() ? Method::kAnderson : Method::kPlain;
}

/// Whether the plain iteration's steps answer friction with more than half of its change.
bool PortCycle::HasSteepFriction() const {
  const auto ports = static_cast<Eigen::Index>(ports_.size());
  for (Eigen::Index j = 0; j < ports && has_friction_; ++j) {
    const auto* dashpot = std::get_if<DashpotRemainder>(&ports_[static_cast<std::size_t>(j)].law);
    if (!dashpot || !std::isfinite(StepOfRate(*dashpot))) continue;
    const double slopes = dashpot->law.GreatestRate() - dashpot->law.LeastRate();
    for (Eigen::Index h = 1; h < ports_receptance_.rows(); ++h)
      if (static_cast<double>(h) * omega_ * std::abs(ports_receptance_(h, j + ports * j)) * slopes > 1) return true;
  }
  return false;
}

/// What is left of an iteration that shrinks steps by r is the step's share r / (1 - r). The other methods are taken
/// where r is next to one.
bool PortCycle::IsEnough(double change, double earlier, Method method, double tolerance) {
  constexpr double kSlow = 0.1;
  if (method != Method::kPlain) return change <= kSlow * tolerance;
  const double ratio = earlier > change ? std::sqrt(change / earlier) : 0.5;
  return change * ratio <= tolerance * (1 - ratio);
}

/// `change`: relative size of a step of the plain iteration; `before`, `earlier`: of the last two.
PortCycle::Method PortCycle::Choose(double change, double before, double earlier, double tolerance) const {
  constexpr double kGrowth = 4;
  if (iterations_ > 1 && change > kGrowth * before) return Newton();
  if (iterations_ <= 3) return Method::kPlain;
  // What some steps of the other methods cost.
  constexpr double kPatience = 20;
  const double left = 2 * std::log(change / tolerance) / std::log(earlier / change);
  return left > 0 && left < kPatience ? Method::kPlain : Newton();
}

/// Makes the plain iteration's step one of Newton's method, roughly; returns its relative size.
double PortCycle::Precondition() {
  // Slopes change little from there on.
  constexpr double kNear = 0.1;
  if (has_memory_) {
    step_ = NewtonStep(*this, step_, NewtonRows());
  } else {
    if (!preconditioner_ || preconditioned_ > kNear) preconditioner_.emplace(*this);
    step_ = preconditioner_->Of(step_);
  }
  preconditioned_ = SizeOf(step_) / SizeOf(extension_);
  return preconditioned_;
}

/// Newton's method, or what stands in for it.
PortCycle::Method PortCycle::Newton() const {
  return NewtonRows() == extension_.rows() ? Method::kNewton : Method::kAnderson;
}

/// How many harmonics Newton's method can afford, from the mean on.
Eigen::Index PortCycle::NewtonRows() const {
  constexpr Eigen::Index kMostWithoutMemory = 160;
  // For lack of another method that leads there.
  constexpr Eigen::Index kMostWithMemory = 480;
  const Eigen::Index active = (remainder_.cwiseAbs().colwise().maxCoeff().array() > 0).count();
  const Eigen::Index most = has_memory_ ? kMostWithMemory : kMostWithoutMemory;
  return std::min(extension_.rows(), (most / std::max<Eigen::Index>(active, 1) + 1) / 2);
}

/// Whether a knee, a stop or a lift takes part.
bool PortCycle::IsTouched() const {
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (UsesExtension(ports_[j].law) && !remainder_.col(static_cast<Eigen::Index>(j)).isZero(0)) return true;
  return false;
}

void PortCycle::AndersonStep(AndersonAcceleration& acceleration) {
  // Rates compare: what a harmonic weighs in SizeOf.
  Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(extension_.rows(), 0, harmonics());
  weights[0] = 1;
  const auto stacked = [&](const Eigen::MatrixXcd& harmonics) {
    const Eigen::MatrixXcd weighted = weights.asDiagonal() * harmonics;
    Eigen::VectorXd all(2 * weighted.size());
    all << weighted.real().reshaped(), weighted.imag().reshaped();
    return all;
  };
  const Eigen::VectorXd next = acceleration.Next(stacked(extension_), stacked(step_));
  const Eigen::Index half = extension_.size();
  extension_.real() = next.head(half).reshaped(extension_.rows(), extension_.cols());
  extension_.imag() = next.tail(half).reshaped(extension_.rows(), extension_.cols());
  extension_ = weights.cwiseInverse().asDiagonal() * extension_;
}

// A rate of amplitude V passes zero by 2 pi V / N from sample to sample.
bool PortCycle::ResolvesSteps() const {
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const double largest = rate_time_.col(static_cast<Eigen::Index>(j)).cwiseAbs().maxCoeff();
    const double per_sample = 2 * std::numbers::pi * largest / static_cast<double>(transform_.samples());
    if (per_sample > 2 * StepOfRate(ports_[j].law)) return false;
  }
  return true;
}

double PortCycle::Period() const { return 2 * std::numbers::pi / omega_; }

void PortCycle::FindRemainders() {
  FindRates(extension_, omega_, rate_);
  transform_.ToTime(rate_, rate_time_);
  if (uses_extension_) transform_.ToTime(extension_, extension_time_);
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (!HasMemory(ports_[j].law))
      MendedRemainders(ports_[j].law, kinks_[j], Samples(extension_time_, column), Samples(rate_time_, column),
                       Room(remainder_time_, column));
  }
  transform_.ToHarmonics(remainder_time_, remainder_);
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (HasMemory(ports_[j].law))
      remainder_.col(static_cast<Eigen::Index>(j)) = RemainderOf(ports_[j].law, static_cast<Eigen::Index>(j));
}

Eigen::MatrixXcd PortCycle::RemainderBy(const CycleTransform& transform) const {
  Eigen::MatrixXcd extension;
  Resize(extension_, transform.harmonics(), extension);
  Eigen::MatrixXd extensions;
  Eigen::MatrixXd rates;
  Eigen::MatrixXd remainders = Eigen::MatrixXd::Zero(transform.samples(), extension.cols());
  transform.ToTime(extension, extensions);
  transform.ToTime(RateOf(extension, omega_), rates);
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (HasMemory(ports_[j].law)) continue;
    Remainders(ports_[j].law, Samples(extensions, column), Samples(rates, column), Room(remainders, column));
  }
  Eigen::MatrixXcd harmonics;
  transform.ToHarmonics(remainders, harmonics);
  return harmonics;
}

/// Less the linear vehicle's share, exactly at each harmonic.
Eigen::VectorXcd PortCycle::RemainderOf(const PortLaw& law, Eigen::Index port) const {
  const SteppedMotion motion = StepsOf(port);
  Eigen::MatrixXd remainder(steps_.samples(), 1);
  CycleRemainders(law, Period(), Samples(motion.extension, 0), Samples(motion.rate, 0), Room(remainder, 0));
  Eigen::MatrixXcd harmonics;
  steps_.ToHarmonics(remainder, harmonics);
  for (Eigen::Index h = 0; h < extension_.rows(); ++h)
    harmonics(h, 0) -= LaggingShare(law, static_cast<double>(h) * omega_) * extension_(h, port);
  return harmonics;
}

PortCycle::SteppedMotion PortCycle::StepsOf(Eigen::Index port) const {
  SteppedMotion motion;
  steps_.ToTime(extension_.col(port), motion.extension);
  steps_.ToTime(RateOf(extension_.col(port), omega_), motion.rate);
  return motion;
}

/// The plain iteration's next step from here; returns its size, NaN where a law has no answer.
double PortCycle::FindStep() {
  if (!remainder_.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Index count = extension_.cols();
  step_ = driven_ - extension_;
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < count; ++i)
      step_.col(i) += ports_receptance_.col(i + count * j).cwiseProduct(remainder_.col(j));
  return SizeOf(step_);
}

/// Largest harmonic of any port's rate over w, or mean of its extension [m].
double PortCycle::SizeOf(const Eigen::MatrixXcd& extension) const {
  double largest = 0;
  for (Eigen::Index j = 0; j < extension.cols(); ++j)
    for (Eigen::Index h = 0; h < extension.rows(); ++h) {
      const double order = static_cast<double>(std::max<Eigen::Index>(h, 1));
      largest = std::max(largest, order * order * std::norm(extension(h, j)));
    }
  return std::sqrt(largest);
}

void PortCycle::TakeNewtonStep() {
  const double plain = SizeOf(step_);
  step_ = NewtonStep(*this, step_, NewtonRows());
  FollowNewton(plain);
}

/// Goes the way of Newton's step as far as the plain iteration's step shrinks, whose size from here is `step`.
void PortCycle::FollowNewton(double step) {
  constexpr int kHalvings = 6;
  const Eigen::MatrixXcd from = extension_;
  const Eigen::MatrixXcd newton = step_;
  double share = 1;
  for (int i = 0; i <= kHalvings; ++i, share /= 2) {
    extension_ = from + share * newton;
    FindRemainders();
    if (FindStep() < (1 - 0.1 * share) * step) return;
  }
}

}  // namespace fourpost
