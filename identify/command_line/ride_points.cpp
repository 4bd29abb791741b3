#include "identify/command_line/ride_points.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "identify/command_line/findings.h"
#include "vehicles/description/design_poses.h"

namespace fourpost {
namespace {

std::optional<Eigen::Vector3d> ReadPlace(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text + ',');
  for (std::string part; std::getline(parts, part, ',');) {
    const std::optional<double> number = ParseNumber(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != 3) return std::nullopt;
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

std::optional<RidePoint> ReadRidePoint(const std::string& text, const Vehicle& vehicle, Diagnostics& diagnostics) {
  const Place place = Place::Option("--point");
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', equals == std::string::npos ? 0 : equals);
  const std::optional<Eigen::Vector3d> xyz =
      colon == std::string::npos ? std::nullopt : ReadPlace(text.substr(colon + 1));
  if (equals == std::string::npos || equals == 0 || !xyz) {
    diagnostics.Report(kRidePointMalformed, place, {text});
    return std::nullopt;
  }
  const std::string link = text.substr(equals + 1, colon - equals - 1);
  std::vector<std::string> links;
  for (const Link& known : vehicle.links) links.push_back(known.name);
  const auto found = std::find(links.begin(), links.end(), link);
  if (found == links.end()) {
    diagnostics.Report(kRidePointLink, place, {link, DidYouMean(link, links)});
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(found - links.begin());
  const Eigen::Isometry3d pose = DesignPoses(vehicle)[index];
  return RidePoint{.name = text.substr(0, equals),
                   .point = {.link = static_cast<int>(index), .xyz = *xyz},
                   .axis = pose.linear().transpose() * Eigen::Vector3d::UnitZ()};
}

}  // namespace

std::vector<RidePoint> ReadRidePoints(const std::vector<std::string>& texts, const Vehicle& vehicle,
                                      Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Sensor& sensor : vehicle.sensors) names.push_back(sensor.name);
  std::vector<RidePoint> points;
  for (const std::string& text : texts) {
    const std::optional<RidePoint> point = ReadRidePoint(text, vehicle, diagnostics);
    if (!point) continue;
    if (std::find(names.begin(), names.end(), point->name) != names.end())
      diagnostics.Report(kRidePointTwice, Place::Option("--point"), {point->name});
    names.push_back(point->name);
    points.push_back(*point);
  }
  return points;
}

void SetWeightings(const std::vector<std::string>& texts, RideInstruments& instruments, Diagnostics& diagnostics) {
  const Place place = Place::Option("--weighting");
  std::vector<std::string> names;
  for (const RideInstruments::Felt& felt : instruments.points) names.push_back(felt.name);
  for (const std::string& text : texts) {
    const std::size_t equals = text.rfind('=');
    const std::optional<Weighting> weighting =
        equals == std::string::npos ? std::nullopt : WeightingNamed(text.substr(equals + 1));
    // We is for rotations.
    if (!weighting || *weighting == Weighting::kWe) {
      diagnostics.Report(kRideWeightingMalformed, place, {text});
      continue;
    }
    const std::string name = text.substr(0, equals);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) diagnostics.Report(kRideWeightingPoint, place, {name, DidYouMeanOrAll(name, names)});
    else instruments.points[static_cast<std::size_t>(found - names.begin())].weighting = *weighting;
  }
}

}  // namespace fourpost
