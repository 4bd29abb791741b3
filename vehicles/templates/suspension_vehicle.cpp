#include "vehicles/templates/suspension_vehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride/vehicle_summary.h"
#include "vehicles/templates/axle_writer.h"
#include "vehicles/templates/findings.h"

namespace fourpost {
namespace {

/// Body with two people, and its centre of mass above the ground: of a passenger car.
constexpr double kBodyMass = 1200;
constexpr double kBodyHeight = 0.55;
/// Front and rear [Hz]: the rear higher, so that a car pitches little behind a bump (Olley; Gillespie 1992, chapter 5).
constexpr std::array<double, 2> kRideFrequency = {1.2, 1.4};
constexpr double kDampingRatio = 0.3;
/// Ratios below it are no design, or a fault.
constexpr double kLeastRatio = 0.15;
constexpr double kUsualIdleRatio = 0.3;

/// The drawing against the level ground: R_y(pitch) p + (0, 0, rise).
struct GroundPose {
  double pitch = 0;
  double rise = 0;

  double HeightOf(const Eigen::Vector3d& place) const {
    return -std::sin(pitch) * place.x() + std::cos(pitch) * place.z() + rise;
  }
};

GroundPose GroundOf(const CarPoints& car) {
  const Eigen::Vector3d& front = car[0].At("contact");
  const Eigen::Vector3d span = front - car[1].At("contact");
  GroundPose pose{.pitch = std::atan2(span.z(), span.x())};
  pose.rise = -pose.HeightOf(front);
  return pose;
}

std::string Fixed(double value, int power) {
  return FormatNumber(std::round(value * std::pow(10, power)) + 0.0, -power);
}

std::string BodyText(const CarPoints& car, const GroundPose& ground) {
  const Eigen::Vector3d front = car[0].At("wheel_centre");
  const Eigen::Vector3d rear = car[1].At("wheel_centre");
  const double wheelbase = front.x() - rear.x();
  const double track = front.y() + rear.y();
  const double x = std::round(500 * (front.x() + rear.x())) * 1e-3;
  const double z = std::round(1e3 * (0.5 * (car[0].At("contact").z() + car[1].At("contact").z()) + kBodyHeight)) * 1e-3;
  // As if half the mass stood over either axle: dynamic index 0.9; radius of gyration in roll 0.38 of the track.
  const double pitch = std::round(0.9 * kBodyMass * 0.25 * wheelbase * wheelbase);
  const double roll = std::round(kBodyMass * 0.38 * 0.38 * track * track);
  std::string text = "\n  <!-- Body with engine and two people; its axes and origin are those of the drawing. -->\n";
  text += "  <link name=\"ground\"/>\n  <link name=\"body\">\n    <inertial>\n      <origin xyz=\"" +
          XyzText({x, 0, z}) + "\"/>\n      <mass value=\"" + FormatNumber(kBodyMass) + "\"/>\n      <inertia ixx=\"" +
          FormatNumber(roll) + "\" iyy=\"" + FormatNumber(pitch) + "\" izz=\"" + FormatNumber(pitch) +
          "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n    </inertial>\n    <visual>\n      <origin xyz=\"" +
          XyzText({x, 0, z + 0.05}) + "\"/>\n      <geometry><box size=\"" + Fixed(wheelbase + 1, 2) + " " +
          Fixed(0.5 * track, 2) + " 0.4\"/></geometry>\n    </visual>\n  </link>\n";
  text +=
      "  <joint name=\"body\" type=\"floating\">\n    <parent link=\"ground\"/><child link=\"body\"/><origin xyz=\"0 "
      "0 " +
      Fixed(ground.rise, 9) + "\"" +
      (std::abs(ground.pitch) > 1e-9 ? " rpy=\"0 " + Fixed(ground.pitch, 9) + " 0\"" : "") + "/>\n  </joint>\n";
  text += Text(
      {.name = "m_body",
       .value = kBodyMass,
       .lower = 700,
       .upper = 2500,
       .precision = 0.1,
       .unit = "kg",
       .source = "estimate, of a passenger car: body with engine and two people; weigh the car and subtract wheels",
       .binds = {"link[body]/mass"}});
  text += Text({.name = "x_body",
                .value = 1e3 * x,
                .lower = 1e3 * x - std::round(150 * wheelbase),
                .upper = 1e3 * x + std::round(150 * wheelbase),
                .precision = 0.1,
                .unit = "mm",
                .source = "estimate: centre of mass midway between the axles; static loads of the axles tell",
                .binds = {"link[body]/com/x"}});
  text += Text({.name = "I_pitch",
                .value = pitch,
                .lower = std::round(0.5 * pitch),
                .upper = std::round(2 * pitch),
                .precision = 1,
                .unit = "kg*m^2",
                .source = "estimate: dynamic index 0.9, I / (m a b); the yaw inertia is as large",
                .binds = {"link[body]/inertia/iyy", "link[body]/inertia/izz"}});
  text += Text({.name = "I_roll",
                .value = roll,
                .lower = std::round(0.5 * roll),
                .upper = std::round(1.8 * roll),
                .precision = 1,
                .unit = "kg*m^2",
                .source = "estimate: radius of gyration 0.38 of the track",
                .binds = {"link[body]/inertia/ixx"}});
  return text;
}

std::string HeadText(const CarPoints& car, const std::string& name, const std::string& source) {
  return "<?xml version=\"1.0\"?>\n<!-- Written by `fourpost init --suspension front=" +
         std::string(car[0].kind->name) + ",rear=" + std::string(car[1].kind->name) + "`.\n     Points: " + source +
         ". Masses, inertias and rates are estimates, each with its source: replace them by what you know.\n     Axes: "
         "x "
         "forward, y left, z up. The body has axes and origin of the drawing, so that points of body, knuckles\n     "
         "and "
         "axles stand as listed, in m; points of an arm are differences to the first point of its axis. Only the left\n"
         "     side is written; fp:mirror makes the right one. -->\n<robot name=\"" +
         name + "\" xmlns:fp=\"urn:fourpost:vehicle:1\">\n\n  <fp:mirror from=\"_left\" to=\"_right\"/>\n";
}

std::string CarText(const CarPoints& car, const CarGuess& guess, const std::string& name, const std::string& source) {
  const GroundPose ground = GroundOf(car);
  std::string text = HeadText(car, name, source) + BodyText(car, ground);
  for (std::size_t i = 0; i < car.size(); ++i) {
    AxleWriter axle(car[i], guess[i], ground.HeightOf(car[i].At("wheel_centre")));
    axle.Comment((i == 0 ? "FRONT: " : "REAR: ") + std::string(car[i].kind->summary) + ".");
    car[i].kind->write(axle);
    text += axle.text();
  }
  return text +
         "\n  <fp:sensor name=\"pitch_rate\" type=\"gyro\" link=\"body\" axis=\"0 1 0\"/>\n  <fp:sensor "
         "name=\"roll_rate\" type=\"gyro\" link=\"body\" axis=\"1 0 0\"/>\n</robot>\n";
}

double RatioOf(const std::vector<StrutGeometry>& struts, std::size_t index) {
  return index < struts.size() ? struts[index].together.value_or(0) : 0;
}

template <class Elements>
std::size_t IndexOf(const Elements& elements, const std::string& name) {
  const auto found = std::find_if(elements.begin(), elements.end(), [&](const auto& e) { return e.name == name; });
  return static_cast<std::size_t>(found - elements.begin());
}

/// The ratio that rates are chosen for.
double UsableRatio(double ratio, const AxlePoints& axle, const char* strut, const std::string& source,
                   Diagnostics& diagnostics) {
  if (ratio > kLeastRatio) return ratio;
  diagnostics.Report(kStrutIdle, {source}, {axle.axle, strut, Fixed(ratio, 2)});
  return kUsualIdleRatio;
}

/// Rates for the ride that is usual, at the motion ratios of the car as written.
CarGuess GuessFor(const CarPoints& car, const std::string& text, const std::string& source, Diagnostics& diagnostics) {
  Diagnostics faults;
  const std::optional<Vehicle> vehicle = ReadVehicleText(text, source, faults);
  if (!vehicle) throw FaultyInput(faults);
  const VehicleSummary summary = Summarise(*vehicle, vehicle->ParameterValues());
  CarGuess guess;
  for (std::size_t i = 0; i < car.size(); ++i) {
    AxleGuess& axle = guess[i];
    const std::size_t tyre = IndexOf(vehicle->tyres, car[i].axle + "_tyre_left");
    const double mass = summary.chassis.corners.at(tyre).sprung_kg.value_or(0.25 * kBodyMass);
    const double spring = RatioOf(summary.ride.springs, IndexOf(vehicle->springs, car[i].axle + "_coil_left"));
    const double damper = RatioOf(summary.ride.dampers, IndexOf(vehicle->dampers, car[i].axle + "_damper_left"));
    axle.spring_ratio = UsableRatio(spring, car[i], "spring", source, diagnostics);
    axle.damper_ratio = UsableRatio(damper, car[i], "damper", source, diagnostics);
    axle.sprung_mass = mass;
    const double speed = 2 * std::numbers::pi * kRideFrequency[i];
    axle.spring_rate = mass * speed * speed / (axle.spring_ratio * axle.spring_ratio);
    axle.damper_rate = 2 * kDampingRatio * mass * speed / (axle.damper_ratio * axle.damper_ratio);
  }
  return guess;
}

void ReportSlope(const CarPoints& car, const std::string& source, Diagnostics& diagnostics) {
  const double rise = car[1].At("contact").z() - car[0].At("contact").z();
  if (std::abs(rise) < 1e-3) return;
  const double turn = GroundOf(car).pitch * 180 / std::numbers::pi;
  diagnostics.Report(kGroundSlopes, {source, car[1].points.at("contact").line},
                     {Fixed(1e3 * std::abs(rise), 1) + " mm", Fixed(turn, 2) + " deg"});
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::string SuspensionVehicleText(const CarPoints& car, const std::string& name, const std::string& source,
                                  const std::string& file, Diagnostics& diagnostics) {
  ReportSlope(car, file, diagnostics);
  try {
    const CarGuess guess = GuessFor(car, CarText(car, {}, name, source), file, diagnostics);
    return CarText(car, guess, name, source);
  } catch (const FaultyInput& faults) {
    const std::vector<Diagnostic> items = faults.diagnostics().ByWeight();
    diagnostics.Report(kSuspensionDoesNotWork, {file}, {items.empty() ? faults.what() : FirstLine(items[0].message)});
    return {};
  }
}

}  // namespace fourpost
