#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "identify/suggest/fitted_dampers.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// A damper's law with a rate at rest in each direction, as the file has it.
struct WrittenLaw {
  const tinyxml2::XMLElement* damper = nullptr;
  const tinyxml2::XMLElement* element = nullptr;
  std::string bump;
  std::string rebound;
  std::string bump_beyond = {};
  std::string rebound_beyond = {};

  bool HasOneRate() const { return bump == rebound && bump_beyond == rebound_beyond; }

  void Replace(VehicleEdit& edit, const std::string& law) const {
    edit.AddChild(*damper, law);
    edit.Remove(*element);
  }
};

/// Laws of dampers, and gas.
class DamperAdditions {
 public:
  DamperAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), dampers_(source), additions_(additions) {}

  void AddAll() {
    using Kind = DashpotDescription::Kind;
    const auto is = [](const FittedDamper& d, Kind kind) { return d.HasRate() && d.damper->law.kind == kind; };
    for (const auto& group : dampers_.GroupsOf([&](const FittedDamper& d) { return is(d, Kind::kBilinear); })) {
      for (const double knee : {0.05, 0.1, 0.2, 0.4})
        for (const Sides sides : {Sides::kBoth, Sides::kBump, Sides::kRebound}) AddDigression(group, knee, sides);
      AddSaturation(group);
      AddOwnRates(group);
      AddSmoothPassage(group);
    }
    for (const auto& group : dampers_.GroupsOf([&](const FittedDamper& d) { return is(d, Kind::kDigressive); }))
      AddOwnRates(group);
    for (const auto& group :
         dampers_.GroupsOf([&](const FittedDamper& d) { return !d.damper->hydraulic && !HasGas(d); }))
      AddGas(group);
  }

 private:
  enum class Sides { kBoth, kBump, kRebound };

  /// Of the dampers that are to be written; none where one has another law, or an earlier spelling.
  std::vector<WrittenLaw> LawsOf(const std::vector<std::string>& dampers, const VehicleEdit& edit) const {
    std::vector<WrittenLaw> laws;
    for (const std::string& name : source_.WrittenOf("fp:damper", dampers)) {
      WrittenLaw law{.damper = edit.Find("fp:damper", name)};
      if (!law.damper) return {};
      for (const char* tag : {"linear", "bilinear", "digressive"})
        if (!law.element) law.element = law.damper->FirstChildElement(tag);
      if (!law.element) return {};
      const auto text = [&](const char* attribute) { return AttributeText(*law.element, attribute).value_or(""); };
      law.bump = text(AttributeText(*law.element, "rate") ? "rate" : "bump");
      law.rebound = text(AttributeText(*law.element, "rate") ? "rate" : "rebound");
      law.bump_beyond = text("bump_beyond");
      law.rebound_beyond = text("rebound_beyond");
      if (law.bump.empty() || law.rebound.empty()) return {};
      laws.push_back(std::move(law));
    }
    return laws;
  }

  bool HasGas(const FittedDamper& one) const {
    const std::vector<Spring>& springs = source_.vehicle().springs;
    return std::any_of(springs.begin(), springs.end(), [&](const Spring& spring) {
      return spring.kind == Spring::Kind::kGas && spring.name == one.damper->name;
    });
  }

  /// Slopes beyond the knees are 1 - amount times those before them. Where both directions share a rate they share the
  /// slope as well: a knee of one direction would imitate rates of their own.
  void AddDigression(const AdditionSource::Group& group, double knee, Sides sides) {
    const FittedDamper& one = dampers_.at(group.front());
    Addition addition{.mechanism = "digression", .elements = dampers_.NamesOf(group)};
    const char* where = sides == Sides::kBoth ? "" : sides == Sides::kBump ? " in bump" : " in rebound";
    addition.words = "knee" + std::string(where) + " in the law of damper " + Quoted(addition.elements);
    VehicleEdit edit = source_.Edit();
    const std::vector<WrittenLaw> laws = LawsOf(addition.elements, edit);
    if (laws.empty()) return;
    const bool is_shared = laws.front().HasOneRate();
    if (is_shared && sides != Sides::kBoth) return;
    const std::string text = "suggested: " + addition.words;
    std::vector<double> before;
    const auto slope = [&](const char* side, double rate) {
      addition.parameters.push_back(source_.ParameterName(std::string("c_beyond") + side, addition.elements));
      before.push_back(rate);
      edit.Add({.name = addition.parameters.back(),
                .dimension = kDamping,
                .lower = 0.02 * rate,
                .upper = 4 * rate,
                .source = text},
               0.5 * rate);
      return '$' + addition.parameters.back();
    };
    const std::string bump_beyond = sides == Sides::kRebound ? "" : slope(is_shared ? "" : "_bump", one.bump);
    const std::string rebound_beyond = sides == Sides::kBump ? ""
                                       : is_shared           ? bump_beyond
                                                             : slope("_rebound", one.rebound);
    const std::string at = source_.ParameterName("v_knee", addition.elements);
    edit.Add({.name = at, .dimension = kVelocity, .lower = knee / 4, .upper = 4 * knee, .source = text}, knee);
    addition.parameters.push_back(at);
    for (const WrittenLaw& law : laws)
      law.Replace(edit, "<digressive bump=\"" + law.bump + "\" rebound=\"" + law.rebound + "\" bump_knee=\"$" + at +
                            "\" rebound_knee=\"$" + at + "\" bump_beyond=\"" +
                            (bump_beyond.empty() ? law.bump : bump_beyond) + "\" rebound_beyond=\"" +
                            (rebound_beyond.empty() ? law.rebound : rebound_beyond) + "\"/>");
    addition.values = [before, knee](double amount) {
      std::vector<double> values;
      for (const double rate : before) values.push_back((1 - amount) * rate);
      values.push_back(knee);
      return values;
    };
    addition.first = 0.5;
    addition.least = -2.5;
    addition.greatest = 0.97;
    addition.count = static_cast<int>(addition.parameters.size());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// A force that levels off with no knee: one of the alternatives for digression. The amount is 1 / speed.
  void AddSaturation(const AdditionSource::Group& group) {
    constexpr double kLeast_mps = 0.02;
    constexpr double kMost_mps = 100;
    Addition addition{.mechanism = "digression", .elements = dampers_.NamesOf(group)};
    addition.words = "force that levels off in damper " + Quoted(addition.elements);
    VehicleEdit edit = source_.Edit();
    const std::vector<WrittenLaw> laws = LawsOf(addition.elements, edit);
    if (laws.empty()) return;
    addition.first = 1;
    const auto speed = [&](const char* side) {
      addition.parameters.push_back(source_.ParameterName(std::string("v_half") + side, addition.elements));
      edit.Add({.name = addition.parameters.back(),
                .dimension = kVelocity,
                .lower = kLeast_mps,
                .upper = kMost_mps,
                .source = "suggested: " + addition.words},
               1 / addition.first);
      return '$' + addition.parameters.back();
    };
    const bool is_shared = laws.front().HasOneRate();
    const std::string bump = speed(is_shared ? "" : "_bump");
    const std::string rebound = is_shared ? bump : speed("_rebound");
    for (const WrittenLaw& law : laws)
      law.Replace(edit, "<saturating bump=\"" + law.bump + "\" rebound=\"" + law.rebound + "\" bump_speed=\"" + bump +
                            "\" rebound_speed=\"" + rebound + "\"/>");
    const std::size_t count = addition.parameters.size();
    addition.values = [count](double amount) { return std::vector(count, 1 / amount); };
    addition.least = 1 / kMost_mps;
    addition.greatest = 1 / kLeast_mps;
    addition.count = static_cast<int>(count);
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Bump and rebound that pass into each other over a speed, the amount, and not at rest.
  void AddSmoothPassage(const AdditionSource::Group& group) {
    Addition addition{.mechanism = "smooth_passage", .elements = dampers_.NamesOf(group)};
    addition.words = "smooth passage from bump to rebound in damper " + Quoted(addition.elements);
    VehicleEdit edit = source_.Edit();
    const std::vector<WrittenLaw> laws = LawsOf(addition.elements, edit);
    if (laws.empty() || laws.front().HasOneRate()) return;
    addition.first = 0.03;
    addition.least = 1e-3;
    addition.greatest = 2;
    addition.parameters = {source_.ParameterName("v_passage", addition.elements)};
    edit.Add({.name = addition.parameters.front(),
              .dimension = kVelocity,
              .lower = addition.least,
              .upper = addition.greatest,
              .source = "suggested: " + addition.words},
             addition.first);
    for (const WrittenLaw& law : laws)
      law.Replace(edit, "<smooth bump=\"" + law.bump + "\" rebound=\"" + law.rebound + "\" speed=\"$" +
                            addition.parameters.front() + "\"/>");
    addition.values = [](double speed) { return std::vector{speed}; };
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  /// Bump and rebound of their own where they share a rate: the amount is the logarithm of their ratio.
  void AddOwnRates(const AdditionSource::Group& group) {
    Addition addition{.mechanism = "bump_rebound", .elements = dampers_.NamesOf(group)};
    addition.words = "rates of bump and rebound of their own in damper " + Quoted(addition.elements);
    VehicleEdit edit = source_.Edit();
    const std::vector<WrittenLaw> laws = LawsOf(addition.elements, edit);
    if (laws.empty() || !std::all_of(laws.begin(), laws.end(), std::mem_fn(&WrittenLaw::HasOneRate))) return;
    std::vector<double> shared;
    const auto own = [&](const char* name, double rate) {
      addition.parameters.push_back(source_.ParameterName(name, addition.elements));
      shared.push_back(rate);
      edit.Add({.name = addition.parameters.back(),
                .dimension = kDamping,
                .lower = 0.05 * rate,
                .upper = 20 * rate,
                .source = "suggested: " + addition.words},
               1.5 * rate);
      return '$' + addition.parameters.back();
    };
    const DashpotDescription& description = dampers_.at(group.front()).damper->law;
    const std::string rebound = own("c_rebound", dampers_.RateOf(group));
    const bool has_knee = description.kind == DashpotDescription::Kind::kDigressive;
    const std::string beyond =
        has_knee ? own("c_beyond_rebound", description.rebound_knee.rate.At(source_.values())) : "";
    for (const WrittenLaw& law : laws)
      if (has_knee) {
        edit.Set(*law.element, "rebound", rebound);
        edit.Set(*law.element, "rebound_beyond", beyond);
      } else law.Replace(edit, "<bilinear bump=\"" + law.bump + "\" rebound=\"" + rebound + "\"/>");
    addition.values = [shared](double amount) {
      std::vector<double> values;
      for (const double rate : shared) values.push_back(rate * std::exp(amount));
      return values;
    };
    addition.first = 0.4;
    addition.least = -3;
    addition.greatest = 3;
    addition.count = static_cast<int>(addition.parameters.size());
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
