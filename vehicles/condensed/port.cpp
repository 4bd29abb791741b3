#include "vehicles/condensed/port.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/laws/dahl_cycle.h"
#include "vehicles/laws/hydraulic_cycle.h"

namespace fourpost {
namespace {

using Signal = std::span<const double>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void Remainders(const DashpotRemainder& port, Signal, Signal v, std::span<double> remainder) {
  port.law.Forces(v, remainder);
  for (std::size_t k = 0; k < v.size(); ++k) remainder[k] -= port.rate * v[k];
}

void Remainders(const SpringRemainder& port, Signal x, Signal, std::span<double> remainder) {
  for (std::size_t k = 0; k < x.size(); ++k) remainder[k] = port.law.Force(x[k]) - port.stiffness * x[k];
}

double Compression(const LiftoffRemainder& port, double x, double v) {
  return port.preload + port.stiffness * x + port.damping * v;
}

void Remainders(const LiftoffRemainder& port, Signal x, Signal v, std::span<double> remainder) {
  for (std::size_t k = 0; k < x.size(); ++k) remainder[k] = std::max(0.0, -Compression(port, x[k], v[k]));
}

double Compression(const TyreRemainder& port, double x, double v) { return port.law.Force(x) + port.damping * v; }

void Remainders(const TyreRemainder& port, Signal x, Signal v, std::span<double> remainder) {
  for (std::size_t k = 0; k < x.size(); ++k)
    remainder[k] =
        std::max(0.0, Compression(port, x[k], v[k])) - port.law.load - port.stiffness * x[k] - port.damping * v[k];
}

std::vector<double> Compressions(const auto& port, Signal x, Signal v) {
  std::vector<double> compressions(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) compressions[k] = Compression(port, x[k], v[k]);
  return compressions;
}

std::vector<double> TyreForces(const PortLaw& law, Signal x, Signal v) {
  if (const auto* tyre = std::get_if<TyreRemainder>(&law)) return Compressions(*tyre, x, v);
  return Compressions(std::get<LiftoffRemainder>(law), x, v);
}

/// Adds what the samples next to a passage of the kink between k and the sample after miss.
void MendPassage(const PortKink& kink, Signal signal, std::size_t k, std::span<double> remainder) {
  const std::size_t count = signal.size();
  const std::size_t after = k + 1 < count ? k + 1 : 0;
  const double share = (kink.at - signal[k]) / (signal[after] - signal[k]);
  // From central differences, so that it vanishes where the signal only touches the kink: whether a sample lies
  // beyond must not decide.
  const double step = 0.5 * ((1 - share) * (signal[after] - signal[k > 0 ? k - 1 : count - 1]) +
                             share * (signal[after + 1 < count ? after + 1 : 0] - signal[k]));
  const double missing = 0.5 * kink.jump * std::abs(step) * (share * share - share + 1.0 / 6);
  remainder[k] += (1 - share) * missing;
  remainder[after] += share * missing;
}

void MendKink(const PortKink& kink, Signal signal, std::span<double> remainder) {
  bool above = signal.back() > kink.at;
  std::size_t before = signal.size() - 1;
  for (std::size_t k = 0; k < signal.size(); before = k++) {
    if ((signal[k] > kink.at) == above) continue;
    above = !above;
    MendPassage(kink, signal, before, remainder);
  }
}

/// Where between two samples, 0 .. 1, a signal passes a value, by the parabola through them with the mean bend at both.
double ShareOfCell(double at, double before, double from, double to, double after) {
  const double rise = to - from;
  const double share = (at - from) / rise;
  const double bend = 0.5 * (after - to - from + before);
  return std::clamp(share + 0.5 * share * (1 - share) * bend / rise, 0.0, 1.0);
}

/// `jump(k, after, share)`: of the slopes, towards larger values of the signal, a share of the way from one sample to
/// another.
void MendJumps(double at, const auto& jump, Signal signal, std::span<double> slopes) {
  const std::size_t count = signal.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t after = k + 1 < count ? k + 1 : 0;
    if ((signal[k] > at) == (signal[after] > at)) continue;
    const double share = ShareOfCell(at, signal[k > 0 ? k - 1 : count - 1], signal[k], signal[after],
                                     signal[after + 1 < count ? after + 1 : 0]);
    const double towards_larger = jump(k, after, share);
    const double in_time = signal[after] > signal[k] ? towards_larger : -towards_larger;
    const double missing = in_time * (0.5 - share);
    const double missing_of_rise = 0.5 * in_time * (share * share - share + 1.0 / 6);
    const double to_after = missing_of_rise + share * missing;
    slopes[k] += missing - to_after;
    slopes[after] += to_after;
  }
}

void MendJump(double at, double jump, Signal signal, std::span<double> slopes) {
  MendJumps(
      at, [jump](std::size_t, std::size_t, double) { return jump; }, signal, slopes);
}

/// Where a tyre leaves its platform or meets it.
void MendContact(const LiftoffRemainder& tyre, Signal x, Signal v, std::span<double> by_extension,
                 std::span<double> by_rate) {
  const std::vector<double> compressions = Compressions(tyre, x, v);
  MendJump(0, tyre.stiffness, compressions, by_extension);
  MendJump(0, tyre.damping, compressions, by_rate);
}
void MendContact(const TyreRemainder& tyre, Signal x, Signal v, std::span<double> by_extension,
                 std::span<double> by_rate) {
  const std::vector<double> compressions = Compressions(tyre, x, v);
  const auto rate = [&](std::size_t k, std::size_t after, double share) {
    return tyre.law.Rate((1 - share) * x[k] + share * x[after]);
  };
  MendJumps(0, rate, compressions, by_extension);
  MendJump(0, tyre.damping, compressions, by_rate);
}

void Remainders(const HydraulicRemainder&, Signal, Signal, std::span<double> remainder) {
  std::fill(remainder.begin(), remainder.end(), kNan);
}
void Remainders(const FrictionRemainder&, Signal, Signal, std::span<double> remainder) {
  std::fill(remainder.begin(), remainder.end(), kNan);
}

struct Slopes {
  double by_extension = 0;
  double by_rate = 0;
};
Slopes SlopesOf(const DashpotRemainder& port, double, double v) { return {0, port.law.Slope(v) - port.rate}; }
Slopes SlopesOf(const SpringRemainder& port, double x, double) { return {port.law.Slope(x) - port.stiffness, 0}; }
Slopes SlopesOf(const LiftoffRemainder& port, double x, double v) {
  if (Compression(port, x, v) >= 0) return {};
  return {-port.stiffness, -port.damping};
}

Slopes SlopesOf(const TyreRemainder& port, double x, double v) {
  if (Compression(port, x, v) < 0) return {-port.stiffness, -port.damping};
  return {port.law.Rate(x) - port.stiffness, 0};
}

Slopes SlopesOf(const HydraulicRemainder&, double, double) { return {kNan, kNan}; }
Slopes SlopesOf(const FrictionRemainder&, double, double) { return {kNan, kNan}; }

/// A cycle at its samples.
struct Cycle {
  double period = 0;
  Signal extension;
  Signal rate;
};

void CycleRemainders(const HydraulicRemainder& port, const Cycle& cycle, std::span<double> remainder) {
  const std::optional<HydraulicCycle> found =
      HydraulicCycle::Solve(port.law, cycle.period, cycle.extension, cycle.rate);
  for (std::size_t k = 0; k < remainder.size(); ++k)
    remainder[k] = found ? found->states()[k].tension - port.share.stiffness * cycle.extension[k] : kNan;
}
void CycleRemainders(const FrictionRemainder& port, const Cycle& cycle, std::span<double> remainder) {
  const DahlCycle found(port.law, cycle.extension);
  std::copy(found.forces().begin(), found.forces().end(), remainder.begin());
}
void CycleRemainders(const auto&, const Cycle&, std::span<double> remainder) {
  std::fill(remainder.begin(), remainder.end(), kNan);
}

std::span<double> ColumnOf(Eigen::MatrixXd& matrix, Eigen::Index j) {
  return {matrix.col(j).data(), static_cast<std::size_t>(matrix.rows())};
}
Signal ColumnOf(const Eigen::MatrixXd& matrix, Eigen::Index j) {
  return {matrix.col(j).data(), static_cast<std::size_t>(matrix.rows())};
}

void CycleChanges(const HydraulicRemainder& port, const Cycle& cycle, const Eigen::MatrixXd& extensions,
                  const Eigen::MatrixXd& rates, Eigen::MatrixXd& remainders) {
  const std::optional<HydraulicCycle> found =
      HydraulicCycle::Solve(port.law, cycle.period, cycle.extension, cycle.rate);
  if (!found) return;
  for (Eigen::Index j = 0; j < extensions.cols(); ++j)
    found->Change(ColumnOf(extensions, j), ColumnOf(rates, j), ColumnOf(remainders, j));
  remainders -= port.share.stiffness * extensions;
}
void CycleChanges(const FrictionRemainder& port, const Cycle& cycle, const Eigen::MatrixXd& extensions,
                  const Eigen::MatrixXd&, Eigen::MatrixXd& remainders) {
  const DahlCycle found(port.law, cycle.extension);
  for (Eigen::Index j = 0; j < extensions.cols(); ++j) found.Change(ColumnOf(extensions, j), ColumnOf(remainders, j));
}
void CycleChanges(const auto&, const Cycle&, const Eigen::MatrixXd&, const Eigen::MatrixXd&, Eigen::MatrixXd&) {}

/// A direction of s as one of [s x].
Eigen::VectorXd OnMotion(const CondensedModel& model, const Eigen::VectorXd& direction) {
  Eigen::VectorXd all =
      Eigen::VectorXd::Zero(direction.size() + static_cast<Eigen::Index>(model.SeriesDampers().size()));
  all.head(direction.size()) = direction;
  return all;
}

double At(Signal signal, std::size_t k) { return signal.empty() ? 0 : signal[k]; }

}  // namespace

bool UsesExtension(const PortLaw& law) { return !std::holds_alternative<DashpotRemainder>(law); }

bool HasMemory(const PortLaw& law) {
  return std::holds_alternative<HydraulicRemainder>(law) || std::holds_alternative<FrictionRemainder>(law);
}

double StepOfRate(const PortLaw& law) {
  const auto* dashpot = std::get_if<DashpotRemainder>(&law);
  return dashpot ? dashpot->law.StepSpeed() : std::numeric_limits<double>::infinity();
}

void Remainders(const PortLaw& law, Signal extension, Signal rate, std::span<double> remainder) {
  std::visit([&](const auto& port) { Remainders(port, extension, rate, remainder); }, law);
}

std::vector<PortKink> KinksOf(const PortLaw& law) {
  std::vector<PortKink> kinks;
  if (const auto* dashpot = std::get_if<DashpotRemainder>(&law)) {
    for (const DashpotLaw::Kink& kink : dashpot->law.Kinks())
      kinks.push_back({PortKink::Signal::kRate, kink.speed, kink.jump});
  } else if (const auto* spring = std::get_if<SpringRemainder>(&law)) {
    for (const SpringLaw::Knee& knee : spring->law.knees)
      kinks.push_back({PortKink::Signal::kExtension, knee.at, knee.side * knee.stiffness});
  } else if (std::holds_alternative<LiftoffRemainder>(law) || std::holds_alternative<TyreRemainder>(law)) {
    kinks.push_back({PortKink::Signal::kCompression, 0, 1});
  }
  return kinks;
}

void MendedRemainders(const PortLaw& law, std::span<const PortKink> kinks, Signal extension, Signal rate,
                      std::span<double> remainder) {
  Remainders(law, extension, rate, remainder);
  for (const PortKink& kink : kinks) {
    if (kink.jump == 0) continue;
    switch (kink.signal) {
      case PortKink::Signal::kExtension: MendKink(kink, extension, remainder); break;
      case PortKink::Signal::kRate: MendKink(kink, rate, remainder); break;
      case PortKink::Signal::kCompression: MendKink(kink, TyreForces(law, extension, rate), remainder);
    }
  }
}

void CycleRemainders(const PortLaw& law, double period, Signal extension, Signal rate, std::span<double> remainder) {
  std::visit([&](const auto& port) { CycleRemainders(port, Cycle{period, extension, rate}, remainder); }, law);
}

void CycleChanges(const PortLaw& law, double period, Signal extension, Signal rate,
                  const Eigen::MatrixXd& extension_changes, const Eigen::MatrixXd& rate_changes,
                  Eigen::MatrixXd& remainder_changes) {
  remainder_changes.setConstant(extension_changes.rows(), extension_changes.cols(), kNan);
  const Cycle cycle{period, extension, rate};
  std::visit([&](const auto& port) { CycleChanges(port, cycle, extension_changes, rate_changes, remainder_changes); },
             law);
}

std::complex<double> LaggingShare(const PortLaw& law, double w) {
  const auto* port = std::get_if<HydraulicRemainder>(&law);
  if (!port) return 0;
  const std::complex<double> dashpot(0, w * port->share.rate);
  return port->share.series * dashpot / (port->share.series + dashpot);
}

void RemainderSlopes(const PortLaw& law, Signal extension, Signal rate, std::span<double> by_extension,
                     std::span<double> by_rate) {
  std::visit(
      [&](const auto& port) {
        for (std::size_t k = 0; k < by_rate.size(); ++k) {
          const Slopes slopes = SlopesOf(port, At(extension, k), At(rate, k));
          by_extension[k] = slopes.by_extension;
          by_rate[k] = slopes.by_rate;
        }
      },
      law);
}

void MendedSlopes(const PortLaw& law, std::span<const PortKink> kinks, Signal extension, Signal rate,
                  std::span<double> by_extension, std::span<double> by_rate) {
  RemainderSlopes(law, extension, rate, by_extension, by_rate);
  for (const PortKink& kink : kinks) {
    if (kink.jump == 0) continue;
    switch (kink.signal) {
      case PortKink::Signal::kExtension: MendJump(kink.at, kink.jump, extension, by_extension); break;
      case PortKink::Signal::kRate: MendJump(kink.at, kink.jump, rate, by_rate); break;
      case PortKink::Signal::kCompression:
        if (const auto* tyre = std::get_if<TyreRemainder>(&law))
          MendContact(*tyre, extension, rate, by_extension, by_rate);
        else MendContact(std::get<LiftoffRemainder>(law), extension, rate, by_extension, by_rate);
    }
  }
}

std::vector<Port> HeldPortsOf(const CondensedModel& model) {
  std::vector<Port> ports;
  const Eigen::MatrixXd directions = DashpotDirections(model);
  const Eigen::Index n = model.mass.rows();
  Eigen::Index x = n;
  // Of each dashpot, its series spring.
  std::vector<Eigen::Index> series(model.dashpots.size(), -1);
  for (std::size_t j = 0; j < model.dashpots.size(); ++j) {
    const CondensedModel::Dashpot& dashpot = model.dashpots[j];
    if (dashpot.law.LeastRate() < dashpot.law.GreatestRate())
      ports.push_back({.direction = directions.col(static_cast<Eigen::Index>(j)),
                       .law = DashpotRemainder{dashpot.law, dashpot.CentreRate()}});
    if (!dashpot.HasSeries()) continue;
    if (!dashpot.series.IsLinear())
      ports.push_back({.direction = Eigen::VectorXd::Unit(directions.rows(), x),
                       .law = SpringRemainder{dashpot.series, dashpot.series.Slope(0)}});
    series[j] = x++;
  }
  for (const CondensedModel::Stiffening& spring : model.stiffenings)
    ports.push_back(
        {.direction = OnMotion(model, spring.direction), .law = SpringRemainder{spring.law, spring.law.Slope(0)}});
  for (const CondensedModel::Hydraulic& damper : model.hydraulics)
    ports.push_back({.direction = OnMotion(model, damper.direction),
                     .law = HydraulicRemainder{damper.law, HydraulicOil(damper.law).Linear()},
                     .lag = series[damper.dashpot]});
  // Also without force: a fit starts there, and needs the derivatives.
  for (const CondensedModel::Rubbing& friction : model.rubbings)
    ports.push_back({.direction = OnMotion(model, friction.direction), .law = FrictionRemainder{friction.law}});
  for (const CondensedModel::CurvedTyre& tyre : model.curved_tyres)
    ports.push_back({.direction = OnMotion(model, tyre.direction),
                     .law = TyreRemainder{tyre.law, tyre.damping, tyre.law.Rate(0)},
                     .post = tyre.post,
                     .load_cells = tyre.load_cells});
  return ports;
}

std::vector<Port> PortsOf(const CondensedModel& model) {
  std::vector<Port> ports = HeldPortsOf(model);
  for (std::size_t i = 0; i < model.liftoffs.size(); ++i) {
    const CondensedModel::Liftoff& tyre = model.liftoffs[i];
    ports.push_back({.direction = OnMotion(model, tyre.direction),
                     .law = LiftoffRemainder{tyre.preload, tyre.stiffness, tyre.damping},
                     .post = tyre.post,
                     .liftoff = static_cast<int>(i),
                     .load_cells = tyre.load_cells});
  }
  return ports;
}

}  // namespace fourpost
