#include <algorithm>
#include <cmath>

#include "identify/suggest/addition_source.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// A damper in which something can be added, with its numbers at the fitted values.
struct FittedDamper {
  const Damper* damper = nullptr;
  double bump = 0;
  double rebound = 0;

  double rate() const { return std::max(bump, rebound); }
};

bool HasRate(const FittedDamper& one) { return one.bump > 0 && one.rebound > 0; }

bool AreSameEnds(const ForceLine& a, const ForceLine& b) {
  constexpr double kNear = 1e-6;
  return a.parent.link == b.parent.link && a.child.link == b.child.link &&
         (a.parent.xyz - b.parent.xyz).norm() < kNear && (a.child.xyz - b.child.xyz).norm() < kNear;
}

class DamperAdditions {
 public:
  DamperAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), additions_(additions) {
    for (const Damper& damper : source.vehicle().dampers) {
      FittedDamper one{&damper};
      if (!damper.hydraulic) {
        one.bump = damper.law.compression.At(source.values());
        one.rebound = damper.law.rebound.At(source.values());
      }
      dampers_.push_back(one);
      lines_.push_back(damper.line);
    }
  }

  void AddAll() {
    for (const auto& group : GroupsOf([](const FittedDamper& d) { return HasRate(d) && !d.damper->series; }))
      AddMount(group);
    for (const auto& group :
         GroupsOf([](const FittedDamper& d) { return d.damper->series && d.damper->series->cubic.IsZero(); }))
      AddMountCubic(group);
    for (const auto& group : GroupsOf([&](const FittedDamper& d) { return HasRate(d) && !HasFriction(d); }))
      AddFriction(group);
    for (const auto& group : GroupsOf([](const FittedDamper& d) {
           return HasRate(d) && d.damper->law.kind == DashpotDescription::Kind::kBilinear;
         })) {
      for (const double knee : {0.05, 0.1, 0.2, 0.4})
        for (const Sides sides : {Sides::kBoth, Sides::kBump, Sides::kRebound}) AddDigression(group, knee, sides);
      AddBilinear(group);
    }
    for (const auto& group : GroupsOf([&](const FittedDamper& d) { return !d.damper->hydraulic && !HasGas(d); }))
      AddGas(group);
  }

 private:
  enum class Sides { kBoth, kBump, kRebound };

  template <typename Takes>
  std::vector<AdditionSource::Group> GroupsOf(const Takes& takes) const {
    std::vector<char> flags;
    for (const FittedDamper& one : dampers_) flags.push_back(takes(one) ? 1 : 0);
    return source_.Groups(lines_, flags);
  }

  std::vector<std::string> NamesOf(const AdditionSource::Group& group) const {
    std::vector<std::string> names;
    for (const std::size_t i : group) names.push_back(dampers_[i].damper->name);
    return names;
  }

  double RateOf(const AdditionSource::Group& group) const {
    double rate = 0;
    for (const std::size_t i : group) rate += dampers_[i].rate() / static_cast<double>(group.size());
    return rate;
  }

  bool HasFriction(const FittedDamper& one) const {
    return std::any_of(dampers_.begin(), dampers_.end(), [&](const FittedDamper& other) {
      return other.damper->law.friction && AreSameEnds(one.damper->line, other.damper->line);
    });
  }

  bool HasGas(const FittedDamper& one) const {
    const std::vector<Spring>& springs = source_.vehicle().springs;
    return std::any_of(springs.begin(), springs.end(), [&](const Spring& spring) {
      return spring.kind == Spring::Kind::kGas && spring.name == one.damper->name;
    });
  }

  /// A child of each damper of the group in its file, with one parameter for all; nothing where it cannot be written.
  void AddAsChild(Addition addition, const NewParameter& parameter, const std::string& xml) {
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written)
      if (const tinyxml2::XMLElement* element = edit.Find("fp:damper", name)) edit.AddChild(*element, xml);
      else return;
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.values(addition.first).front());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// f = k x in line with the damper; the amount is 1/k.
  void AddMount(const AdditionSource::Group& group) {
    const double rate = RateOf(group);
    Addition addition{.mechanism = "mount", .elements = NamesOf(group)};
    addition.words = "elastic mount in line with damper " + Quoted(addition.elements);
    addition.values = [](double compliance) { return std::vector{1 / compliance}; };
    addition.first = 1 / (200 * rate);
    addition.least = 1e-8;
    addition.greatest = 1 / (10 * rate);
    const NewParameter parameter{.name = source_.ParameterName("k_mount", addition.elements),
                                 .dimension = kStiffness,
                                 .lower = 5 * rate,
                                 .upper = 1e8,
                                 .source = "suggested: " + addition.words};
    AddAsChild(addition, parameter, "<series stiffness=\"$" + parameter.name + "\"/>");
  }

  void AddMountCubic(const AdditionSource::Group& group) {
    constexpr double kDeflection = 2e-3;
    const double stiffness = dampers_[group.front()].damper->series->stiffness.At(source_.values());
    Addition addition{.mechanism = "mount_cubic", .elements = NamesOf(group)};
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

  /// Beside the damper, as an element of its own: a damper may have a mount, which friction of a strut has not.
  void AddFriction(const AdditionSource::Group& group) {
    const double rate = RateOf(group);
    Addition addition{.mechanism = "friction", .elements = NamesOf(group)};
    addition.words = "dry friction beside damper " + Quoted(addition.elements);
    addition.values = [](double force) { return std::vector{force}; };
    addition.first = 0.02 * rate;
    addition.greatest = rate;
    const NewParameter parameter{.name = source_.ParameterName("friction", addition.elements),
                                 .dimension = kForce,
                                 .lower = 0,
                                 .upper = rate,
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const auto& [name, ends] : source_.EndsOf("fp:damper", addition.elements))
      edit.Add("<fp:damper name=\"" + source_.ElementName("friction", name, addition.elements.size() == 1) + "\" " +
               ends + "><linear rate=\"0 N*s/m\"/><friction force=\"$" + parameter.name + "\"/></fp:damper>");
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.first);
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Slopes beyond the knees are 1 - amount times those before them.
  void AddDigression(const AdditionSource::Group& group, double knee, Sides sides) {
    const FittedDamper& one = dampers_[group.front()];
    Addition addition{.mechanism = "digression", .elements = NamesOf(group)};
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    const char* where = sides == Sides::kBoth ? "" : sides == Sides::kBump ? " in bump" : " in rebound";
    addition.words = "knee" + std::string(where) + " in the law of damper " + Quoted(addition.elements);
    const double bump = one.bump;
    const double rebound = one.rebound;
    std::vector<double> before;
    std::vector<std::string> names;
    VehicleEdit edit = source_.Edit();
    const std::string source = "suggested: " + addition.words;
    const std::string at = source_.ParameterName("v_knee", addition.elements);
    const auto slope = [&](const char* side, double rate) {
      names.push_back(source_.ParameterName(std::string("c_beyond_") + side, addition.elements));
      before.push_back(rate);
      edit.Add({.name = names.back(), .dimension = kDamping, .lower = 0.02 * rate, .upper = 4 * rate, .source = source},
               0.5 * rate);
      return '$' + names.back();
    };
    const std::string bump_beyond = sides == Sides::kRebound ? "" : slope("bump", bump);
    const std::string rebound_beyond = sides == Sides::kBump ? "" : slope("rebound", rebound);
    edit.Add({.name = at, .dimension = kVelocity, .lower = knee / 4, .upper = 4 * knee, .source = source}, knee);
    for (const std::string& name : written) {
      const tinyxml2::XMLElement* element = edit.Find("fp:damper", name);
      if (!element) return;
      const tinyxml2::XMLElement* law = element->FirstChildElement("bilinear");
      const bool is_linear = !law;
      if (is_linear) law = element->FirstChildElement("linear");
      if (!law) return;
      const std::string bump_text = AttributeText(*law, is_linear ? "rate" : "bump").value_or("");
      const std::string rebound_text = AttributeText(*law, is_linear ? "rate" : "rebound").value_or("");
      if (bump_text.empty() || rebound_text.empty()) return;  // an earlier spelling
      const std::string knees = "\" bump_knee=\"$" + at + "\" rebound_knee=\"$" + at;
      edit.AddChild(*element, "<digressive bump=\"" + bump_text + "\" rebound=\"" + rebound_text + knees +
                                  "\" bump_beyond=\"" + (bump_beyond.empty() ? bump_text : bump_beyond) +
                                  "\" rebound_beyond=\"" + (rebound_beyond.empty() ? rebound_text : rebound_beyond) +
                                  "\"/>");
      edit.Remove(*law);
    }
    addition.values = [before, knee](double amount) {
      std::vector<double> values;
      for (const double rate : before) values.push_back((1 - amount) * rate);
      values.push_back(knee);
      return values;
    };
    addition.parameters = names;
    addition.parameters.push_back(at);
    addition.first = 0.5;
    addition.least = -2.5;
    addition.greatest = 0.97;
    addition.count = static_cast<int>(addition.parameters.size());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Bump and rebound of their own: the amount is the logarithm of their ratio.
  void AddBilinear(const AdditionSource::Group& group) {
    Addition addition{.mechanism = "bump_rebound", .elements = NamesOf(group)};
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    addition.words = "rates of bump and rebound of their own in damper " + Quoted(addition.elements);
    const double rate = RateOf(group);
    const NewParameter parameter{.name = source_.ParameterName("c_rebound", addition.elements),
                                 .dimension = kDamping,
                                 .lower = 0.05 * rate,
                                 .upper = 20 * rate,
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written) {
      const tinyxml2::XMLElement* element = edit.Find("fp:damper", name);
      const tinyxml2::XMLElement* law = element ? element->FirstChildElement("linear") : nullptr;
      if (!law) return;
      const std::string text = AttributeText(*law, "rate").value_or("");
      edit.AddChild(*element, "<bilinear bump=\"" + text + "\" rebound=\"$" + parameter.name + "\"/>");
      edit.Remove(*law);
    }
    edit.Add(parameter, 1.5 * rate);
    addition.parameters = {parameter.name};
    addition.values = [rate](double amount) { return std::vector{rate * std::exp(amount)}; };
    addition.first = 0.4;
    addition.least = -3;
    addition.greatest = 3;
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  void AddGas(const AdditionSource::Group& group) {
    constexpr double kFirst_N = 100;
    Addition addition{.mechanism = "gas", .elements = NamesOf(group)};
    addition.words = "gas force on the rod of damper " + Quoted(addition.elements);
    addition.values = [](double force) { return std::vector{force}; };
    addition.first = kFirst_N;
    addition.greatest = 1e4;
    const NewParameter parameter{.name = source_.ParameterName("gas", addition.elements),
                                 .dimension = kForce,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    AddAsChild(addition, parameter, "<gas force=\"$" + parameter.name + "\"/>");
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
  std::vector<FittedDamper> dampers_;
  std::vector<ForceLine> lines_;
};

}  // namespace

void AddDamperAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  DamperAdditions(source, additions).AddAll();
}

}  // namespace fourpost
