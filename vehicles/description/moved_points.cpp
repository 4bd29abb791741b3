#include "vehicles/description/moved_points.h"

#include "analysis/text/count_check.h"

namespace fourpost {
namespace {

/// Calls `visit` with every point that a frame may name.
template <typename AnyVehicle, typename Visit>
void VisitPoints(AnyVehicle& vehicle, const Visit& visit) {
  const auto line = [&](auto& ends) {
    visit(ends.parent);
    visit(ends.child);
  };
  const auto all = [&](auto& elements) {
    for (auto& element : elements) line(element);
  };
  for (auto& spring : vehicle.springs) line(spring.line);
  for (auto& damper : vehicle.dampers) line(damper.line);
  for (auto& actuator : vehicle.actuators) line(actuator.line);
  for (auto& sensor : vehicle.sensors) line(sensor.line);
  for (auto& bar : vehicle.antiroll_bars) {
    line(bar.left);
    line(bar.right);
  }
  all(vehicle.bushings);
  all(vehicle.rods);
  all(vehicle.balls);
  all(vehicle.welds);
  all(vehicle.hinges);
}

}  // namespace

std::vector<bool> MovePoints(const Vehicle& vehicle) {
  std::vector<bool> moves(vehicle.parameters.size());
  VisitPoints(vehicle, [&](const Point& point) {
    for (const Scalar& shift : point.shift)
      if (shift.parameter >= 0 && shift.factor != 0) moves[static_cast<std::size_t>(shift.parameter)] = true;
  });
  return moves;
}

Vehicle WithPointsAt(Vehicle vehicle, std::span<const double> parameters) {
  RequireCount("WithPointsAt", "parameters", vehicle.parameters.size(), parameters.size());
  VisitPoints(vehicle, [&](Point& point) {
    for (std::size_t i = 0; i < point.shift.size(); ++i) {
      Scalar& shift = point.shift[i];
      const double now = shift.At(parameters);
      point.xyz[static_cast<Eigen::Index>(i)] += now - shift.value;
      shift.value = now;
    }
  });
  return vehicle;
}

}  // namespace fourpost
