#include <utility>

#include "identify/suggest/fitted_dampers.h"

namespace fourpost {
namespace {

class MountAdditions {
 public:
  MountAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), dampers_(source), additions_(additions) {}

  void AddAll() {
    for (const auto& group : dampers_.GroupsOf(
             [](const FittedDamper& d) { return d.HasRate() && !d.HasMount() && !d.damper->law.Sticks(); })) {
      AddMount(group);
      AddMountOfFriction(group);
    }
    for (const auto& group :
         dampers_.GroupsOf([](const FittedDamper& d) { return d.HasMount() && d.damper->series->cubic.IsZero(); }))
      AddMountCubic(group);
  }

 private:
  /// f = k x in line with the damper; the amount is 1/k.
  Addition Mount(const AdditionSource::Group& group) const {
    const double rate = dampers_.RateOf(group);
    Addition addition{.mechanism = "mount", .elements = dampers_.NamesOf(group)};
    addition.words = "elastic mount in line with damper " + Quoted(addition.elements);
    addition.values = [](double compliance) { return std::vector{1 / compliance}; };
    addition.first = 1 / (200 * rate);
    addition.least = 1e-8;
    addition.greatest = 1 / (10 * rate);
    return addition;
  }

  NewParameter MountRate(const AdditionSource::Group& group, const Addition& mount) const {
    return {.name = source_.ParameterName("k_mount", mount.elements),
            .dimension = kStiffness,
            .lower = 5 * dampers_.RateOf(group),
            .upper = 1e8,
            .source = "suggested: " + mount.words};
  }

  void AddMount(const AdditionSource::Group& group) {
    Addition addition = Mount(group);
    const NewParameter parameter = MountRate(group, addition);
    dampers_.AddAsChild(addition, parameter, "<series stiffness=\"$" + parameter.name + "\"/>", additions_);
  }

  /// The same in line with both damper and friction beside it, which then is behind the mount.
  void AddMountOfFriction(const AdditionSource::Group& group) {
    VehicleEdit edit = source_.Edit();
    if (!dampers_.PutFrictionInside(group, edit)) return;
    Addition addition = Mount(group);
    addition.choices = 2;
    addition.words = "elastic mount in line with damper " + Quoted(addition.elements) + " and its friction";
    const NewParameter parameter = MountRate(group, addition);
    for (const std::string& name : source_.WrittenOf("fp:damper", addition.elements))
      edit.AddChild(*edit.Find("fp:damper", name), "<series stiffness=\"$" + parameter.name + "\"/>");
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.values(addition.first).front());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  void AddMountCubic(const AdditionSource::Group& group) {
    constexpr double kDeflection = 2e-3;
    const double stiffness = dampers_.at(group.front()).damper->series->stiffness.At(source_.values());
    Addition addition{.mechanism = "mount_cubic", .elements = dampers_.NamesOf(group)};
    addition.words = "hardening of the mount of damper " + Quoted(addition.elements);
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    addition.values = [](double cubic) { return std::vector{cubic}; };
    addition.first = stiffness / (kDeflection * kDeflection);
    addition.greatest = 1e3 * addition.first;
    const NewParameter parameter{.name = source_.ParameterName("k3_mount", addition.elements),
                                 .dimension = kCubicStiffness,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written) {
      const tinyxml2::XMLElement* element = edit.Find("fp:damper", name);
      const tinyxml2::XMLElement* series = element ? element->FirstChildElement("series") : nullptr;
      if (!series) return;
      edit.Set(*series, "cubic", '$' + parameter.name);
    }
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.first);
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  const AdditionSource& source_;
  FittedDampers dampers_;
  std::vector<Addition>& additions_;
};

}  // namespace

void AddMountAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  MountAdditions(source, additions).AddAll();
}

}  // namespace fourpost
