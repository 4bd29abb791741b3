#include "vehicles/ride/named_modes.h"

#include <cmath>
#include <numbers>

#include "vehicles/ride/mode_names.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {
namespace {

/// Takes the component if it is larger.
void Compare(std::complex<double> component, std::complex<double>& largest) {
  if (std::abs(component) > std::abs(largest)) largest = component;
}

}  // namespace

std::vector<Mode> NamedModes(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension,
                             const CondensedModel& model, std::span<const double> parameters) {
  std::vector<Mode> modes = ModesOf(model);
  const HeldChassis held(suspension, StiffnessWithoutTyres(vehicle, pose, parameters, model));
  NameModes(vehicle, pose, suspension, held, modes);
  return modes;
}

std::vector<std::complex<double>> PolesOf(const Mode& mode) {
  if (mode.kind != Mode::Kind::kOverdamped) return {mode.pole};
  // slow fast = w^2.
  return {mode.pole, std::pow(2 * std::numbers::pi * mode.frequency_Hz, 2) / mode.pole};
}

std::vector<BodyShape> BodyShapes(const std::vector<BodyMotion>& bodies, const Mode& mode) {
  std::vector<BodyShape> shapes;
  std::complex<double> largest = 0;
  for (const BodyMotion& body : bodies) {
    BodyShape shape{.body = body.name,
                    .translation = body.com_jacobian * mode.shape,
                    .rotation = body.spin_jacobian * mode.shape,
                    .mass = body.mass.mass};
    if (shape.mass > 0) shape.gyration = (body.mass.inertia.diagonal() / shape.mass).cwiseSqrt();
    for (Eigen::Index i = 0; i < 3; ++i) {
      Compare(shape.translation[i], largest);
      Compare(shape.rotation[i] * shape.gyration[i], largest);
    }
    shapes.push_back(std::move(shape));
  }
  if (largest == 0.0) return shapes;
  for (BodyShape& shape : shapes) {
    shape.translation /= largest;
    shape.rotation /= largest;
  }
  return shapes;
}

}  // namespace fourpost
