#include "vehicles/vehicle_file.h"

#include <tinyxml2.h>

#include "vehicles/body_check.h"
#include "vehicles/element_reader.h"
#include "vehicles/file_faults.h"
#include "vehicles/file_text.h"
#include "vehicles/parameter_reader.h"
#include "vehicles/tag.h"
#include "vehicles/tag_check.h"
#include "vehicles/tree_binding.h"
#include "vehicles/urdf_reader.h"
#include "vehicles/urdf_tree.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Nothing, with a fault, for a text that is no XML or does not describe a robot.
const XMLElement* ParseRobot(const std::string& text, tinyxml2::XMLDocument& document, FileFaults& faults) {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    const std::string name = document.ErrorName();
    faults.Error(document.ErrorLineNum(), "not XML: " + name);
    return nullptr;
  }
  const XMLElement* root = document.RootElement();
  if (root && std::string_view(root->Name()) == "robot") return root;
  faults.Error(root ? root->GetLineNum() : 0, "the file must hold one <robot>");
  return nullptr;
}

Vehicle ReadRobot(const XMLElement& robot, const std::string& text, FileFaults& faults) {
  CheckTags(robot, faults);
  const UrdfTree tree = ReadUrdfTree(robot, faults);
  // urdfdom stops at its first fault and knows no lines: it reads only what is sound so far.
  const bool is_sound = faults.errors() == 0;
  CheckMeshes(tree, faults);
  ParameterReader parameters(robot, faults);
  const std::vector<TreeBinding> bindings = ReadTreeBindings(robot, tree, parameters, faults);
  Vehicle vehicle;
  vehicle.name = AttributeText(robot, "name").value_or("");
  vehicle.file = faults.file();
  vehicle.parameters = parameters.parameters();
  ReadElements(robot, tree, parameters, vehicle, faults);
  parameters.CheckUse();
  if (is_sound) ReadUrdf(text, tree, vehicle, faults);
  if (vehicle.links.empty()) return vehicle;
  Apply(bindings, vehicle);
  CheckBodies(vehicle, faults);
  return vehicle;
}

}  // namespace

std::optional<Vehicle> ReadVehicle(const std::filesystem::path& file, Diagnostics& diagnostics) {
  FileFaults faults(file.string(), diagnostics);
  const std::optional<std::string> text = FileText(file);
  if (!text) {
    faults.Error(0, "cannot be read");
    return std::nullopt;
  }
  tinyxml2::XMLDocument document;
  const XMLElement* robot = ParseRobot(*text, document, faults);
  if (!robot) return std::nullopt;
  Vehicle vehicle = ReadRobot(*robot, *text, faults);
  if (faults.errors() > 0) return std::nullopt;
  return vehicle;
}

}  // namespace fourpost
