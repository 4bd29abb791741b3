#include <algorithm>

#include "identify/suggest/addition_source.h"

namespace fourpost {
namespace {

class TyreAdditions {
 public:
  TyreAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), additions_(additions) {}

  void AddAll() {
    const std::vector<Tyre>& tyres = source_.vehicle().tyres;
    std::vector<ForceLine> lines;
    std::vector<char> undamped;
    std::vector<char> sticking;
    for (const Tyre& tyre : tyres) {
      lines.push_back({.parent = tyre.point, .child = tyre.point, .axis = {}});
      undamped.push_back(tyre.damping.IsZero() ? 1 : 0);
      sticking.push_back(tyre.lifts_off ? 0 : 1);
    }
    for (const auto& group : WithAll(source_.Groups(lines, undamped), undamped)) AddDamping(group);
    for (const auto& group : WithAll(source_.Groups(lines, sticking), sticking)) AddLiftoff(group);
  }

 private:
  /// All of them together as well, where there are more than a pair.
  static std::vector<AdditionSource::Group> WithAll(std::vector<AdditionSource::Group> groups,
                                                    const std::vector<char>& takes) {
    AdditionSource::Group all;
    for (std::size_t i = 0; i < takes.size(); ++i)
      if (takes[i] != 0) all.push_back(i);
    if (all.size() > 1 && std::find(groups.begin(), groups.end(), all) == groups.end()) groups.push_back(all);
    return groups;
  }

  std::vector<std::string> NamesOf(const AdditionSource::Group& group) const {
    std::vector<std::string> names;
    for (const std::size_t i : group) names.push_back(source_.vehicle().tyres[i].name);
    return names;
  }

  void AddDamping(const AdditionSource::Group& group) {
    constexpr double kFirst_s = 3e-4;
    Addition addition{.mechanism = "tyre_damping", .elements = NamesOf(group)};
    const std::vector<std::string> written = source_.WrittenOf("fp:tyre", addition.elements);
    if (written.empty()) return;
    const double stiffness = source_.vehicle().tyres[group.front()].law.RateAt(source_.values(), 0);
    addition.words = "damping of tyre " + Quoted(addition.elements);
    addition.values = [](double damping) { return std::vector{damping}; };
    addition.first = kFirst_s * stiffness;
    addition.greatest = 100 * addition.first;
    const NewParameter parameter{.name = source_.ParameterName("ct", addition.elements),
                                 .dimension = kDamping,
                                 .lower = 0,
                                 .upper = addition.greatest,
                                 .source = "suggested: " + addition.words};
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written)
      if (const tinyxml2::XMLElement* element = edit.Find("fp:tyre", name))
        edit.Set(*element, "damping", '$' + parameter.name);
    addition.parameters = {parameter.name};
    edit.Add(parameter, addition.first);
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  void AddLiftoff(const AdditionSource::Group& group) {
    Addition addition{.mechanism = "liftoff", .elements = NamesOf(group)};
    const std::vector<std::string> written = source_.WrittenOf("fp:tyre", addition.elements);
    if (written.empty()) return;
    addition.words = "lift-off of tyre " + Quoted(addition.elements);
    addition.values = [](double) { return std::vector<double>(); };
    addition.first = addition.least = addition.greatest = 1;
    addition.count = 0;
    VehicleEdit edit = source_.Edit();
    for (const std::string& name : written)
      if (const tinyxml2::XMLElement* element = edit.Find("fp:tyre", name)) edit.Set(*element, "liftoff", "true");
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
};

}  // namespace

void AddTyreAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  TyreAdditions(source, additions).AddAll();
}

}  // namespace fourpost
