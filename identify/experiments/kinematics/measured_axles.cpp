#include "identify/experiments/kinematics/measured_axles.h"

#include <algorithm>
#include <array>

#include "analysis/text/named.h"
#include "vehicles/loops/design_kinematics.h"

namespace fourpost {
namespace {

constexpr std::array<WheelLoad, 4> kLoads = {WheelLoad::kLateral, WheelLoad::kBraking, WheelLoad::kDriving,
                                             WheelLoad::kAligning};

}  // namespace

MeasuredAxles::MeasuredAxles(const Vehicle& vehicle)
    : suspension_(SuspensionOf(vehicle, DesignKinematics(vehicle), vehicle.ParameterValues())),
      struts_(StrutsOf(vehicle)),
      names_(NamesOf(suspension_.axles)) {}

std::optional<std::size_t> MeasuredAxles::AxleNamed(const std::string& name) const { return IndexOf(name, names_); }

std::optional<std::size_t> MeasuredAxles::WheelNamed(const std::string& name, std::size_t axle) const {
  const std::vector<std::size_t>& wheels = suspension_.axles[axle].wheels;
  const int side = name == "left" ? 1 : name == "right" ? -1 : 0;
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < wheels.size(); ++k) {
    const Wheel& wheel = suspension_.wheels[wheels[k]];
    if (wheel.name == name) return k;
    if (side == 0 || wheel.side != side) continue;
    if (found) return std::nullopt;
    found = k;
  }
  return found;
}

const std::string& MeasuredAxles::WheelName(std::size_t place, std::size_t axle) const {
  return suspension_.wheels[suspension_.axles[axle].wheels[place]].name;
}

const AxleStrut* MeasuredAxles::StrutNamed(const std::string& name) const {
  const std::optional<std::size_t> place = IndexOf(name, NamesOf(struts_));
  return place ? &struts_[*place] : nullptr;
}

bool MeasuredAxles::IsKnown(const KinematicQuantity& quantity, const std::string& of) const {
  switch (quantity.of) {
    case KinematicQuantity::Of::kAxle: return of.empty();
    case KinematicQuantity::Of::kStrut: return of.empty() || StrutNamed(of) != nullptr;
    case KinematicQuantity::Of::kWheel: break;
  }
  return of.empty() || of == "left" || of == "right" || IndexOf(of, NamesOf(suspension_.wheels));
}

bool MeasuredAxles::HaveOneWheel() const {
  return std::all_of(suspension_.axles.begin(), suspension_.axles.end(),
                     [](const Axle& axle) { return axle.wheels.size() == 1; });
}

bool MeasuredAxles::SetMotion(const std::string& motion, bool is_opposed, KinematicSweep& sweep) const {
  sweep.motion = sweep.travel.name = motion;
  if (const std::optional<WheelLoad> load = LoadNamed(motion)) {
    sweep.load = KinematicSweep::Load{*load, is_opposed};
    if (is_opposed) sweep.motion += " opposed";
    return true;
  }
  const bool has_sides = suspension_.axles[sweep.axle].HasTwoSides(suspension_.wheels);
  if (motion == "heave" || (motion == "roll" && has_sides)) {
    sweep.travel.kind = motion == "heave" ? AxleTravel::Kind::kHeave : AxleTravel::Kind::kRoll;
    return true;
  }
  const std::optional<std::size_t> wheel = WheelNamed(motion, sweep.axle);
  if (!wheel) return false;
  sweep.travel.kind = AxleTravel::Kind::kWheel;
  sweep.travel.wheel = *wheel;
  sweep.motion = WheelName(*wheel, sweep.axle);
  return true;
}

std::vector<std::string> MeasuredAxles::MotionsOf(std::size_t axle) const {
  std::vector<std::string> motions = {"heave", "roll"};
  for (const WheelLoad load : kLoads) motions.emplace_back(LoadName(load));
  for (std::size_t k = 0; k < suspension_.axles[axle].wheels.size(); ++k) motions.push_back(WheelName(k, axle));
  return motions;
}

std::optional<WheelLoad> LoadNamed(const std::string& name) {
  for (const WheelLoad load : kLoads)
    if (name == LoadName(load)) return load;
  return std::nullopt;
}

}  // namespace fourpost
