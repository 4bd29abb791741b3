#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/suggest/fitted_dampers.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// Laws of dampers, and gas.
class DamperAdditions {
 public:
  DamperAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), dampers_(source), additions_(additions) {}

  void AddAll() {
    for (const auto& group : dampers_.GroupsOf([](const FittedDamper& d) {
           return d.HasRate() && d.damper->law.kind == DashpotDescription::Kind::kBilinear;
         })) {
      for (const double knee : {0.05, 0.1, 0.2, 0.4})
        for (const Sides sides : {Sides::kBoth, Sides::kBump, Sides::kRebound}) AddDigression(group, knee, sides);
      AddBilinear(group);
    }
    for (const auto& group :
         dampers_.GroupsOf([&](const FittedDamper& d) { return !d.damper->hydraulic && !HasGas(d); }))
      AddGas(group);
  }

 private:
  enum class Sides { kBoth, kBump, kRebound };

  bool HasGas(const FittedDamper& one) const {
    const std::vector<Spring>& springs = source_.vehicle().springs;
    return std::any_of(springs.begin(), springs.end(), [&](const Spring& spring) {
      return spring.kind == Spring::Kind::kGas && spring.name == one.damper->name;
    });
  }

  /// Slopes beyond the knees are 1 - amount times those before them.
  void AddDigression(const AdditionSource::Group& group, double knee, Sides sides) {
    const FittedDamper& one = dampers_.at(group.front());
    Addition addition{.mechanism = "digression", .elements = dampers_.NamesOf(group)};
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
    Addition addition{.mechanism = "bump_rebound", .elements = dampers_.NamesOf(group)};
    const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
    if (written.empty()) return;
    addition.words = "rates of bump and rebound of their own in damper " + Quoted(addition.elements);
    const double rate = dampers_.RateOf(group);
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
    Addition addition{.mechanism = "gas", .elements = dampers_.NamesOf(group)};
    addition.words = "gas force on the rod of damper " + Quoted(addition.elements);
    addition.values = [](double force) { return std::vector{force}; };
    addition.first = kFirst_N;
    addition.greatest = 1e4;
    const NewParameter parameter{.name = source_.ParameterName("gas", addition.elements),
                                 .dimension = kForce,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    dampers_.AddAsChild(addition, parameter, "<gas force=\"$" + parameter.name + "\"/>", additions_);
  }

  const AdditionSource& source_;
  FittedDampers dampers_;
  std::vector<Addition>& additions_;
};

}  // namespace

void AddDamperAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  DamperAdditions(source, additions).AddAll();
}

}  // namespace fourpost
