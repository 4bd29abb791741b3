#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/suggest/addition_source.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// The heaviest body; -1 where none has a mass.
int HeaviestOf(const Vehicle& vehicle, const std::vector<double>& values) {
  int heaviest = -1;
  double most = 0;
  for (std::size_t i = 1; i < vehicle.links.size(); ++i)
    if (const double mass = vehicle.links[i].mass.At(values); mass > most) {
      most = mass;
      heaviest = static_cast<int>(i);
    }
  return heaviest;
}

/// Where springs stand on the body, the foremost and the rearmost, on its centre line.
std::vector<double> StationsOn(const Vehicle& vehicle, int body) {
  std::vector<double> x;
  for (const Spring& spring : vehicle.springs)
    for (const Point& point : {spring.line.parent, spring.line.child})
      if (point.link == body) x.push_back(point.xyz.x());
  if (x.empty()) return {};
  const auto [least, greatest] = std::minmax_element(x.begin(), x.end());
  if (*greatest - *least < 0.1) return {*greatest};
  return {*greatest, *least};
}

/// Where its centre of mass is stated, or to be; null where the file has no such link.
const tinyxml2::XMLElement* InertialOf(const VehicleEdit& edit, const std::string& link) {
  const tinyxml2::XMLElement* element = edit.Find("link", link);
  return element ? element->FirstChildElement("inertial") : nullptr;
}

/// Names a parameter as the place of the centre of mass along x.
void NameCentre(VehicleEdit& edit, const tinyxml2::XMLElement& inertial, const std::string& parameter) {
  const tinyxml2::XMLElement* origin = inertial.FirstChildElement("origin");
  const std::string xyz = origin ? AttributeText(*origin, "xyz").value_or("0 0 0") : "0 0 0";
  const std::string others = xyz.substr(std::min(xyz.find(' ', xyz.find_first_not_of(' ')), xyz.size()));
  if (origin) edit.Set(*origin, "xyz", '$' + parameter + others);
  else edit.AddChild(inertial, "<origin xyz=\"$" + parameter + others + "\"/>");
}

}  // namespace

/// A part of the body that moves up and down on springs and dampers of its own, such as a power unit. The amount is its
/// mass as a share of the body's; natural frequency and damping are then to be found. What is left of the body has its
/// centre of mass elsewhere, for that of both together is what the axles' loads show.
void AddBodyAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  constexpr double kDampingRatio = 0.08;
  const Vehicle& vehicle = source.vehicle();
  const int body = HeaviestOf(vehicle, source.values());
  if (body < 0 || vehicle.tyres.empty()) return;
  const Link& link = vehicle.links[static_cast<std::size_t>(body)];
  const double whole = link.mass.At(source.values());
  const double centre = link.com[0].At(source.values());
  const std::vector<double> stations = StationsOn(vehicle, body);
  // A body on one spring does not pitch, and a place that is free follows by itself.
  const bool moves_centre = stations.size() > 1 && link.com[0].parameter < 0 && InertialOf(source.Edit(), link.name);
  for (const double x : stations)
    for (const double frequency : {4.0, 6.0, 9.0, 12.0, 16.0}) {
      Addition addition{.mechanism = "part_on_mounts", .elements = {link.name}};
      addition.words = "part of '" + link.name + "' on mounts of its own, such as a power unit";
      const double omega = 2 * std::numbers::pi * frequency;
      addition.values = [=](double share) {
        const double mass = share * whole;
        std::vector<double> numbers = {mass, mass * omega * omega, 2 * kDampingRatio * mass * omega};
        if (moves_centre) numbers.insert(numbers.end(), {(centre - share * x) / (1 - share), 0});
        return numbers;
      };
      addition.first = 0.05;
      addition.greatest = 0.4;
      addition.count = moves_centre ? 5 : 4;  // its place as well
      const std::string part = source.ElementName("part", link.name, false);
      const std::string text = "suggested: " + addition.words;
      const std::vector<double> values = addition.values(addition.first);
      const std::string mass = FormatNumber(AtDigits(values[0], 6));
      std::vector<NewParameter> parameters = {{.name = source.ParameterName("m_part", {link.name}),
                                               .dimension = kMass,
                                               .lower = 1e-3 * whole,
                                               .upper = 0.4 * whole,
                                               .source = text,
                                               .bound_to = "link[" + part + "]/mass"},
                                              {.name = source.ParameterName("k_part", {link.name}),
                                               .dimension = kStiffness,
                                               .lower = 0.02 * values[1] / 4,
                                               .upper = 40 * values[1],
                                               .source = text},
                                              {.name = source.ParameterName("c_part", {link.name}),
                                               .dimension = kDamping,
                                               .lower = 0.002 * values[2],
                                               .upper = 100 * values[2],
                                               .source = text}};
      if (moves_centre) {
        parameters.push_back({.name = source.ParameterName("x", {link.name}),
                              .dimension = kLength,
                              .lower = centre - std::abs(x - centre),
                              .upper = centre + std::abs(x - centre),
                              .source = text});
        // Beside its mounts, so that its place is found as well.
        const double reach = std::abs(stations.front() - stations.back()) / 2;
        parameters.push_back({.name = source.ParameterName("x_part", {link.name}),
                              .dimension = kLength,
                              .lower = -reach,
                              .upper = reach,
                              .source = text});
      }
      VehicleEdit edit = source.Edit();
      if (moves_centre) NameCentre(edit, *InertialOf(edit, link.name), parameters[3].name);
      const std::string place = moves_centre ? "<origin xyz=\"$" + parameters[4].name + " 0 0\"/>" : "";
      edit.Add("<link name=\"" + part + "\"><inertial>" + place + "<mass value=\"" + mass +
               "\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>");
      edit.Add(
          "<joint name=\"" + part + "_travel\" type=\"prismatic\"><parent link=\"" + link.name + "\"/><child link=\"" +
          part + "\"/><origin xyz=\"" + FormatNumber(x) +
          " 0 0\"/><axis xyz=\"0 0 1\"/><limit lower=\"-0.1\" upper=\"0.1\" effort=\"0\" velocity=\"0\"/></joint>");
      const std::string ends = "parent=\"" + link.name + "\" child=\"" + part + "\" axis=\"0 0 1\"";
      edit.Add("<fp:spring name=\"" + part + "_mounts\" " + ends + "><linear stiffness=\"$" + parameters[1].name +
               "\"/></fp:spring>");
      edit.Add("<fp:damper name=\"" + part + "_damping\" " + ends + "><linear rate=\"$" + parameters[2].name +
               "\"/></fp:damper>");
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        addition.parameters.push_back(parameters[i].name);
        edit.Add(parameters[i], values[i]);
      }
      addition.vehicle = edit.Text();
      additions.push_back(std::move(addition));
    }
}

}  // namespace fourpost
