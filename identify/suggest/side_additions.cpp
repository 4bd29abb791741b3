#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "identify/suggest/addition_source.h"
#include "vehicles/description/element_list.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

struct Kind {
  const char* tag;
  const char* noun;
};

constexpr Kind kKinds[] = {{"fp:spring", "spring"}, {"fp:damper", "damper"}, {"fp:tyre", "tyre"}};

/// The parameter that "2*$c" refers to; empty: a number.
std::string ReferredBy(const std::string& text) {
  const std::size_t dollar = text.find('$');
  return dollar == std::string::npos ? "" : text.substr(dollar + 1);
}

/// Parameters of an element, attributes of its children included, with all places that refer to them.
struct Reference {
  const tinyxml2::XMLElement* element;
  std::string attribute;
  std::string text;
  std::string parameter;
};

void AddReferences(const tinyxml2::XMLElement& element, std::vector<Reference>& references) {
  for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
    if (const std::string parameter = ReferredBy(attribute->Value()); !parameter.empty())
      references.push_back({&element, attribute->Name(), attribute->Value(), parameter});
  for (const tinyxml2::XMLElement* child : Children(element)) AddReferences(*child, references);
}

class SideAdditions {
 public:
  SideAdditions(const AdditionSource& source, std::vector<Addition>& additions)
      : source_(source), additions_(additions) {
    // Elements that use a parameter, by the parameter.
    for (const ElementNumber& number : NumbersOf(source.vehicle()))
      if (number.number.parameter >= 0)
        users_[source.vehicle().parameters[static_cast<std::size_t>(number.number.parameter)].name].insert(
            number.element);
  }

  void AddAll() {
    const Vehicle& vehicle = source_.vehicle();
    for (const Spring& spring : vehicle.springs)
      if (spring.kind == Spring::Kind::kCoil) Add(kKinds[0], spring.name);
    for (const Damper& damper : vehicle.dampers) Add(kKinds[1], damper.name);
    for (const Tyre& tyre : vehicle.tyres) Add(kKinds[2], tyre.name);
  }

 private:
  /// All numbers of the element that it shares with others become its own; the amount is the logarithm by which they
  /// differ from those of the others.
  void Add(const Kind& kind, const std::string& name) {
    VehicleEdit edit = source_.Edit();
    const auto twin = source_.vehicle().twins.find(name);
    tinyxml2::XMLDocument written_out;
    const tinyxml2::XMLElement* element = edit.Find(kind.tag, name);
    const bool is_image = !element && twin != source_.vehicle().twins.end();
    if (is_image) element = source_.ImageOf(kind.tag, twin->second, written_out);
    else if (source_.WrittenOf(kind.tag, {name}).empty()) return;  // its image has them of its own
    if (!element) return;
    std::vector<Reference> references;
    AddReferences(*element, references);
    Addition addition{.mechanism = std::string("own_") + kind.noun, .elements = {name}};
    addition.words = std::string(kind.noun) + ' ' + Quoted({name}) + " with numbers of its own";
    std::map<std::string, std::string> own;
    std::vector<double> shared;
    for (const Reference& reference : references) {
      if (users_[reference.parameter].size() < 2) continue;
      const Parameter* parameter = Find(reference.parameter);
      const double value = parameter ? source_.values()[Place(*parameter)] : 0;
      if (!(value > 0)) continue;
      if (!own.contains(reference.parameter)) {
        own[reference.parameter] = source_.ParameterName(reference.parameter, {name});
        addition.parameters.push_back(own[reference.parameter]);
        shared.push_back(value);
        edit.Add({.name = own[reference.parameter],
                  .dimension = parameter->dimension,
                  .lower = 0.1 * value,
                  .upper = 10 * value,
                  .source = "suggested: " + addition.words},
                 value);
      }
      const std::string text = reference.text.substr(0, reference.text.find('$')) + '$' + own[reference.parameter];
      if (is_image)
        const_cast<tinyxml2::XMLElement*>(reference.element)->SetAttribute(reference.attribute.c_str(), text.c_str());
      else edit.Set(*reference.element, reference.attribute, text);
    }
    if (is_image && !own.empty()) {
      tinyxml2::XMLPrinter printer(nullptr, true);
      written_out.Print(&printer);
      edit.Add(printer.CStr());
    }
    if (own.empty()) return;
    addition.values = [shared](double amount) {
      std::vector<double> values;
      for (const double value : shared) values.push_back(value * std::exp(amount));
      return values;
    };
    addition.first = -0.1;
    addition.least = -2.2;
    addition.greatest = 2.2;
    addition.count = static_cast<int>(own.size());
    addition.vehicle = edit.Text();
    additions_.push_back(std::move(addition));
  }

  const Parameter* Find(const std::string& name) const {
    for (const Parameter& parameter : source_.vehicle().parameters)
      if (parameter.name == name) return &parameter;
    return nullptr;
  }

  std::size_t Place(const Parameter& parameter) const {
    return static_cast<std::size_t>(&parameter - source_.vehicle().parameters.data());
  }

  const AdditionSource& source_;
  std::vector<Addition>& additions_;
  std::map<std::string, std::set<std::string>> users_;
};

}  // namespace

void AddSideAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  SideAdditions(source, additions).AddAll();
}

void AddHeldAdditions(const AdditionSource& source, const std::vector<std::size_t>& free,
                      std::vector<Addition>& additions) {
  const std::vector<Parameter>& parameters = source.vehicle().parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    if (!(parameter.lower < parameter.upper) || std::find(free.begin(), free.end(), i) != free.end()) continue;
    Addition addition{.mechanism = "free", .elements = {parameter.name}};
    addition.words = "parameter '" + parameter.name + "' fitted in place of held";
    addition.parameters = {parameter.name};
    const double value = source.values()[i];
    const double range = parameter.upper - parameter.lower;
    if (parameter.lower > 0) {
      addition.values = [value](double amount) { return std::vector{value * std::exp(amount)}; };
      addition.least = std::log(parameter.lower / value);
      addition.greatest = std::log(parameter.upper / value);
      addition.first = addition.greatest > 0.1 ? 0.1 : -0.1;
    } else {
      addition.values = [value, range](double amount) { return std::vector{value + amount * range}; };
      addition.least = (parameter.lower - value) / range;
      addition.greatest = (parameter.upper - value) / range;
      addition.first = addition.greatest > 0.05 ? 0.05 : -0.05;
    }
    additions.push_back(std::move(addition));
  }
}

}  // namespace fourpost
