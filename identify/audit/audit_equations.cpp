#include "identify/audit/audit_equations.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Above it, parts on soft mounts move on their own.
constexpr double kBalanceBelow_Hz = 3;
/// No coordinate moves by more per metre of a post.
constexpr double kMostMotion = 10;
/// a, b, c of a tyre.
constexpr Eigen::Index kOfTyre = 3;
/// By which the unknown c of w^2 is scaled to be of order 1 [rad/s].
constexpr double kUsualRate = 50;

Eigen::Index At(std::size_t index) { return static_cast<Eigen::Index>(index); }

double Omega(const AuditedRun& run, std::size_t frequency) {
  return 2 * std::numbers::pi * run.frequency_Hz[frequency];
}

bool IsThere(const Complex& reading) { return std::isfinite(reading.real()) && std::isfinite(reading.imag()); }

/// Largest reading of each device at a frequency.
double Loudest(const AuditedCar& car, const AuditedRun& run, Device device, std::size_t f) {
  double loudest = 0;
  for (std::size_t s = 0; s < car.sensors.size(); ++s)
    if (car.sensors[s].device == device && IsThere(run.motions(At(s), At(f))))
      loudest = std::max(loudest, std::abs(run.motions(At(s), At(f))));
  return loudest;
}

/// On the tyre [N/m], with its wheelpan as the unknown parameters make it.
Complex ForceOf(const AuditSubject& subject, const AuditedRun& run, std::size_t t, std::size_t f,
                const Eigen::VectorXd& unknowns) {
  const AuditedTyre& tyre = subject.car.tyres[t];
  const Complex force = run.forces(At(t), At(f));
  if (tyre.wheelpan_slope.size() == 0) return force;
  const auto changes = unknowns.segment(kOfTyre * At(subject.car.tyres.size()), subject.car.reach.size());
  return force + std::pow(Omega(run, f), 2) * tyre.wheelpan_slope.dot(changes) * run.posts(At(tyre.post), At(f));
}

Eigen::VectorXcd WeightedReadings(const AuditSubject& subject, const std::vector<std::size_t>& sensors,
                                  const std::vector<std::size_t>& tyres, const Eigen::VectorXd& sd, std::size_t r,
                                  std::size_t f, const Eigen::VectorXd& unknowns) {
  const AuditedRun& run = subject.runs[r];
  Eigen::VectorXcd readings(sd.size());
  Eigen::Index row = 0;
  for (const std::size_t s : sensors) readings[row++] = run.motions(At(s), At(f));
  const double omega = Omega(run, f);
  for (const std::size_t t : tyres) {
    const AuditedTyre& tyre = subject.car.tyres[t];
    const double* of = unknowns.data() + kOfTyre * At(t);
    const double per = omega / kUsualRate;
    const Complex compliance = tyre.compliance * Complex(of[0] - of[2] * per * per, of[1] * per);
    readings[row++] = run.posts(At(tyre.post), At(f)) - compliance * ForceOf(subject, run, t, f, unknowns);
  }
  return readings.array() / sd.array().cast<Complex>();
}

}  // namespace

Eigen::RowVectorXd MotionRow(const AuditedSensor& sensor, double omega) {
  return sensor.motion - sensor.tilt / (omega * omega);
}

double ReadingSd(const AuditedCar& car, const AuditedRun& run, const RigTolerance& tolerance, std::size_t s,
                 std::size_t f) {
  return std::hypot(run.motion_sd(At(s), At(f)), tolerance.reading * std::abs(run.motions(At(s), At(f))),
                    tolerance.floor * Loudest(car, run, car.sensors[s].device, f));
}

AuditEquations::AuditEquations(const AuditSubject& subject, const RigTolerance& tolerance) : car_(subject.car) {
  unknowns_ = kOfTyre * At(car_.tyres.size()) + car_.reach.size();
  if (car_.balance) unknowns_ += 1 + 2 * At(car_.balance->others.size());
  for (std::size_t r = 0; r < subject.runs.size(); ++r)
    for (std::size_t f = 0; f < subject.runs[r].frequency_Hz.size(); ++f) AddPoint(subject, tolerance, r, f);
  AddRows(subject);
}

void AuditEquations::AddPoint(const AuditSubject& subject, const RigTolerance& tolerance, std::size_t r,
                              std::size_t f) {
  const AuditedRun& run = subject.runs[r];
  const double omega = Omega(run, f);
  Point point{.run = r, .frequency = f};
  std::vector<double> sd;
  std::vector<Eigen::RowVectorXd> shape;
  for (std::size_t s = 0; s < car_.sensors.size(); ++s) {
    const Complex reading = run.motions(At(s), At(f));
    if (!IsThere(reading)) continue;
    point.sensors.push_back(s);
    shape.push_back(MotionRow(car_.sensors[s], omega));
    sd.push_back(ReadingSd(car_, run, tolerance, s, f));
  }
  for (std::size_t t = 0; t < car_.tyres.size(); ++t) {
    if (!IsThere(run.forces(At(t), At(f)))) continue;
    point.tyres.push_back(t);
    shape.push_back(car_.tyres[t].foot);
    const double squeeze = car_.tyres[t].compliance * std::abs(run.forces(At(t), At(f)));
    sd.push_back(std::hypot(car_.tyres[t].compliance * run.force_sd(At(t), At(f)), tolerance.reading * squeeze,
                            tolerance.floor * std::abs(run.posts(At(car_.tyres[t].post), At(f)))));
  }
  const Eigen::Index rows = At(shape.size());
  const Eigen::Index n = car_.coordinates;
  point.sd = Eigen::Map<const Eigen::VectorXd>(sd.data(), rows);
  point.shape.resize(rows, n);
  for (Eigen::Index i = 0; i < rows; ++i) point.shape.row(i) = shape[static_cast<std::size_t>(i)] / point.sd[i];
  // With a bound on coordinates that no sensor sees.
  Eigen::MatrixXd bounded(rows + n, n);
  bounded << point.shape, Eigen::MatrixXd::Identity(n, n) / kMostMotion;
  const Eigen::MatrixXd inverse = LeastNorm(bounded, 1e-12).PseudoInverse();
  point.to_coordinates = inverse.leftCols(rows);
  point.to_rest = Eigen::MatrixXd::Identity(rows, rows) - point.shape * point.to_coordinates;
  degrees_ += 2 * point.to_rest.trace();
  AddBalance(subject, tolerance, inverse, point);
  if (point.balance_sd > 0) degrees_ += 2;
  points_.push_back(std::move(point));
}

void AuditEquations::AddBalance(const AuditSubject& subject, const RigTolerance& tolerance,
                                const Eigen::MatrixXd& deviations, Point& point) const {
  const AuditedRun& run = subject.runs[point.run];
  if (!car_.balance || run.frequency_Hz[point.frequency] > kBalanceBelow_Hz || point.tyres.size() < car_.tyres.size())
    return;
  const double omega = Omega(run, point.frequency);
  double of_forces = 0;
  double forces = 0;
  for (std::size_t t = 0; t < car_.tyres.size(); ++t) {
    const double lever = std::abs(car_.balance->lever[At(t)]) / (omega * omega);
    of_forces = std::hypot(of_forces, lever * run.force_sd(At(t), At(point.frequency)));
    forces += lever * std::abs(run.forces(At(t), At(point.frequency)));
  }
  const Eigen::RowVectorXd of_motion = (car_.balance->inertia - car_.balance->gravity / (omega * omega)) * deviations;
  point.balance_sd = std::hypot(of_forces, of_motion.norm(), tolerance.reading * forces);
}

void AuditEquations::AddRows(const AuditSubject& subject) {
  const auto twice = [&](const Row& row) { rows_.insert(rows_.end(), 2, row); };
  for (const Point& point : points_) {
    Eigen::Index next = 0;
    for (const std::size_t s : point.sensors)
      twice({Row::Kind::kSensor, s, point.run, point.frequency, point.sd[next++]});
    for (const std::size_t t : point.tyres) twice({Row::Kind::kTyre, t, point.run, point.frequency, point.sd[next++]});
    if (point.balance_sd > 0) twice({Row::Kind::kBalance, 0, point.run, point.frequency, point.balance_sd});
  }
  if (subject.weight) rows_.push_back({Row::Kind::kWeight, 0, 0, 0, subject.weight->sd});
  for (Eigen::Index j = 0; j < car_.reach.size(); ++j)
    rows_.push_back({Row::Kind::kPrior, static_cast<std::size_t>(j), 0, 0, car_.reach[j]});
  degrees_ += (subject.weight ? 1.0 : 0.0) + static_cast<double>(car_.reach.size());
}

Eigen::RowVectorXd AuditEquations::BalanceRow(const Eigen::VectorXd& unknowns, double omega) const {
  const AuditedBalance& balance = *car_.balance;
  const Eigen::Index first = kOfTyre * At(car_.tyres.size());
  const double square = std::pow(omega / kUsualRate, 2);
  const auto shares = unknowns.tail(1 + 2 * At(balance.others.size()));
  Eigen::RowVectorXd inertia = (1 + shares[0] * square) * balance.inertia;
  Eigen::RowVectorXd gravity = balance.gravity;
  for (std::size_t k = 0; k < balance.others.size(); ++k)
    inertia += (shares[1 + 2 * At(k)] + shares[2 + 2 * At(k)] * square) * balance.others[k];
  for (std::size_t j = 0; j < balance.inertia_slope.size(); ++j) {
    inertia += unknowns[first + At(j)] * balance.inertia_slope[j];
    gravity += unknowns[first + At(j)] * balance.gravity_slope[j];
  }
  return inertia - gravity / (omega * omega);
}

Eigen::VectorXd AuditEquations::Misclosures(const AuditSubject& subject, const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd out(At(rows_.size()));
  Eigen::Index next = 0;
  const auto put = [&](const Complex& value) {
    out[next++] = value.real();
    out[next++] = value.imag();
  };
  const Eigen::Index parameters = car_.reach.size();
  const auto changes = unknowns.segment(kOfTyre * At(car_.tyres.size()), parameters);
  for (const Point& point : points_) {
    const AuditedRun& run = subject.runs[point.run];
    const double omega = Omega(run, point.frequency);
    Eigen::VectorXcd readings =
        WeightedReadings(subject, point.sensors, point.tyres, point.sd, point.run, point.frequency, unknowns);
    Eigen::VectorXcd q = point.to_coordinates * readings;
    for (std::size_t i = 0; i < point.sensors.size(); ++i) {
      const AuditedSensor& moved = subject.car.sensors[point.sensors[i]];
      const AuditedSensor& here = car_.sensors[point.sensors[i]];
      if (&moved.motion == &here.motion || moved.motion == here.motion) continue;
      readings[At(i)] -= ((moved.motion - here.motion).cast<Complex>() * q)(0) / point.sd[At(i)];
      q = point.to_coordinates * readings;
    }
    const Eigen::VectorXcd rest = point.to_rest * readings;
    for (const Complex& value : rest) put(value);
    if (!(point.balance_sd > 0)) continue;
    Complex sum = (BalanceRow(unknowns, omega).cast<Complex>() * q)(0);
    for (std::size_t t = 0; t < car_.tyres.size(); ++t)
      sum += car_.balance->lever[At(t)] * ForceOf(subject, run, t, point.frequency, unknowns) / (omega * omega);
    put(sum / point.balance_sd);
  }
  if (subject.weight)
    out[next++] =
        (subject.weight->measured - subject.weight->modelled - subject.weight->slope.dot(changes)) / subject.weight->sd;
  for (Eigen::Index j = 0; j < parameters; ++j) out[next++] = changes[j] / car_.reach[j];
  return out;
}

}  // namespace fourpost
