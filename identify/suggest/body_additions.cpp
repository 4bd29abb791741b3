#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/missing_force/force_mechanism.h"
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

/// Whether it moves on mounts of its own in the body: a guide of the body carries it, and no tyre.
bool IsPartOf(const Vehicle& vehicle, int body, int link) {
  const auto is_guided = [&](const Joint& joint) {
    return joint.child == link && joint.parent == body && joint.type == Joint::Type::kPrismatic;
  };
  return std::any_of(vehicle.joints.begin(), vehicle.joints.end(), is_guided) &&
         std::none_of(vehicle.tyres.begin(), vehicle.tyres.end(),
                      [&](const Tyre& tyre) { return tyre.point.link == link; });
}

/// Where springs of axles stand on the body, the foremost and the rearmost, on its centre line.
std::vector<double> StationsOn(const Vehicle& vehicle, int body) {
  std::vector<double> x;
  const auto add = [&](const Point& point, const Point& other) {
    if (point.link == body && !IsPartOf(vehicle, body, other.link)) x.push_back(point.xyz.x());
  };
  for (const Spring& spring : vehicle.springs) {
    add(spring.line.parent, spring.line.child);
    add(spring.line.child, spring.line.parent);
  }
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

/// A part of the body that moves up and down on springs and dampers of its own, such as a power unit. The amount is its
/// mass as a share of the body's; natural frequency and damping are then to be found. What is left of the body has its
/// centre of mass elsewhere, for that of both together is what the axles' loads show.
class BodyAdditions {
 public:
  BodyAdditions(const AdditionSource& source, int body, std::vector<Addition>& additions)
      : source_(source),
        additions_(additions),
        body_(source.vehicle().links[static_cast<std::size_t>(body)]),
        whole_(body_.mass.At(source.values())),
        centre_(body_.com[0].At(source.values())),
        stations_(StationsOn(source.vehicle(), body)),
        // A place that is free follows by itself.
        moves_centre_(Pitches() && body_.com[0].parameter < 0 && InertialOf(source.Edit(), body_.name)) {
    const std::size_t parts = PartsOf(source.vehicle(), body);
    constexpr const char* kOrdinals[] = {"", "second ", "third "};
    words_ = (parts < std::size(kOrdinals) ? kOrdinals[parts] : "further ") + std::string("part of '") + body_.name +
             "' on mounts of its own, such as a power unit";
  }

  void AddAll() {
    for (const double x : stations_)
      for (const double frequency : {4.0, 6.0, 9.0, 12.0, 16.0, 22.0}) Add(x, frequency);
  }

 private:
  static std::size_t PartsOf(const Vehicle& vehicle, int body) {
    std::size_t parts = 0;
    for (const Joint& joint : vehicle.joints) parts += IsPartOf(vehicle, body, joint.child) ? 1 : 0;
    return parts;
  }

  /// A body on one spring does not.
  bool Pitches() const { return stations_.size() > 1; }

  void Add(double x, double frequency) {
    constexpr double kDampingRatio = 0.08;
    const double omega = 2 * std::numbers::pi * frequency;
    Addition addition{.mechanism = "part_on_mounts", .elements = {body_.name}, .words = words_};
    addition.values = [=, whole = whole_, centre = centre_, pitches = Pitches(), moves = moves_centre_](double share) {
      const double mass = share * whole;
      std::vector<double> numbers = {mass, mass * omega * omega, 2 * kDampingRatio * mass * omega};
      if (pitches) numbers.push_back(0);
      if (moves) numbers.push_back((centre - share * x) / (1 - share));
      return numbers;
    };
    addition.first = 0.05;
    addition.least = kLeastShareOfMass;
    addition.greatest = 0.4;
    const std::vector<double> values = addition.values(addition.first);
    const std::string part = source_.ElementName("part", body_.name, false);
    const std::vector<NewParameter> parameters = ParametersOf(part, x, values);
    addition.count = std::max(4, static_cast<int>(parameters.size()));  // its place as well
    VehicleEdit edit = source_.Edit();
    Write(part, x, values.front(), parameters, edit);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      addition.parameters.push_back(parameters[i].name);
      edit.Add(parameters[i], values[i]);
    }
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Its mass, rate and damping; its place beside its mounts where the body pitches, and the body's own.
  std::vector<NewParameter> ParametersOf(const std::string& part, double x, const std::vector<double>& values) const {
    const std::string text = "suggested: " + words_;
    std::vector<NewParameter> parameters = {{.name = source_.ParameterName("m_part", {body_.name}),
                                             .dimension = kMass,
                                             .lower = kLeastShareOfMass * whole_,
                                             .upper = 0.4 * whole_,
                                             .source = text,
                                             .bound_to = "link[" + part + "]/mass"},
                                            {.name = source_.ParameterName("k_part", {body_.name}),
                                             .dimension = kStiffness,
                                             .lower = 0.02 * values[1] / 4,
                                             .upper = 40 * values[1],
                                             .source = text},
                                            {.name = source_.ParameterName("c_part", {body_.name}),
                                             .dimension = kDamping,
                                             .lower = 0.002 * values[2],
                                             .upper = 100 * values[2],
                                             .source = text}};
    const double reach = std::abs(stations_.front() - stations_.back()) / 2;
    if (Pitches())
      parameters.push_back({.name = source_.ParameterName("x_part", {body_.name}),
                            .dimension = kLength,
                            .lower = -reach,
                            .upper = reach,
                            .source = text});
    if (moves_centre_)
      parameters.push_back({.name = source_.ParameterName("x", {body_.name}),
                            .dimension = kLength,
                            .lower = centre_ - std::abs(x - centre_),
                            .upper = centre_ + std::abs(x - centre_),
                            .source = text});
    return parameters;
  }

  void Write(const std::string& part, double x, double mass, const std::vector<NewParameter>& parameters,
             VehicleEdit& edit) const {
    if (moves_centre_) NameCentre(edit, *InertialOf(edit, body_.name), parameters[4].name);
    const std::string place = Pitches() ? "<origin xyz=\"$" + parameters[3].name + " 0 0\"/>" : "";
    edit.Add("<link name=\"" + part + "\"><inertial>" + place + "<mass value=\"" + FormatNumber(AtDigits(mass, 6)) +
             "\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>");
    edit.Add("<joint name=\"" + part + "_travel\" type=\"prismatic\"><parent link=\"" + body_.name +
             "\"/><child link=\"" + part + "\"/><origin xyz=\"" + FormatNumber(x) +
             " 0 0\"/><axis xyz=\"0 0 1\"/><limit lower=\"-0.1\" upper=\"0.1\" effort=\"0\" velocity=\"0\"/></joint>");
    const std::string ends = "parent=\"" + body_.name + "\" child=\"" + part + "\" axis=\"0 0 1\"";
    edit.Add("<fp:spring name=\"" + part + "_mounts\" " + ends + "><linear stiffness=\"$" + parameters[1].name +
             "\"/></fp:spring>");
    edit.Add("<fp:damper name=\"" + part + "_damping\" " + ends + "><linear rate=\"$" + parameters[2].name +
             "\"/></fp:damper>");
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
  const Link& body_;
  double whole_;
  double centre_;
  std::vector<double> stations_;
  bool moves_centre_;
  std::string words_;
};

}  // namespace

void AddBodyAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  const int body = HeaviestOf(source.vehicle(), source.values());
  if (body >= 0 && !source.vehicle().tyres.empty()) BodyAdditions(source, body, additions).AddAll();
}

}  // namespace fourpost
