#include "vehicles/port.h"

#include <algorithm>

#include "vehicles/linear_vehicle.h"

namespace fourpost {
namespace {

double Force(const DashpotRemainder& port, double, double v) { return port.law.Force(v) - port.rate * v; }
double Force(const SpringRemainder& port, double x, double) { return port.law.Force(x) - port.stiffness * x; }
double Compression(const LiftoffRemainder& port, double x, double v) {
  return port.preload + port.stiffness * x + port.damping * v;
}
double Force(const LiftoffRemainder& port, double x, double v) { return std::max(0.0, -Compression(port, x, v)); }

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

double At(std::span<const double> signal, std::size_t k) { return signal.empty() ? 0 : signal[k]; }

}  // namespace

bool UsesExtension(const PortLaw& law) { return !std::holds_alternative<DashpotRemainder>(law); }
bool UsesRate(const PortLaw& law) { return !std::holds_alternative<SpringRemainder>(law); }

void Remainders(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                std::span<double> remainder) {
  std::visit(
      [&](const auto& port) {
        for (std::size_t k = 0; k < remainder.size(); ++k) remainder[k] = Force(port, At(extension, k), At(rate, k));
      },
      law);
}

void RemainderSlopes(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                     std::span<double> by_extension, std::span<double> by_rate) {
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

std::vector<Port> PortsOf(const CondensedModel& model) {
  std::vector<Port> ports;
  const Eigen::MatrixXd directions = DashpotDirections(model);
  const Eigen::Index n = model.mass.rows();
  const auto on_motion = [&](const Eigen::VectorXd& direction) {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(directions.rows());
    all.head(n) = direction;
    return all;
  };
  Eigen::Index x = n;
  for (std::size_t j = 0; j < model.dashpots.size(); ++j) {
    const CondensedModel::Dashpot& dashpot = model.dashpots[j];
    if (dashpot.law.LeastRate() < dashpot.law.GreatestRate())
      ports.push_back({.direction = directions.col(static_cast<Eigen::Index>(j)),
                       .law = DashpotRemainder{dashpot.law, dashpot.CentreRate()}});
    if (!dashpot.HasSeries()) continue;
    if (!dashpot.series.IsLinear())
      ports.push_back({.direction = Eigen::VectorXd::Unit(directions.rows(), x),
                       .law = SpringRemainder{dashpot.series, dashpot.series.Slope(0)}});
    ++x;
  }
  for (const CondensedModel::Stiffening& spring : model.stiffenings)
    ports.push_back(
        {.direction = on_motion(spring.direction), .law = SpringRemainder{spring.law, spring.law.Slope(0)}});
  for (std::size_t i = 0; i < model.liftoffs.size(); ++i) {
    const CondensedModel::Liftoff& tyre = model.liftoffs[i];
    ports.push_back({.direction = on_motion(tyre.direction),
                     .law = LiftoffRemainder{tyre.preload, tyre.stiffness, tyre.damping},
                     .post = tyre.post,
                     .liftoff = static_cast<int>(i)});
  }
  return ports;
}

}  // namespace fourpost
