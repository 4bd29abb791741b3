#include "vehicles/response/port_cycle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include <Eigen/LU>

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

std::span<const double> Samples(const Eigen::MatrixXd& signals, Eigen::Index column) {
  if (signals.size() == 0) return {};
  return {signals.col(column).data(), static_cast<std::size_t>(signals.rows())};
}

std::span<double> Room(Eigen::MatrixXd& signals, Eigen::Index column) {
  return {signals.col(column).data(), static_cast<std::size_t>(signals.rows())};
}

/// With harmonics 0..H, where those that are missing are zero.
Eigen::MatrixXcd Resized(const Eigen::MatrixXcd& harmonics, Eigen::Index last) {
  Eigen::MatrixXcd resized = Eigen::MatrixXcd::Zero(last + 1, harmonics.cols());
  const Eigen::Index known = std::min(harmonics.rows(), resized.rows());
  resized.topRows(known) = harmonics.topRows(known);
  return resized;
}

/// Of the signals whose harmonics are given.
Eigen::MatrixXcd RateOf(const Eigen::MatrixXcd& extension, double omega) {
  Eigen::MatrixXcd rate(extension.rows(), extension.cols());
  for (Eigen::Index j = 0; j < extension.cols(); ++j)
    for (Eigen::Index h = 0; h < extension.rows(); ++h) {
      const double w = static_cast<double>(h) * omega;
      rate(h, j) = Complex(-w * extension(h, j).imag(), w * extension(h, j).real());
    }
  return rate;
}

/// Harmonics 0, 1 .. H of a signal s(t) from m = -2 H .. 2 H of a real one: s = sum over m of two-sided c_m.
class TwoSided {
 public:
  explicit TwoSided(const Eigen::VectorXcd& harmonics) : harmonics_(harmonics) {}
  Complex operator()(Eigen::Index m) const {
    if (m == 0) return harmonics_[0];
    return 0.5 * (m > 0 ? harmonics_[m] : std::conj(harmonics_[-m]));
  }

 private:
  const Eigen::VectorXcd& harmonics_;
};

/// Real unknowns of the harmonics 0..H: the mean, then real and imaginary parts.
Eigen::VectorXd Unfolded(const Eigen::VectorXcd& harmonics) {
  Eigen::VectorXd real(2 * harmonics.size() - 1);
  real << harmonics.real(), harmonics.imag().tail(harmonics.size() - 1);
  return real;
}
Eigen::VectorXcd Folded(const Eigen::VectorXd& real) {
  const Eigen::Index count = (real.size() + 1) / 2;
  Eigen::VectorXcd harmonics(count);
  harmonics.real() = real.head(count);
  harmonics.imag()[0] = 0;
  harmonics.imag().tail(count - 1) = real.tail(count - 1);
  return harmonics;
}

/// The real matrix of E -> direct E + conjugate conj(E), on Unfolded().
Eigen::MatrixXd RealMatrix(const Eigen::MatrixXcd& direct, const Eigen::MatrixXcd& conjugate) {
  const Eigen::Index count = direct.rows();
  const Eigen::Index rest = count - 1;
  const Eigen::MatrixXcd sum = direct + conjugate;
  const Eigen::MatrixXcd difference = direct - conjugate;
  Eigen::MatrixXd real(count + rest, count + rest);
  real << sum.real(), -difference.imag().rightCols(rest), sum.imag().bottomRows(rest),
      difference.real().bottomRightCorner(rest, rest);
  return real;
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
  has_memory_ = std::any_of(ports.begin(), ports.end(),
                            [](const Port& port) { return std::holds_alternative<HydraulicRemainder>(port.law); });
  remainder_time_.setZero(transform_.samples(), static_cast<Eigen::Index>(ports.size()));
}

bool PortCycle::Solve(double omega, const Eigen::MatrixXcd& driven, const Eigen::MatrixXcd& start, double tolerance,
                      int max_iterations) {
  omega_ = omega;
  driven_ = Resized(driven, harmonics());
  extension_ = Resized(start, harmonics());
  receptance_.Ports(omega, harmonics(), ports_receptance_);
  iterations_ = 0;
  FindRemainders();
  if (ports_.empty()) return true;
  std::optional<AndersonAcceleration> acceleration;
  Method method = IsTouched() ? Newton() : Method::kPlain;
  // The last two sizes: motion and its reaction may take turns.
  double before = 0;
  double earlier = 0;
  while (true) {
    const double change = FindStep() / SizeOf(extension_);
    if (!std::isfinite(change)) return false;
    if (IsEnough(change, earlier, method, tolerance)) return true;
    if (iterations_ == max_iterations) return false;
    ++iterations_;
    constexpr double kGrowth = 4;
    if (method == Method::kPlain && iterations_ > 1 && change > kGrowth * before) method = Newton();
    if (method == Method::kPlain && iterations_ > 3) method = Choose(change, earlier, tolerance);
    earlier = std::exchange(before, change);
    switch (method) {
      case Method::kPlain: extension_ += step_; break;
      case Method::kNewton: NewtonStep(); continue;
      case Method::kAnderson:
        if (!acceleration) acceleration.emplace(kHistory);
        if (has_memory_) FindNewtonStep();
        AndersonStep(*acceleration);
        break;
    }
    FindRemainders();
  }
}

/// What is left of an iteration that shrinks steps by r is the step's share r / (1 - r). The other methods are taken
/// where r is next to one.
bool PortCycle::IsEnough(double change, double earlier, Method method, double tolerance) {
  constexpr double kSlow = 0.1;
  if (method != Method::kPlain) return change <= kSlow * tolerance;
  const double ratio = earlier > change ? std::sqrt(change / earlier) : 0.5;
  return change * ratio <= tolerance * (1 - ratio);
}

/// `change`: relative size of a step of the plain iteration; `earlier`: of that two steps before.
PortCycle::Method PortCycle::Choose(double change, double earlier, double tolerance) const {
  // What some steps of the other methods cost.
  constexpr double kPatience = 20;
  const double left = 2 * std::log(change / tolerance) / std::log(earlier / change);
  return left > 0 && left < kPatience ? Method::kPlain : Newton();
}

/// Newton's method, or what stands in for it.
PortCycle::Method PortCycle::Newton() const {
  return NewtonRows() == extension_.rows() ? Method::kNewton : Method::kAnderson;
}

/// How many harmonics Newton's method can afford, from the mean on.
Eigen::Index PortCycle::NewtonRows() const {
  constexpr Eigen::Index kMostUnknowns = 160;
  // For lack of another method that leads there.
  constexpr Eigen::Index kMostWithMemory = 480;
  const Eigen::Index active = (remainder_.cwiseAbs().colwise().maxCoeff().array() > 0).count();
  const Eigen::Index most = has_memory_ ? kMostWithMemory : kMostUnknowns;
  return std::min(extension_.rows(), (most / std::max<Eigen::Index>(active, 1) + 1) / 2);
}

/// Whether a knee, a stop or a lift takes part: then the plain iteration may leave the motion that it starts from.
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
  transform_.ToTime(RateOf(extension_, omega_), rate_time_);
  if (uses_extension_) transform_.ToTime(extension_, extension_time_);
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (!std::holds_alternative<HydraulicRemainder>(ports_[j].law))
      MendedRemainders(ports_[j].law, kinks_[j], Samples(extension_time_, column), Samples(rate_time_, column),
                       Room(remainder_time_, column));
  }
  transform_.ToHarmonics(remainder_time_, remainder_);
  for (std::size_t j = 0; j < ports_.size(); ++j)
    if (const auto* hydraulic = std::get_if<HydraulicRemainder>(&ports_[j].law))
      remainder_.col(static_cast<Eigen::Index>(j)) = RemainderOf(*hydraulic, static_cast<Eigen::Index>(j));
}

Eigen::MatrixXcd PortCycle::RemainderBy(const CycleTransform& transform) const {
  const Eigen::MatrixXcd extension = Resized(extension_, transform.harmonics());
  Eigen::MatrixXd extensions;
  Eigen::MatrixXd rates;
  Eigen::MatrixXd remainders = Eigen::MatrixXd::Zero(transform.samples(), extension.cols());
  transform.ToTime(extension, extensions);
  transform.ToTime(RateOf(extension, omega_), rates);
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (std::holds_alternative<HydraulicRemainder>(ports_[j].law)) continue;
    Remainders(ports_[j].law, Samples(extensions, column), Samples(rates, column), Room(remainders, column));
  }
  Eigen::MatrixXcd harmonics;
  transform.ToHarmonics(remainders, harmonics);
  return harmonics;
}

/// Less the linear vehicle's share, exactly at each harmonic.
Eigen::VectorXcd PortCycle::RemainderOf(const HydraulicRemainder& law, Eigen::Index port) const {
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

/// With two-sided harmonics a of the slope by extension and b of that by rate:
///   dR_l = sum over h > 0 of (a_{l-h} + i h w b_{l-h}) dE_h + (a_{l+h} - i h w b_{l+h}) conj(dE_h), and 2 a_l dE_0
/// for l > 0, half of it for l = 0.
std::vector<PortCycle::Coupling> PortCycle::Couplings() const {
  Eigen::MatrixXd by_extension(transform_.samples(), 1);
  Eigen::MatrixXd by_rate(transform_.samples(), 1);
  Eigen::MatrixXcd of_extension;
  Eigen::MatrixXcd of_rate;
  const Eigen::Index size = NewtonRows();
  const CycleTransform& transform =
      CycleTransform::Shared(2 * static_cast<int>(size - 1), static_cast<int>(transform_.samples()));
  std::vector<Coupling> couplings;
  for (std::size_t j = 0; j < ports_.size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (const auto* hydraulic = std::get_if<HydraulicRemainder>(&ports_[j].law)) {
      couplings.push_back(CycleCoupling(*hydraulic, column, size));
      continue;
    }
    RemainderSlopes(ports_[j].law, Samples(extension_time_, column), Samples(rate_time_, column), Room(by_extension, 0),
                    Room(by_rate, 0));
    if (by_extension.isZero(0) && by_rate.isZero(0)) continue;
    transform.ToHarmonics(by_extension, of_extension);
    transform.ToHarmonics(by_rate, of_rate);
    const Eigen::VectorXcd extension_column = of_extension.col(0);
    const Eigen::VectorXcd rate_column = of_rate.col(0);
    const TwoSided a(extension_column);
    const TwoSided b(rate_column);
    Coupling coupling{column, Eigen::MatrixXcd::Zero(size, size), Eigen::MatrixXcd::Zero(size, size)};
    for (Eigen::Index l = 0; l < size; ++l) {
      const double share = l > 0 ? 1 : 0.5;
      coupling.direct(l, 0) = 2 * share * a(l);
      for (Eigen::Index h = 1; h < size; ++h) {
        const Complex iw(0, static_cast<double>(h) * omega_);
        coupling.direct(l, h) = share * (a(l - h) + iw * b(l - h));
        coupling.conjugate(l, h) = share * (a(l + h) - iw * b(l + h));
      }
    }
    couplings.push_back(std::move(coupling));
  }
  return couplings;
}

/// By the remainder's change with the real and the imaginary part of each harmonic, r and i:
///   dR = r dRe(E) + i dIm(E) = (r - j i) / 2 dE + (r + j i) / 2 conj(dE),   j: the imaginary unit
PortCycle::Coupling PortCycle::CycleCoupling(const HydraulicRemainder& law, Eigen::Index port,
                                             Eigen::Index size) const {
  const Complex imaginary(0, 1);
  Eigen::MatrixXcd units(size, 2 * size - 1);
  units << Eigen::MatrixXcd::Identity(size, size),
      imaginary * Eigen::MatrixXcd::Identity(size, size).rightCols(size - 1);
  const Eigen::VectorXcd rates =
      Complex(0, omega_) * Eigen::VectorXd::LinSpaced(size, 0, static_cast<double>(size - 1));
  const CycleTransform& steps = CycleTransform::Shared(static_cast<int>(size - 1), static_cast<int>(steps_.samples()));
  Eigen::MatrixXd extensions;
  Eigen::MatrixXd extension_rates;
  Eigen::MatrixXd remainders;
  steps.ToTime(units, extensions);
  steps.ToTime(rates.asDiagonal() * units, extension_rates);
  const SteppedMotion motion = StepsOf(port);
  CycleChanges(law, Period(), Samples(motion.extension, 0), Samples(motion.rate, 0), extensions, extension_rates,
               remainders);
  Eigen::MatrixXcd changes;
  steps.ToHarmonics(remainders, changes);
  const auto by_real = changes.middleCols(1, size - 1);
  const auto by_imaginary = changes.rightCols(size - 1);
  Coupling coupling{port, Eigen::MatrixXcd::Zero(size, size), Eigen::MatrixXcd::Zero(size, size)};
  coupling.direct.col(0) = changes.col(0);
  coupling.direct.rightCols(size - 1) = 0.5 * (by_real - imaginary * by_imaginary);
  coupling.conjugate.rightCols(size - 1) = 0.5 * (by_real + imaginary * by_imaginary);
  for (Eigen::Index h = 0; h < size; ++h) coupling.direct(h, h) -= LaggingShare(law, static_cast<double>(h) * omega_);
  return coupling;
}

void PortCycle::NewtonStep() {
  const double plain = SizeOf(step_);
  FindNewtonStep();
  FollowNewton(plain);
}

/// Solves dE - receptance dR = step for the ports whose remainders change, the others follow, and so do the harmonics
/// beyond those it can afford.
void PortCycle::FindNewtonStep() {
  const std::vector<Coupling> couplings = Couplings();
  const Eigen::Index count = extension_.cols();
  const Eigen::Index rows = NewtonRows();
  const Eigen::Index unknowns = 2 * rows - 1;
  const auto active = static_cast<Eigen::Index>(couplings.size());
  const auto Through = [&](Eigen::Index i, const Coupling& coupling) {
    const auto receptance = ports_receptance_.col(i + count * coupling.port).head(rows).asDiagonal();
    return RealMatrix(receptance * coupling.direct, receptance * coupling.conjugate);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(active * unknowns, active * unknowns);
  Eigen::VectorXd right(active * unknowns);
  for (Eigen::Index p = 0; p < active; ++p) {
    const Eigen::Index port = couplings[static_cast<std::size_t>(p)].port;
    right.segment(p * unknowns, unknowns) = Unfolded(step_.col(port).head(rows));
    for (Eigen::Index q = 0; q < active; ++q)
      matrix.block(p * unknowns, q * unknowns, unknowns, unknowns) -=
          Through(port, couplings[static_cast<std::size_t>(q)]);
  }
  const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
  Eigen::MatrixXcd newton = step_;
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index q = 0; q < active; ++q)
      newton.col(i).head(rows) +=
          Folded(Through(i, couplings[static_cast<std::size_t>(q)]) * solution.segment(q * unknowns, unknowns));
  step_.swap(newton);
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
