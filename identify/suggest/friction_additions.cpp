#include <cmath>
#include <string_view>
#include <utility>

#include "identify/suggest/fitted_dampers.h"
#include "identify/suggest/new_friction.h"

namespace fourpost {
namespace {

/// Dry friction beside a damper, or behind its mount, and from the one place to the other.
class FrictionAdditions {
 public:
  FrictionAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), dampers_(source), additions_(additions) {}

  void AddAll() {
    const auto is_beside = [&](const FittedDamper& d) { return dampers_.FrictionBeside(d) != nullptr; };
    for (const auto& group : dampers_.GroupsOf([&](const FittedDamper& d) { return d.HasRate() && !is_beside(d); }))
      AddFriction(group);
    const auto has_mount = [](const FittedDamper& d) { return d.HasRate() && d.HasMount(); };
    const auto is_behind = [](const FittedDamper& d) { return d.HasFrictionBehindMount(); };
    for (const auto& group : dampers_.GroupsOf([&](const FittedDamper& d) { return has_mount(d) && !is_behind(d); })) {
      AddFrictionBehindMount(group);
      MoveFrictionBehindMount(group);
    }
    for (const auto& group :
         dampers_.GroupsOf([&](const FittedDamper& d) { return has_mount(d) && is_behind(d) && !is_beside(d); }))
      MoveFrictionBesideMount(group);
    for (const auto& group : dampers_.GroupsOf([](const FittedDamper& d) {
           return d.damper->law.friction && !d.damper->law.Sticks() && d.damper->law.friction->speed.parameter < 0;
         }))
      AddSpeed(group);
  }

 private:
  Addition Friction(const AdditionSource::Group& group) const {
    const double rate = dampers_.RateOf(group);
    Addition addition{.mechanism = "friction", .elements = dampers_.NamesOf(group)};
    addition.first = 0.02 * rate;
    addition.greatest = rate;
    return addition;
  }

  /// Beside the damper, as an element of its own: a damper may have a mount, which friction of a strut has not.
  void AddFriction(const AdditionSource::Group& group) {
    Addition addition = Friction(group);
    addition.words = "dry friction beside damper " + Quoted(addition.elements);
    const NewFriction friction(source_, addition);
    VehicleEdit edit = source_.Edit();
    for (const auto& [name, ends] : source_.EndsOf("fp:damper", addition.elements))
      edit.Add("<fp:damper name=\"" + source_.ElementName("friction", name, addition.elements.size() == 1) + "\" " +
               ends + "><linear rate=\"0 N*s/m\"/>" + friction.Text() + "</fp:damper>");
    friction.Finish(addition, edit);
    additions_.push_back(std::move(addition));
  }

  /// As of the rod's seals of a strut on a rubber top mount.
  void AddFrictionBehindMount(const AdditionSource::Group& group) {
    Addition addition = Friction(group);
    addition.words = "dry friction behind the mount of damper " + Quoted(addition.elements);
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    const NewFriction friction(source_, addition);
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written)
      if (const tinyxml2::XMLElement* element = edit.Find("fp:damper", name)) edit.AddChild(*element, friction.Text());
      else return;
    friction.Finish(addition, edit);
    additions_.push_back(std::move(addition));
  }

  /// No new number: its force stays what it is.
  Addition Move(const AdditionSource::Group& group, const char* mechanism, const char* where) const {
    Addition addition{.mechanism = mechanism, .elements = dampers_.NamesOf(group)};
    addition.words = std::string("friction ") + where + " the mount of damper " + Quoted(addition.elements) +
                     (where == std::string_view("behind") ? " in place of beside it" : " in place of behind it");
    addition.values = [](double) { return std::vector<double>(); };
    addition.first = addition.least = addition.greatest = 1;
    addition.count = 0;
    return addition;
  }

  void MoveFrictionBehindMount(const AdditionSource::Group& group) {
    VehicleEdit edit = source_.Edit();
    if (!dampers_.PutFrictionInside(group, edit)) return;
    Addition addition = Move(group, "friction_behind_mount", "behind");
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  void MoveFrictionBesideMount(const AdditionSource::Group& group) {
    Addition addition = Move(group, "friction_beside_mount", "beside");
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    VehicleEdit edit = source_.Edit();
    for (const auto& [name, ends] : source_.EndsOf("fp:damper", addition.elements)) {
      const tinyxml2::XMLElement* element = edit.Find("fp:damper", name);
      const tinyxml2::XMLElement* law = element ? element->FirstChildElement("friction") : nullptr;
      if (!law) return;
      edit.Add("<fp:damper name=\"" + source_.ElementName("friction", name, group.size() == 1) + "\" " + ends +
               "><linear rate=\"0 N*s/m\"/>" + TextOf(*law) + "</fp:damper>");
      edit.Remove(*law);
    }
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Over which it passes from one sign to the other. The amount is the logarithm of its ratio to the speed now.
  void AddSpeed(const AdditionSource::Group& group) {
    // Below some tenths of a millimetre per second it is dry friction of any speed.
    constexpr double kLeast = -2;
    constexpr double kMost = 4;
    const double speed = dampers_.at(group.front()).damper->law.friction->speed.At(source_.values());
    Addition addition{.mechanism = "friction_speed", .elements = dampers_.NamesOf(group)};
    addition.words = "transition speed of friction in damper " + Quoted(addition.elements);
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    addition.values = [speed](double amount) { return std::vector{speed * std::exp(amount)}; };
    addition.first = 0.7;
    addition.least = kLeast;
    addition.greatest = kMost;
    const NewParameter parameter{.name = source_.ParameterName("v_friction", addition.elements),
                                 .dimension = kVelocity,
                                 .lower = speed * std::exp(kLeast),
                                 .upper = speed * std::exp(kMost),
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written) {
      const tinyxml2::XMLElement* element = edit.Find("fp:damper", name);
      const tinyxml2::XMLElement* law = element ? element->FirstChildElement("friction") : nullptr;
      if (!law) return;
      edit.Set(*law, "speed", '$' + parameter.name);
    }
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.values(addition.first).front());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  const AdditionSource& source_;
  FittedDampers dampers_;
  std::vector<Addition>& additions_;
};

}  // namespace

void AddFrictionAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  FrictionAdditions(source, additions).AddAll();
}

}  // namespace fourpost
