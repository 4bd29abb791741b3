#include "vehicles/reader/body_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include <Eigen/Eigenvalues>

#include "analysis/text/units.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/reader/findings.h"

namespace fourpost {
namespace {

Eigen::Matrix3d InertiaAt(const Link& link, std::span<const double> parameters) {
  std::array<double, 6> i{};
  for (std::size_t k = 0; k < i.size(); ++k) i[k] = link.inertia[k].At(parameters);
  Eigen::Matrix3d inertia;
  inertia << i[0], i[3], i[4],  //
      i[3], i[1], i[5],         //
      i[4], i[5], i[2];
  return inertia;
}

Eigen::Vector3d PrincipalMoments(const Eigen::Matrix3d& inertia) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
}

/// Principal moments obey the triangle inequality, since each is a sum of two of three non-negative second moments.
bool IsPhysical(const Eigen::Matrix3d& inertia) {
  // Rounding of the numbers of a file and of the eigenvalues.
  constexpr double kSlack = 1e-9;
  const Eigen::Vector3d moments = PrincipalMoments(inertia);
  const double slack = kSlack * moments.cwiseAbs().maxCoeff();
  return moments[0] >= -slack && moments[0] + moments[1] >= moments[2] - slack;
}

std::string MomentsText(const Eigen::Matrix3d& inertia) {
  std::ostringstream text;
  const Eigen::Vector3d moments = PrincipalMoments(inertia);
  text << moments[0] << ", " << moments[1] << " and " << moments[2] << " kg*m^2";
  return text.str();
}

std::vector<std::size_t> ParametersOf(const Link& link) {
  std::set<std::size_t> indices;
  for (const Scalar& number : link.inertia)
    if (number.parameter >= 0) indices.insert(static_cast<std::size_t>(number.parameter));
  return {indices.begin(), indices.end()};
}

/// The parameter values at the corner of this number: bit i is which bound the i-th of these parameters takes.
std::vector<double> CornerValues(const Vehicle& vehicle, const std::vector<std::size_t>& indices, unsigned corner) {
  std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[indices[i]];
    values[indices[i]] = (corner >> i & 1U) != 0 ? parameter.upper : parameter.lower;
  }
  return values;
}

/// "m at 150 kg and I at 3 kg*m^2".
std::string ValuesText(const Vehicle& vehicle, const std::vector<std::size_t>& indices,
                       const std::vector<double>& values) {
  std::string text;
  for (const std::size_t i : indices)
    text += (text.empty() ? "" : " and ") + vehicle.parameters[i].name + " at " +
            FormatQuantity(values[i], vehicle.parameters[i].unit);
  return text;
}

/// The set of physical inertias is convex: when the corners of the bounds are in it, everything between is.
void CheckInertiaWithinBounds(const Vehicle& vehicle, const Link& link, FileFaults& faults) {
  const std::vector<std::size_t> indices = ParametersOf(link);
  for (unsigned corner = 0; corner < 1U << indices.size(); ++corner) {
    const std::vector<double> values = CornerValues(vehicle, indices, corner);
    const Eigen::Matrix3d inertia = InertiaAt(link, values);
    if (IsPhysical(inertia)) continue;
    faults.Report(kInertiaImpossibleAtBounds, link.line,
                  {link.name, ValuesText(vehicle, indices, values), MomentsText(inertia)});
    return;
  }
}

bool HasInertiaAlone(const Vehicle& vehicle, const Link& link) {
  const std::vector<double> values = vehicle.ParameterValues();
  return link.mass.At(values) <= 0 && !InertiaAt(link, values).isZero(0);
}

/// Inertias are computed per mass, of which 1e-9 kg has lost nothing yet.
void CheckMass(const Vehicle& vehicle, const Link& link, FileFaults& faults) {
  constexpr double kLeast_kg = 1e-9;
  std::vector<double> values = vehicle.ParameterValues();
  double least = link.mass.At(values);
  if (link.mass.parameter >= 0) {
    const auto index = static_cast<std::size_t>(link.mass.parameter);
    for (const double bound : {vehicle.parameters[index].lower, vehicle.parameters[index].upper}) {
      values[index] = bound;
      least = std::min(least, link.mass.At(values));
    }
  }
  if (least > 0 && least < kLeast_kg) faults.Report(kMassTooSmall, link.line, {link.name, FormatQuantity(least, "")});
}

void CheckInertia(const Vehicle& vehicle, const Link& link, FileFaults& faults) {
  const Eigen::Matrix3d inertia = InertiaAt(link, vehicle.ParameterValues());
  if (HasInertiaAlone(vehicle, link)) faults.Report(kInertiaWithoutMass, link.line, {link.name});
  else if (!inertia.allFinite()) faults.Report(kInertiaTooLarge, link.line, {link.name});
  else if (!IsPhysical(inertia)) faults.Report(kInertiaImpossible, link.line, {link.name, MomentsText(inertia)});
  else CheckInertiaWithinBounds(vehicle, link, faults);
}

/// Mass of each link with all that it carries.
std::vector<double> CarriedMasses(const Vehicle& vehicle) {
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<double> masses;
  for (const Link& link : vehicle.links) masses.push_back(link.mass.At(values));
  for (auto joint = vehicle.joints.rbegin(); joint != vehicle.joints.rend(); ++joint)
    masses[static_cast<std::size_t>(joint->parent)] += masses[static_cast<std::size_t>(joint->child)];
  return masses;
}

/// Finds two-ended elements whose ends coincide.
class LengthCheck {
 public:
  LengthCheck(const Vehicle& vehicle, FileFaults& faults) : poses_(DesignPoses(vehicle)), faults_(faults) {}

  void Check(const std::string& element, int line, const Point& parent, const Point& child,
             const Finding& kind = kLineWithoutLength) {
    constexpr double kShortest_m = 1e-9;
    // Ends that are unknown or on one link are reported already.
    if (parent.link < 0 || child.link < 0 || parent.link == child.link ||
        (PlaceOf(parent, poses_) - PlaceOf(child, poses_)).norm() > kShortest_m)
      return;
    faults_.Report(kind, line, {element});
  }
  void Check(const std::string& element, int line, const ForceLine& points) {
    if (!points.axis) Check(element, line, points.parent, points.child);
  }

 private:
  std::vector<Eigen::Isometry3d> poses_;
  FileFaults& faults_;
};

}  // namespace

void CheckLengths(const Vehicle& vehicle, FileFaults& faults) {
  LengthCheck check(vehicle, faults);
  for (const Spring& spring : vehicle.springs) check.Check(spring.Element(), spring.source_line, spring.line);
  for (const Damper& damper : vehicle.dampers)
    check.Check("fp:damper '" + damper.name + "'", damper.source_line, damper.line);
  for (const Actuator& actuator : vehicle.actuators)
    check.Check("fp:actuator '" + actuator.name + "'", actuator.source_line, actuator.line);
  for (const Sensor& sensor : vehicle.sensors)
    if (sensor.type == Sensor::Type::kStrut)
      check.Check("fp:sensor '" + sensor.name + "'", sensor.source_line, sensor.line);
  for (const AntiRollBar& bar : vehicle.antiroll_bars) {
    check.Check("the left line of fp:antiroll '" + bar.name + "'", bar.source_line, bar.left);
    check.Check("the right line of fp:antiroll '" + bar.name + "'", bar.source_line, bar.right);
  }
  for (const Rod& rod : vehicle.rods)
    check.Check("fp:rod '" + rod.name + "'", rod.source_line, rod.parent, rod.child, kRodWithoutLength);
}

void CheckWheels(const Vehicle& vehicle, FileFaults& faults) {
  // Steered or cambered, a wheel still turns about an axis nearer to y than to x or z.
  constexpr double kSideways = 0.70710678118654752;
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  for (const Tyre& tyre : vehicle.tyres) {
    if (tyre.radius == 0 || tyre.point.link < 0) continue;
    const auto link = static_cast<std::size_t>(tyre.point.link);
    const Eigen::Vector3d axis = poses[link].linear().col(1);
    if (std::abs(axis.y()) > kSideways) continue;
    faults.Report(kWheelAxis, tyre.source_line, {tyre.name, vehicle.links[link].name});
  }
}

void CheckBodies(const Vehicle& vehicle, FileFaults& faults) {
  for (const Link& link : vehicle.links) {
    CheckMass(vehicle, link, faults);
    CheckInertia(vehicle, link, faults);
  }
  const std::vector<double> masses = CarriedMasses(vehicle);
  for (const Joint& joint : vehicle.joints) {
    const Link& link = vehicle.links[static_cast<std::size_t>(joint.child)];
    if (HasInertiaAlone(vehicle, link)) continue;
    if (joint.type != Joint::Type::kFixed && masses[static_cast<std::size_t>(joint.child)] <= 0)
      faults.Report(kMassMissing, link.line, {joint.name, link.name});
  }
}

}  // namespace fourpost
