#include "vehicles/reader/vehicle_file.h"

#include <utility>

#include <tinyxml2.h>

#include "analysis/files/text_file.h"
#include "vehicles/reader/body_check.h"
#include "vehicles/reader/drake_tags.h"
#include "vehicles/reader/element_reader.h"
#include "vehicles/reader/file_tags.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/mirror.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/solid_reader.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/reader/tree_binding.h"
#include "vehicles/reader/tree_reference.h"
#include "vehicles/reader/urdf_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"
#include "vehicles/tags/xml_limits.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// What tinyxml2 means by its commonest errors.
Found XmlFault(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT: return {&kXmlEmpty};
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return {&kXmlTagOpen};
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE: return {&kXmlAttribute};
    case tinyxml2::XML_ERROR_PARSING_COMMENT: return {&kXmlComment};
    default: return {&kXmlUnreadable, {document.ErrorName()}};
  }
}

/// Nothing, with a fault, for a text that is no XML or does not describe one robot.
XMLElement* ParseRobot(const std::string& text, tinyxml2::XMLDocument& document, FileFaults& faults) {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    faults.Report(XmlFault(document), document.ErrorLineNum());
    return nullptr;
  }
  XMLElement* root = document.RootElement();
  const XMLElement* second = root ? root->NextSiblingElement() : nullptr;
  if (root && !second && std::string_view(root->Name()) == "robot") return root;
  faults.Report(kNotOneRobot, second ? LineOf(*second) : root ? LineOf(*root) : 0);
  return nullptr;
}

std::string Printed(const tinyxml2::XMLDocument& document) {
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

Vehicle ReadRobot(XMLElement& robot, const std::string& text, FileFaults& faults) {
  const bool has_drake = ReplaceDrakeTags(robot, faults);
  const bool has_references = ReplaceTreeReferences(robot, &faults);
  std::vector<FileContent> contents = FillFileTags(robot, faults);
  CheckTags(robot, faults);
  TwinNames twins = AddTwins(robot, faults);
  const bool is_as_written = twins.empty() && !has_drake && !has_references;
  faults.SetTwins(twins);
  const UrdfTree tree = ReadUrdfTree(robot, faults);
  // urdfdom stops at its first fault and knows no lines: it reads only what is sound so far.
  const bool is_sound = faults.errors() == 0;
  CheckMeshes(tree, faults);
  ParameterReader parameters(robot, faults);
  const std::vector<TreeBinding> bindings = ReadTreeBindings(robot, tree, parameters, faults);
  Vehicle vehicle;
  vehicle.name = AttributeText(robot, "name").value_or("");
  vehicle.file = faults.file();
  vehicle.text = text;
  vehicle.twins = std::move(twins);
  vehicle.contents = std::move(contents);
  vehicle.parameters = parameters.parameters();
  ReadElements(robot, tree, parameters, vehicle, faults);
  if (is_sound) ReadUrdf(is_as_written ? text : Printed(*robot.GetDocument()), tree, vehicle, faults);
  const bool has_masses = ReadSolids(robot, tree, parameters, vehicle, faults);
  parameters.CheckUse();
  if (vehicle.links.empty()) return vehicle;
  Apply(bindings, vehicle);
  if (has_masses) CheckBodies(vehicle, faults);
  CheckLengths(vehicle, faults);
  PlaceOnCurves(vehicle, faults);
  CheckDrakeBushings(robot, vehicle, faults);
  CheckWheels(vehicle, faults);
  return vehicle;
}

}  // namespace

std::optional<Vehicle> ReadVehicle(const std::filesystem::path& file, Diagnostics& diagnostics) {
  FileFaults faults(file.string(), diagnostics);
  if (!HasLegalSize(file, faults)) return std::nullopt;
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return std::nullopt;
  return ReadVehicleText(*text, file, diagnostics);
}

std::optional<Vehicle> ReadVehicleText(const std::string& text, const std::filesystem::path& file,
                                       Diagnostics& diagnostics) {
  FileFaults faults(file.string(), diagnostics);
  if (!IsWithinXmlLimits(text, faults)) return std::nullopt;
  tinyxml2::XMLDocument document;
  XMLElement* robot = ParseRobot(text, document, faults);
  if (!robot) return std::nullopt;
  Vehicle vehicle = ReadRobot(*robot, text, faults);
  if (faults.errors() > 0) return std::nullopt;
  return vehicle;
}

}  // namespace fourpost
