#include "vehicles/description/vehicle.h"

#include <algorithm>
#include <numbers>

namespace fourpost {

Eigen::Vector3d Link::ComAt(std::span<const double> parameters) const {
  return {com[0].At(parameters), com[1].At(parameters), com[2].At(parameters)};
}

std::string Spring::Element() const {
  const std::string quoted = "'" + name + "'";
  switch (kind) {
    case Kind::kCoil: return "fp:spring " + quoted;
    case Kind::kStop: return "fp:stop " + quoted;
    case Kind::kGas: return "the gas of fp:damper " + quoted;
  }
  return quoted;
}

HydraulicDamper Damper::HydraulicAt(std::span<const double> parameters) const {
  HydraulicDamper damper = hydraulic->At(parameters);
  damper.friction = 0;
  if (!law.friction || law.Sticks()) return damper;
  damper.friction = law.friction->force.At(parameters);
  damper.friction_speed = law.friction->speed.At(parameters);
  return damper;
}

double Bushing::DampingAt(std::size_t component, std::span<const double> parameters) const {
  const double loss = loss_factor.At(parameters) / (2 * std::numbers::pi * loss_frequency_Hz);
  return damping[component].At(parameters) + loss * stiffness[component].At(parameters);
}

std::optional<std::size_t> Vehicle::IndexOf(std::string_view parameter) const {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == parameter) return i;
  return std::nullopt;
}

bool Vehicle::HasPrior(std::size_t parameter) const {
  const Parameter& one = parameters[parameter];
  return one.prior_sd || one.like || std::any_of(parameters.begin(), parameters.end(), [&](const Parameter& other) {
           return other.like && other.like->parameter == one.name;
         });
}

std::vector<double> Vehicle::ParameterValues() const {
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const Parameter& parameter : parameters) values.push_back(parameter.value);
  return values;
}

}  // namespace fourpost
