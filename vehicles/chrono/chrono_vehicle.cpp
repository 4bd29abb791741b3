#include "vehicles/chrono/chrono_vehicle.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/chrono/chrono_axle.h"
#include "vehicles/chrono/chrono_body.h"
#include "vehicles/chrono/chrono_kinds.h"
#include "vehicles/chrono/findings.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

using Eigen::Vector3d;

constexpr std::array<const char*, 2> kAxles = {"front", "rear"};

/// Of a passenger car, where no file says it.
constexpr double kGuessedRadius = 0.33;
constexpr double kGuessedMass = 15;
/// Of any tyre [m].
constexpr double kLeastRadius = 0.1;
constexpr double kMostRadius = 1.5;
/// Rate of a tyre without any data [N/m].
constexpr double kGuessedRate = 200e3;

Eigen::Matrix3d TurnOf(const ChronoNode& frame) {
  if (!frame.Has("Orientation")) return Eigen::Matrix3d::Identity();
  const std::vector<double> q = frame.Numbers("Orientation");
  if (q.size() != 4 || !(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0)) {
    frame.ReportAt("Orientation", kChronoValue, {frame.Called("Orientation"), "a quaternion of four numbers"});
    return Eigen::Matrix3d::Identity();
  }
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// Components of a chassis, less its holes; older files have one, without a list.
KnownBody ChassisOf(const ChronoNode& chassis) {
  if (!chassis.Has("Components")) return ChronoBody(chassis, Vector3d::Zero());
  KnownBody sum;
  KnownBody holes;
  for (const ChronoNode& component : chassis.Items("Components")) {
    const ChronoNode frame = component.Child("Centroidal Frame");
    KnownBody body = ChronoBody(component, Vector3d::Zero(), frame.Vector("Location"));
    const Eigen::Matrix3d turn = TurnOf(frame);
    body.inertia = turn * body.inertia * turn.transpose();
    KnownBody& part = component.IsTrue("Void") ? holes : sum;
    part = part + body;
  }
  return sum - holes;
}

/// More than any car has; each names a file.
constexpr std::size_t kMostSteerings = 10;

/// Links of a steering that is not read count at its place.
KnownBody SteeringOf(const ChronoNode& vehicle) {
  KnownBody sum;
  if (!vehicle.Has("Steering Subsystems")) return sum;
  for (const ChronoNode& entry : vehicle.Items("Steering Subsystems", kMostSteerings)) {
    const Vector3d at = entry.Vector("Location");
    const std::optional<ChronoNode> file = entry.File("Input File");
    if (!file) continue;
    for (const char* part : {"Steering Link", "Pitman Arm"})
      if (file->Has(part) && file->Child(part).Has("Mass"))
        sum = sum + KnownBody{.mass = file->Child(part).Number("Mass"), .com = at, .inertia = Eigen::Matrix3d::Zero()};
  }
  return sum;
}

/// Nothing where there is none; of one that is not above zero, which is reported, a guess.
std::optional<double> StatedRate(const ChronoNode& tyre) {
  const std::optional<ChronoNumber> rate = tyre.Find({"Vertical Stiffness", "Vertical Stiffness [N/m]"});
  if (!rate || rate->value > 0) return tyre.FindNumber({"Vertical Stiffness", "Vertical Stiffness [N/m]"});
  tyre.ReportAt(rate->name, kChronoValue, {tyre.Called(rate->name), "above zero"});
  return kGuessedRate;
}

/// Vertical rate, as Chrono's TMeasy tyre takes it from a load index or a capacity: the load over 0.16 of the height
/// between rim and tread. A load index stands for 45 kg 10^(index / 80), within 2 % of the standard's table.
std::optional<double> TyreRate(const ChronoNode& tyre, double radius) {
  if (const auto rate = StatedRate(tyre)) return rate;
  const std::optional<double> rim = tyre.FindNumber({"Rim Radius [m]", "Rim Radius"});
  std::optional<double> load = tyre.FindNumber({"Maximum Bearing Capacity [N]"});
  if (const auto index = tyre.FindNumber({"Load Index"})) load = kGravity * 45 * std::pow(10, *index / 80);
  if (!rim || !load || !(radius > *rim)) return std::nullopt;
  return *load / (0.16 * (radius - *rim));
}

ChronoTyre TyreOf(const ChronoNode& entry, const std::optional<ChronoNode>& tyre) {
  ChronoTyre result;
  if (const std::optional<ChronoNode> wheel = entry.File("Left Wheel Input File")) {
    const KnownBody body = ChronoBody(*wheel, Vector3d::Zero(), Vector3d::Zero());
    result.mass = body.mass;
    result.inertia = body.inertia.diagonal();
  }
  if (!tyre) {
    result.radius = kGuessedRadius;
    result.mass += kGuessedMass;
    result.inertia += kGuessedMass * kGuessedRadius * kGuessedRadius * Vector3d(0.4, 0.75, 0.4);
    return result;
  }
  const ChronoNode design = tyre->Has("Design") ? tyre->Child("Design") : *tyre;
  const bool has_units = design.Has("Mass [kg]");
  result.mass += design.Number(has_units ? "Mass [kg]" : "Mass");
  result.inertia += design.Vector(has_units ? "Inertia [kg.m2]" : "Inertia");
  const std::optional<ChronoNumber> radius = tyre->Find({"Unloaded Radius [m]", "Unloaded Radius", "Radius"});
  result.radius = radius ? radius->value : 0;
  if (!radius) tyre->Report(kChronoMissing, {tyre->Called(), "Unloaded Radius", "a number in m"});
  else if (!(result.radius > kLeastRadius && result.radius < kMostRadius))
    tyre->ReportAt(radius->name, kChronoRange,
                   {tyre->Called(radius->name), FormatNumber(result.radius) + " m",
                    FormatNumber(kLeastRadius) + " to " + FormatNumber(kMostRadius) + " m"});
  result.rate = TyreRate(*tyre, result.radius);
  result.damping = tyre->FindNumber({"Vertical Damping"});
  if (!result.rate || !(*result.rate > 0)) {
    tyre->Report(kChronoTyreRate);
    result.rate.reset();
  }
  return result;
}

class VehicleReader {
 public:
  VehicleReader(const ChronoNode& vehicle, const std::array<ChronoMotion, 2>& motion, Diagnostics& diagnostics)
      : vehicle_(vehicle), motion_(motion), diagnostics_(diagnostics) {}

  std::optional<ChronoVehicle> Read(const std::vector<std::filesystem::path>& tyres) {
    if (!vehicle_.Has("Axles")) {
      vehicle_.Report(kChronoNoVehicle, {vehicle_.Called() + " has no \"Axles\""});
      return std::nullopt;
    }
    ReadBody();
    ReadAxles(tyres);
    if (diagnostics_.HasErrors()) return std::nullopt;
    CheckOrder();
    if (diagnostics_.HasErrors()) return std::nullopt;
    body_ = body_ + axles_[0].on_body + axles_[1].on_body;
    StandOnGround();
    ChronoVehicle result{.points = Points(), .car = Car()};
    if (diagnostics_.HasErrors()) return std::nullopt;
    return result;
  }

 private:
  void ReadBody() {
    const ChronoNode chassis = vehicle_.Child("Chassis");
    if (chassis.Has("Input File")) {
      if (const std::optional<ChronoNode> file = chassis.File("Input File")) body_ = ChassisOf(*file);
    } else {
      body_ = ChassisOf(chassis);
    }
    if (!chassis.IsNull() && !diagnostics_.HasErrors() && !(body_.mass > 0))
      chassis.Report(kChronoMass, {"the chassis's mass", FormatNumber(body_.mass) + " kg"});
    body_ = body_ + SteeringOf(vehicle_);
  }

  void ReadAxles(const std::vector<std::filesystem::path>& tyres) {
    const std::vector<ChronoNode> entries = vehicle_.Items("Axles");
    if (entries.size() != 2) {
      vehicle_.ReportAt("Axles", kChronoAxles, {std::to_string(entries.size())});
      return;
    }
    if (tyres.empty())
      vehicle_.Report(kChronoNoTyre, {FormatNumber(1e3 * kGuessedRadius) + " mm", FormatNumber(kGuessedMass) + " kg"});
    // What is wrong with the tyres of both axles is said once.
    Diagnostics again;
    for (std::size_t i = 0; i < 2; ++i) {
      std::optional<ChronoNode> file;
      if (!tyres.empty()) {
        file = ChronoNode::Read(tyres[std::min(i, tyres.size() - 1)], i < tyres.size() ? diagnostics_ : again);
        if (!file) continue;
      }
      tyres_[i] = TyreOf(entries[i], file);
      axles_[i] = ReadChronoAxle(entries[i], kAxles[i], tyres_[i], motion_[i]);
    }
  }

  void CheckOrder() {
    const double front = Centre(0).x();
    const double rear = Centre(1).x();
    const auto shown = [](double x) { return FormatNumber(std::round(1e3 * x) + 0.0) + " mm"; };
    if (front - rear < kLeastWheelbase) vehicle_.ReportAt("Axles", kChronoAxleOrder, {shown(front), shown(rear)});
  }

  const Vector3d& Centre(std::size_t axle) const {
    for (const HardPoint& point : axles_[axle].points)
      if (point.name == "wheel_centre") return point.xyz;
    return body_.com;
  }

  /// Below each wheel by its loaded radius; both axles carry the moments of the whole.
  void StandOnGround() {
    const KnownBody all = body_ + axles_[0].unsprung + axles_[1].unsprung;
    const double front = Centre(0).x();
    const double rear = Centre(1).x();
    const double share = (all.com.x() - rear) / (front - rear);
    for (std::size_t i = 0; i < 2; ++i) {
      const double load = 0.5 * kGravity * all.mass * (i == 0 ? share : 1 - share);
      const double radius = tyres_[i].radius - load / tyres_[i].rate.value_or(kGuessedRate);
      axles_[i].points.push_back(
          {.axle = kAxles[i], .name = "contact", .xyz = Centre(i) - std::max(radius, 0.1) * Vector3d::UnitZ()});
    }
  }

  CarPoints Points() {
    std::vector<HardPoint> points;
    for (const ChronoAxle& axle : axles_) points.insert(points.end(), axle.points.begin(), axle.points.end());
    return SortedPoints({axles_[0].kind, axles_[1].kind}, points, vehicle_.path().string(), diagnostics_);
  }

  KnownCar Car() {
    KnownCar car;
    car.body = body_;
    car.model = "a model of Project Chrono";
    const std::string name = vehicle_.path().filename().string();
    car.source = "From " + name + " of Project Chrono: points, masses, inertias and laws are of its files.";
    for (std::size_t i = 0; i < 2; ++i) {
      KnownAxle& axle = car.axles[i] = axles_[i].known;
      axle.tyre_damping = tyres_[i].damping;
      if (!tyres_[i].rate) continue;
      const double rate = std::round(*tyres_[i].rate) * 1e-3;
      axle.tyre_rate = {
          .name = std::string("kt_") + kAxles[i],
          .value = rate,
          .lower = 0.6 * rate,
          .upper = 1.7 * rate,
          .precision = 0.1,
          .unit = "N/mm",
          .source = "Chrono, the tyre's file: its vertical stiffness, or what its load index makes of it"};
    }
    return car;
  }

  const ChronoNode& vehicle_;
  const std::array<ChronoMotion, 2>& motion_;
  Diagnostics& diagnostics_;
  KnownBody body_;
  std::array<ChronoTyre, 2> tyres_;
  std::array<ChronoAxle, 2> axles_;
};

}  // namespace

std::optional<ChronoVehicle> ReadChronoVehicle(const std::filesystem::path& file,
                                               const std::vector<std::filesystem::path>& tyres,
                                               const std::array<ChronoMotion, 2>& motion, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<ChronoVehicle> result;
  if (const std::optional<ChronoNode> vehicle = ChronoNode::Read(file, found))
    result = VehicleReader(*vehicle, motion, found).Read(tyres);
  diagnostics.Add(found);
  return result;
}

}  // namespace fourpost
