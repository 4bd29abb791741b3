#include <algorithm>
#include <cmath>

#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/suggest/addition_source.h"
#include "identify/suggest/new_friction.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// A damper in line with a spring needs a rate: one that adds little, of the spring's rate.
constexpr double kParallelRate_s = 2e-4;

class SpringAdditions {
 public:
  SpringAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), additions_(additions) {
    for (const Spring& spring : source.vehicle().springs) {
      lines_.push_back(spring.line);
      are_coils_.push_back(spring.kind == Spring::Kind::kCoil ? 1 : 0);
    }
  }

  void AddAll() {
    for (const AdditionSource::Group& group : source_.Groups(lines_, are_coils_)) {
      AddCubic(group);
      for (const double gap : {0.005, 0.01, 0.02, 0.035, 0.06})
        for (const char* side : {"bump", "rebound"})
          if (!HasStop(group, side)) AddStop(group, side, gap);
      if (group.size() == 2) AddBar(group);
    }
  }

  void AddAllHysteresis() {
    for (const AdditionSource::Group& group : source_.Groups(lines_, are_coils_)) {
      if (HasHysteresis(group)) continue;
      for (const double ratio : {2, 6, 20}) AddHysteresis(group, ratio);
    }
  }

 private:
  std::vector<std::string> NamesOf(const AdditionSource::Group& group) const {
    std::vector<std::string> names;
    for (const std::size_t i : group) names.push_back(source_.vehicle().springs[i].name);
    return names;
  }

  double StiffnessOf(const AdditionSource::Group& group) const {
    return source_.vehicle().springs[group.front()].law.RateAt(source_.values());
  }

  /// Between the same bodies: a stop of a coil may stand beside it.
  bool HasStop(const AdditionSource::Group& group, std::string_view side) const {
    const Spring& coil = source_.vehicle().springs[group.front()];
    for (const Spring& other : source_.vehicle().springs) {
      if (other.kind != Spring::Kind::kStop) continue;
      if (other.line.parent.link != coil.line.parent.link || other.line.child.link != coil.line.child.link) continue;
      for (const SpringDescription::Knee& knee : other.law.knees)
        if ((knee.side < 0) == (side == "bump")) return true;
    }
    return false;
  }

  /// Friction in line with a spring, between the same bodies.
  bool HasHysteresis(const AdditionSource::Group& group) const {
    const ForceLine& coil = source_.vehicle().springs[group.front()].line;
    const std::vector<const Damper*> friction = source_.FrictionBetween(coil.parent.link, coil.child.link);
    return std::any_of(friction.begin(), friction.end(),
                       [](const Damper* damper) { return damper->series.has_value(); });
  }

  /// Friction that gives way before it slides, as between leaves or in rubber: in line with a spring of `ratio` times
  /// this one's rate. The amount is the force.
  void AddHysteresis(const AdditionSource::Group& group, double ratio) {
    constexpr double kFirst_m = 1e-3;
    constexpr double kMost_m = 0.1;
    const double stiffness = StiffnessOf(group);
    if (!(stiffness > 0)) return;
    Addition addition{.mechanism = "hysteresis", .elements = NamesOf(group)};
    addition.words = "elastic friction (hysteresis) beside spring " + Quoted(addition.elements);
    const double line = ratio * stiffness;
    addition.values = [line](double force) { return std::vector{force, NewFriction::kFirstSpeed_mps, line}; };
    addition.first = kFirst_m * stiffness;
    addition.greatest = kMost_m * stiffness;
    addition.count = 3;
    const NewFriction friction(source_, addition, "hysteresis");
    const NewParameter rate{.name = source_.ParameterName("k_hysteresis", addition.elements),
                            .dimension = kStiffness,
                            .lower = line / 10,
                            .upper = 10 * line,
                            .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const auto& [name, ends] : source_.EndsOf("fp:spring", addition.elements))
      edit.Add("<fp:damper name=\"" + source_.ElementName("hysteresis", name, group.size() == 1) + "\" " + ends +
               "><linear rate=\"" + FormatNumber(AtDigits(kParallelRate_s * line, 3)) + " N*s/m\"/>" + friction.Text() +
               "<series stiffness=\"$" + rate.name + "\"/></fp:damper>");
    Finish(std::move(addition), {friction.force(), friction.speed(), rate}, edit);
  }

  void AddCubic(const AdditionSource::Group& group) {
    constexpr double kTravel = 0.1;
    if (!source_.vehicle().springs[group.front()].law.IsLinear()) return;
    Addition addition{.mechanism = "spring_cubic", .elements = NamesOf(group)};
    addition.words = "hardening of spring " + Quoted(addition.elements);
    const std::vector<std::string> written = source_.WrittenOf("fp:spring", addition.elements);
    if (written.empty()) return;
    addition.values = [](double cubic) { return std::vector{cubic}; };
    addition.first = StiffnessOf(group) / (kTravel * kTravel);
    addition.greatest = 1e3 * addition.first;
    const NewParameter parameter{.name = source_.ParameterName("k3", addition.elements),
                                 .dimension = kCubicStiffness,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written) {
      const tinyxml2::XMLElement* element = edit.Find("fp:spring", name);
      const tinyxml2::XMLElement* law = element ? element->FirstChildElement("linear") : nullptr;
      if (!law) return;
      edit.Rename(*law, "cubic");
      edit.Set(*law, "cubic", '$' + parameter.name);
    }
    Finish(std::move(addition), {parameter}, edit);
  }

  void AddStop(const AdditionSource::Group& group, const std::string& side, double gap) {
    Addition addition{.mechanism = side + "_stop", .elements = NamesOf(group)};
    addition.words = side + " stop beside spring " + Quoted(addition.elements);
    const double stiffness = StiffnessOf(group);
    addition.values = [gap](double rate) { return std::vector{rate, gap}; };
    addition.first = stiffness;
    addition.greatest = 1e3 * stiffness;
    addition.count = 2;
    const std::string source = "suggested: " + addition.words;
    const NewParameter rate{.name = source_.ParameterName("k_" + side, addition.elements),
                            .dimension = kStiffness,
                            .lower = 0,
                            .upper = addition.greatest,
                            .source = source};
    const NewParameter place{.name = source_.ParameterName("gap_" + side, addition.elements),
                             .dimension = kLength,
                             .lower = gap / 4,
                             .upper = 4 * gap,
                             .source = source};
    VehicleEdit edit = source_.Edit();
    for (const auto& [name, ends] : source_.EndsOf("fp:spring", addition.elements))
      edit.Add("<fp:stop name=\"" + source_.ElementName(side + "_stop", name, group.size() == 1) + "\" " + ends + "><" +
               side + " gap=\"$" + place.name + "\" stiffness=\"$" + rate.name + "\"/></fp:stop>");
    Finish(std::move(addition), {rate, place}, edit);
  }

  /// Along the lines of both springs.
  void AddBar(const AdditionSource::Group& group) {
    const auto links_of = [&](std::size_t i) {
      const ForceLine& line = source_.vehicle().springs[i].line;
      return std::pair(line.parent.link, line.child.link);
    };
    for (const AntiRollBar& bar : source_.vehicle().antiroll_bars)
      if (std::pair(bar.left.parent.link, bar.left.child.link) == links_of(group.front()) ||
          std::pair(bar.right.parent.link, bar.right.child.link) == links_of(group.front()))
        return;
    Addition addition{.mechanism = "antiroll", .elements = NamesOf(group)};
    addition.words = "anti-roll bar between springs " + Quoted(addition.elements);
    addition.values = [](double stiffness) { return std::vector{stiffness}; };
    addition.first = 0.2 * StiffnessOf(group);
    addition.greatest = 50 * StiffnessOf(group);
    const NewParameter parameter{.name = source_.ParameterName("k_bar", {addition.elements.front()}),
                                 .dimension = kStiffness,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    std::vector<std::string> ends;
    for (const std::string& name : addition.elements)
      for (const auto& [of, text] : source_.EndsOf("fp:spring", {name})) ends.push_back(text);
    if (ends.size() != 2) return;
    VehicleEdit edit = source_.Edit();
    edit.Add("<fp:antiroll name=\"" + source_.ElementName("bar", addition.elements.front(), true) + "\" stiffness=\"$" +
             parameter.name + "\"><left " + ends[0] + "/><right " + ends[1] + "/></fp:antiroll>");
    Finish(std::move(addition), {parameter}, edit);
  }

  void Finish(Addition addition, const std::vector<NewParameter>& parameters, VehicleEdit& edit) {
    const std::vector<double> values = addition.values(addition.first);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      addition.parameters.push_back(parameters[i].name);
      edit.Add(parameters[i], values[i]);
    }
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
  std::vector<ForceLine> lines_;
  std::vector<char> are_coils_;
};

}  // namespace

void AddSpringAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  SpringAdditions(source, additions).AddAll();
}

void AddHysteresisAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  SpringAdditions(source, additions).AddAllHysteresis();
}

}  // namespace fourpost
