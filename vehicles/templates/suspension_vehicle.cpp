#include "vehicles/templates/suspension_vehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/description/gravity.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/ride/vehicle_summary.h"
#include "vehicles/templates/axle_writer.h"
#include "vehicles/templates/body_text.h"
#include "vehicles/templates/findings.h"
#include "vehicles/templates/written_xml.h"

namespace fourpost {
namespace {

/// Front and rear [Hz]: the rear higher, so that a car pitches little behind a bump (Olley; Gillespie 1992, chapter 5).
constexpr std::array<double, 2> kRideFrequency = {1.2, 1.4};
constexpr double kDampingRatio = 0.3;
/// Ratios below it are no design, or a fault.
constexpr double kLeastRatio = 0.15;
constexpr double kUsualIdleRatio = 0.3;

GroundPose GroundOf(const CarPoints& car) {
  const Eigen::Vector3d& front = car[0].At("contact");
  const Eigen::Vector3d span = front - car[1].At("contact");
  GroundPose pose{.pitch = std::atan2(span.z(), span.x())};
  pose.rise = -pose.HeightOf(front);
  return pose;
}

/// `origin`: of points and numbers, in one line.
std::string HeadText(const std::string& model, const std::string& name, const std::string& origin) {
  return "<?xml version=\"1.0\"?>\n<!-- Written by `fourpost init` of " + InComment(model) + ".\n     " +
         InComment(origin) +
         "\n     Axes: "
         "x "
         "forward, y left, z up. The body has axes and origin of the drawing, so that points of body, knuckles\n     "
         "and "
         "axles stand as listed, in m; points of an arm are differences to the first point of its axis. Only the left\n"
         "     side is written; fp:mirror makes the right one. -->\n<robot name=\"" +
         name + "\" xmlns:fp=\"urn:fourpost:vehicle:1\">\n\n  <fp:mirror from=\"_left\" to=\"_right\"/>\n";
}

/// What stands on top of a file, and what its numbers are from.
struct CarOrigin {
  std::string model;
  std::string text;
  /// Of a model.
  std::string source = {};
};

std::string CarText(const CarPoints& car, const BodyGuess& body, const CarGuess& guess, const std::string& name,
                    const CarOrigin& origin) {
  const GroundPose ground = GroundOf(car);
  std::string text = HeadText(origin.model, name, origin.text) + BodyText(car, body, ground, origin.source);
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

struct ReadCar {
  Vehicle vehicle;
  VehicleSummary summary;
};

ReadCar Read(const std::string& text, const std::string& file) {
  Diagnostics faults;
  const std::optional<Vehicle> vehicle = ReadVehicleText(text, file, faults);
  if (!vehicle) throw FaultyInput(faults);
  return {*vehicle, Summarise(*vehicle, vehicle->ParameterValues())};
}

double LoadOf(const ReadCar& car, std::size_t axle) { return car.summary.chassis.axles.at(axle).load_N / kGravity; }

/// The body with which the axles have these loads [kg], of one with which they have others:
///   m' - m = F' + R' - F - R,  m' (x' - x_rear) - m (x - x_rear) = (F' - F) wheelbase.
BodyGuess Weighed(const CarPoints& points, const BodyGuess& body, const ReadCar& car, const AxleLoads& loads) {
  const double rear = points[1].At("wheel_centre").x();
  const double wheelbase = points[0].At("wheel_centre").x() - rear;
  const double front_change = loads[0] - LoadOf(car, 0);
  const double mass = body.mass + front_change + loads[1] - LoadOf(car, 1);
  return {mass, rear + (body.mass * (body.x - rear) + front_change * wheelbase) / mass, true};
}

std::string NameOfSpring(const AxlePoints& points) {
  return points.axle + '_' + std::string(points.kind->spring) + "_left";
}

/// Rates for the ride that is usual, at the motion ratios of the car as written.
CarGuess GuessFor(const CarPoints& points, const ReadCar& car, CarGuess guess, const std::string& file,
                  Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    AxleGuess& axle = guess[i];
    const std::size_t tyre = IndexOf(car.vehicle.tyres, points[i].axle + "_tyre_left");
    const double mass = car.summary.chassis.corners.at(tyre).sprung_kg.value_or(0.25 * kBodyMass);
    const RideGeometry& ride = car.summary.ride;
    if (axle.known.spring && axle.known.damper) continue;
    const double spring = RatioOf(ride.springs, IndexOf(car.vehicle.springs, NameOfSpring(points[i])));
    const double damper = RatioOf(ride.dampers, IndexOf(car.vehicle.dampers, points[i].axle + "_damper_left"));
    axle.spring_ratio = UsableRatio(spring, points[i], "spring", file, diagnostics);
    axle.damper_ratio = UsableRatio(damper, points[i], "damper", file, diagnostics);
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

void ReportFault(const FaultyInput& faults, const std::string& file, Diagnostics& diagnostics) {
  const std::vector<Diagnostic> items = faults.diagnostics().ByWeight();
  diagnostics.Report(kSuspensionDoesNotWork, {file}, {items.empty() ? faults.what() : FirstLine(items[0].message)});
}

}  // namespace

std::string SuspensionVehicleText(const CarPoints& points, const std::optional<AxleLoads>& loads,
                                  const std::string& name, const std::string& source, const std::string& file,
                                  Diagnostics& diagnostics) {
  ReportSlope(points, file, diagnostics);
  const CarOrigin origin = {
      .model =
          "the suspensions front=" + std::string(points[0].kind->name) + ",rear=" + std::string(points[1].kind->name),
      .text = "Points: " + source +
              ". Masses, inertias and rates are estimates, each with its source: replace them by what you know."};
  try {
    BodyGuess body;
    body.x = 0.5 * (points[0].At("wheel_centre").x() + points[1].At("wheel_centre").x());
    ReadCar car = Read(CarText(points, body, {}, name, origin), file);
    // Again for the share of heights in loads, where the drawing is tilted.
    for (int i = 0; loads && i < 2; ++i) {
      body = Weighed(points, body, car, *loads);
      if (body.mass < 0.2 * ((*loads)[0] + (*loads)[1])) {
        diagnostics.Report(kAxleLoadsTooSmall, Place::Option("--load"), {Fixed(body.mass, 0) + " kg"});
        return {};
      }
      car = Read(CarText(points, body, {}, name, origin), file);
    }
    return CarText(points, body, GuessFor(points, car, {}, file, diagnostics), name, origin);
  } catch (const FaultyInput& faults) {
    ReportFault(faults, file, diagnostics);
    return {};
  }
}

std::string KnownVehicleText(const CarPoints& points, const KnownCar& known, const std::string& name,
                             const std::string& file, StatedLoads loads, Diagnostics& diagnostics) {
  const CarOrigin origin = {.model = known.model, .text = known.source, .source = known.axles[0].source};
  CarGuess guess;
  for (std::size_t i = 0; i < guess.size(); ++i) guess[i].known = known.axles[i];
  try {
    BodyGuess body;
    body.known = known.body;
    body.x = known.body ? known.body->com.x() : 0;
    body.mass = known.body ? known.body->mass : kBodyMass;
    std::string text = CarText(points, body, guess, name, origin);
    ReadCar car = Read(text, file);
    CarGuess rates = GuessFor(points, car, guess, file, diagnostics);
    for (std::size_t i = 0; i < guess.size(); ++i) {
      std::optional<KnownLaw>& spring = rates[i].known.spring;
      if (loads == StatedLoads::kAsStated && spring) spring->tags = spring->loaded;
    }
    return CarText(points, body, rates, name, origin);
  } catch (const FaultyInput& faults) {
    ReportFault(faults, file, diagnostics);
    return {};
  }
}

}  // namespace fourpost
