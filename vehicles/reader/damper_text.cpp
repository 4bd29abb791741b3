#include "vehicles/reader/damper_text.h"

#include <stdexcept>
#include <vector>

#include <tinyxml2.h>

#include "analysis/text/count_check.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/reader/file_tags.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// What "$k", "-$k" or "0.5*$k" comes to; nothing for any other text.
std::optional<std::string> Resolved(std::string_view text, const Vehicle& vehicle, std::span<const double> values) {
  const std::size_t dollar = text.find('$');
  if (dollar == std::string_view::npos) return std::nullopt;
  std::string_view factor = Trimmed(text.substr(0, dollar));
  if (factor.ends_with('*')) factor = Trimmed(factor.substr(0, factor.size() - 1));
  const double share = factor == "-" ? -1 : ParseNumber(factor).value_or(1);
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    if (vehicle.parameters[i].name == Trimmed(text.substr(dollar + 1)))
      return FormatQuantity(share * values[i], vehicle.parameters[i].unit);
  return std::nullopt;
}

void Resolve(XMLElement& element, const Vehicle& vehicle, std::span<const double> values) {
  for (const tinyxml2::XMLAttribute* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
    if (const std::optional<std::string> number = Resolved(attribute->Value(), vehicle, values))
      element.SetAttribute(attribute->Name(), number->c_str());
  for (XMLElement* child : Children(element)) Resolve(*child, vehicle, values);
}

/// Points in place of the file that holds them.
void WriteOut(XMLElement& damper, const FileContent& content) {
  XMLElement* table = damper.FirstChildElement("table");
  tinyxml2::XMLDocument points;
  const std::string xml = "<points>" + content.xml + "</points>";
  if (!table || points.Parse(xml.data(), xml.size()) != tinyxml2::XML_SUCCESS) return;
  table->DeleteAttribute("file");
  for (const XMLElement* point : Children(*points.RootElement()))
    table->InsertEndChild(point->ShallowClone(damper.GetDocument()));
}

}  // namespace

std::string DamperText(const Vehicle& vehicle, const std::string& damper, std::span<const double> parameters) {
  RequireCount("DamperText", "parameters", vehicle.parameters.size(), parameters.size());
  tinyxml2::XMLDocument document;
  if (document.Parse(vehicle.text.data(), vehicle.text.size()) != tinyxml2::XML_SUCCESS)
    throw std::invalid_argument("DamperText: vehicle '" + vehicle.name + "' has no text of a file");
  for (XMLElement* element : Children(*document.RootElement(), "fp:damper")) {
    if (AttributeText(*element, "name") != damper) continue;
    if (const FileContent* content = ContentOf(vehicle, *element)) WriteOut(*element, *content);
    Resolve(*element, vehicle, parameters);
    tinyxml2::XMLPrinter printer;
    element->Accept(&printer);
    return printer.CStr();
  }
  return "";
}

}  // namespace fourpost
