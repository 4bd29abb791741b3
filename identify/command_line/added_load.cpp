#include "identify/command_line/added_load.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Geometry>

#include "analysis/text/diagnostics.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/print.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/added_mass.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

constexpr const char* kAxes = "xyz";

std::string InMetres(double value) { return ShortNumber(value, 3); }

/// "-1.2, 0, 0.9 m"
std::string InMetres(const Eigen::Vector3d& place) {
  return InMetres(place.x()) + ", " + InMetres(place.y()) + ", " + InMetres(place.z()) + " m";
}

/// A length; without a unit in metres.
std::optional<double> ReadLength(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  const std::optional<Quantity> quantity =
      ParseQuantity(std::string_view(text).substr(first, text.find_last_not_of(' ') + 1 - first));
  if (!quantity || (!quantity->unit_text.empty() && quantity->unit.dimension != kLength)) return std::nullopt;
  return quantity->si;
}

std::optional<Eigen::Vector3d> ReadPlace(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text + ',');
  for (std::string part; std::getline(parts, part, ',');) {
    const std::optional<double> number = ReadLength(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != 3) return std::nullopt;
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

/// Around wheels, platforms, centres of mass and sensors, in the design pose.
Eigen::AlignedBox3d BoxOf(const Vehicle& vehicle) {
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  const std::vector<double> values = vehicle.ParameterValues();
  Eigen::AlignedBox3d box;
  for (const Tyre& tyre : vehicle.tyres) box.extend(PlaceOf(tyre.point, poses));
  for (std::size_t i = 1; i < vehicle.links.size(); ++i)
    if (vehicle.links[i].mass.At(values) > 0) box.extend(poses[i] * vehicle.links[i].ComAt(values));
  for (const Sensor& sensor : vehicle.sensors)
    if (sensor.point.link > 0) box.extend(PlaceOf(sensor.point, poses));
  return box;
}

/// Loads may overhang wheels and sensors: by half the car, and by a metre where few points show its size.
void RequireNear(const Vehicle& vehicle, const Eigen::Vector3d& place, Diagnostics& diagnostics) {
  constexpr double kOverhang_m = 1;
  const Eigen::AlignedBox3d box = BoxOf(vehicle);
  const double overhang = std::max(kOverhang_m, 0.5 * box.sizes().maxCoeff());
  const Eigen::AlignedBox3d reach(box.min() - Eigen::Vector3d::Constant(overhang),
                                  box.max() + Eigen::Vector3d::Constant(overhang));
  if (reach.contains(place)) return;
  std::string car;
  for (int k = 0; k < 3; ++k)
    car += std::string(k == 0 ? "" : ", ") + kAxes[k] + " from " + InMetres(box.min()[k]) + " to " +
           InMetres(box.max()[k]);
  diagnostics.Report(kLoadFarOutside, Place::Option("--at"), {InMetres(place), car + " m"});
}

std::vector<AddedLoad::OnPost> Weigh(const Vehicle& without, const Vehicle& with) {
  const Preloads before = CondensedVehicle(without).PreloadsAt(without.ParameterValues());
  const Preloads after = CondensedVehicle(with).PreloadsAt(with.ParameterValues());
  std::vector<AddedLoad::OnPost> posts;
  for (const Post& post : without.posts) {
    const auto tyre = static_cast<std::size_t>(post.tyre);
    posts.push_back({post.name, before.tyre[tyre], after.tyre[tyre]});
  }
  return posts;
}

void RequireStanding(const AddedLoad& load, Diagnostics& diagnostics) {
  std::string lifted;
  for (const AddedLoad::OnPost& post : load.posts)
    if (post.with_N <= 0)
      lifted += (lifted.empty() ? "" : ", ") + post.post + " " + ShortNumber(post.with_N, 4) + " N for " +
                ShortNumber(post.without_N, 4) + " N";
  if (lifted.empty()) return;
  diagnostics.Report(kLoadTipsCar, Place::Option("--at"),
                     {ShortNumber(load.mass_kg, 4) + " kg", InMetres(load.place_m), lifted});
}

/// In which directions the body can turn follows from where the posts carry the load.
void WarnOfPlace(const AddedLoad& load, const Vehicle& vehicle) {
  constexpr double kShows_m = 0.01;
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double force = 0;
  for (std::size_t p = 0; p < load.posts.size(); ++p) {
    const double more = load.posts[p].with_N - load.posts[p].without_N;
    moment += more * PlaceOf(vehicle.tyres[static_cast<std::size_t>(vehicle.posts[p].tyre)].point, poses);
    force += more;
  }
  Diagnostics diagnostics;
  for (int k = 0; k < 2; ++k) {
    const double carried = moment[k] / force;
    if (std::abs(carried - load.place_m[k]) < kShows_m) continue;
    diagnostics.Report(k == 0 ? kLoadWithoutPitch : kLoadWithoutRoll, Place::Option("--at"),
                       {vehicle.name, InMetres(load.place_m[k]) + " m", InMetres(carried) + " m"});
  }
  Tell(diagnostics);
}

}  // namespace

AddedLoad AddLoad(const std::string& mass, const std::string& place, Vehicle& vehicle) {
  Diagnostics diagnostics;
  const std::optional<double> mass_kg = ReadQuantity(mass, kMass, "--add-mass", diagnostics);
  const std::optional<Eigen::Vector3d> place_m = ReadPlace(place);
  if (place_m) RequireNear(vehicle, *place_m, diagnostics);
  else diagnostics.Report(kLoadPlaceUnreadable, Place::Option("--at"), {place});
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  const std::vector<double> values = vehicle.ParameterValues();
  Vehicle loaded = WithMass(vehicle, values, *mass_kg, *place_m);
  AddedLoad load{.mass_kg = *mass_kg,
                 .place_m = *place_m,
                 .body = vehicle.links[HeaviestLink(vehicle, values)].name,
                 .posts = Weigh(vehicle, loaded)};
  RequireStanding(load, diagnostics);
  if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  WarnOfPlace(load, vehicle);
  vehicle = std::move(loaded);
  return load;
}

std::string AddedLoadText(const AddedLoad& load) {
  TextTable table({"load at rest", "without, N", "with, N"});
  for (const AddedLoad::OnPost& post : load.posts)
    table.Add({post.post, Rounded(post.without_N, 4), Rounded(post.with_N, 4)});
  return "added: " + ShortNumber(load.mass_kg, 4) + " kg at " + InMetres(load.place_m) + " (x, y, z) on '" + load.body +
         "'\n" + table.Format();
}

nlohmann::ordered_json AddedLoadJson(const AddedLoad& load) {
  nlohmann::ordered_json posts = nlohmann::ordered_json::array();
  for (const AddedLoad::OnPost& post : load.posts)
    posts.push_back({{"post", post.post}, {"without_N", post.without_N}, {"with_N", post.with_N}});
  return {{"mass_kg", load.mass_kg},
          {"place_m", {load.place_m.x(), load.place_m.y(), load.place_m.z()}},
          {"body", load.body},
          {"static_loads", posts}};
}

}  // namespace fourpost
