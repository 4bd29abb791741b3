#include "identify/suggest/addition_source.h"

namespace fourpost {
namespace {

/// Ends of an element that holds two points together.
template <typename Element>
std::vector<ForceLine> LinesOf(const std::vector<Element>& elements) {
  std::vector<ForceLine> lines;
  for (const Element& element : elements)
    lines.push_back({.parent = element.parent, .child = element.child, .axis = {}});
  return lines;
}

class BushAdditions {
 public:
  BushAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), additions_(additions) {}

  void AddAll() {
    const Vehicle& vehicle = source_.vehicle();
    Add(vehicle.balls, "fp:ball", "joint", "fp:bushing",
        [](const std::string& k) { return "<translation x=\"" + k + "\" y=\"" + k + "\" z=\"" + k + "\"/>"; });
    Add(vehicle.rods, "fp:rod", "rod", "fp:spring",
        [](const std::string& k) { return "<linear stiffness=\"" + k + "\"/>"; });
  }

 private:
  /// In place of a rigid element an elastic one between the same points. The amount is its compliance.
  template <typename Element, typename Law>
  void Add(const std::vector<Element>& elements, const char* tag, const char* noun, const char* elastic, Law law) {
    constexpr double kFirst_Npm = 5e6;
    const std::vector<char> all(elements.size(), 1);
    for (const AdditionSource::Group& group : source_.Groups(LinesOf(elements), all)) {
      Addition addition{.mechanism = "bush", .elements = {}};
      for (const std::size_t i : group) addition.elements.push_back(elements[i].name);
      const std::vector<std::string> written = source_.WrittenOf(tag, addition.elements);
      if (written.empty()) continue;
      addition.words = std::string("bush in ") + noun + ' ' + Quoted(addition.elements);
      addition.values = [](double compliance) { return std::vector{1 / compliance}; };
      addition.first = 1 / kFirst_Npm;
      addition.least = 1e-9;
      addition.greatest = 1e-5;
      const NewParameter parameter{.name = source_.ParameterName("k_bush", addition.elements),
                                   .dimension = kStiffness,
                                   .lower = 1e5,
                                   .upper = 1e9,
                                   .source = "suggested: " + addition.words};
      VehicleEdit edit = source_.Edit();
      for (const std::string& name : written) {
        const tinyxml2::XMLElement* element = edit.Find(tag, name);
        if (!element) continue;
        edit.Rename(*element, elastic);
        if (std::string_view(elastic) == "fp:bushing") edit.Set(*element, "preload", "equilibrium");
        edit.AddChild(*element, law('$' + parameter.name));
      }
      addition.parameters = {parameter.name};
      edit.Add(parameter, kFirst_Npm);
      addition.vehicle = edit.Text();
      additions_.push_back(std::move(addition));
    }
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
};

}  // namespace

void AddBushAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  BushAdditions(source, additions).AddAll();
}

}  // namespace fourpost
