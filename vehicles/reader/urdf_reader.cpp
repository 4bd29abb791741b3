#include "vehicles/reader/urdf_reader.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "vehicles/reader/findings.h"
#include "vehicles/shapes/shape_error.h"
#include "vehicles/shapes/sound_meshes.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Takes what urdfdom would print, for as long as it lives.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  // The handler is one for the whole program.
  ConsoleCapture() : lock_(Mutex()) { console_bridge::useOutputHandler(this); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;
  ~ConsoleCapture() override { console_bridge::restorePreviousOutputHandler(); }

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) messages_.push_back(text);
  }
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  static std::mutex& Mutex() {
    static std::mutex mutex;
    return mutex;
  }

  std::lock_guard<std::mutex> lock_;
  std::vector<std::string> messages_;
};

urdf::ModelInterfaceSharedPtr Parse(std::string text, FileFaults& faults) {
  // XML reads any blank in an attribute as a space; urdfdom's parser does not.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  const ConsoleCapture capture;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  for (const std::string& message : capture.messages())
    faults.Report(model ? kUrdfdomWarning : kUrdfdomError, 0, {message});
  if (!model && capture.messages().empty()) faults.Report(kUrdfdomSilent, 0);
  return model;
}

Eigen::Vector3d ToEigen(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d ToEigen(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  const urdf::Rotation& q = pose.rotation;
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  result.translation() = ToEigen(pose.position);
  return result;
}

void ReadInertial(const urdf::Inertial& inertial, Link& link) {
  const Eigen::Isometry3d pose = ToEigen(inertial.origin);
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,         //
      inertial.ixz, inertial.iyz, inertial.izz;
  // Unturned numbers stay as they are written, to the last digit.
  if (!pose.linear().isIdentity(0)) inertia = (pose.linear() * inertia * pose.linear().transpose()).eval();
  link.mass.value = inertial.mass;
  for (Eigen::Index i = 0; i < 3; ++i) link.com[static_cast<std::size_t>(i)].value = pose.translation()[i];
  const std::array<double, 6> numbers = {inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                         inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  for (std::size_t i = 0; i < numbers.size(); ++i) link.inertia[i].value = numbers[i];
}

void ReadShape(const urdf::Geometry& geometry, const std::filesystem::path& vehicle_file, Visual& visual) {
  switch (geometry.type) {
    case urdf::Geometry::MESH: {
      const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
      visual.shape = Visual::Shape::kMesh;
      visual.mesh_file = MeshPath(vehicle_file, mesh.filename).string();
      visual.size = ToEigen(mesh.scale);
      return;
    }
    case urdf::Geometry::BOX:
      visual.shape = Visual::Shape::kBox;
      visual.size = ToEigen(static_cast<const urdf::Box&>(geometry).dim);
      return;
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      visual.shape = Visual::Shape::kCylinder;
      visual.size = {cylinder.radius, cylinder.radius, cylinder.length};
      return;
    }
    case urdf::Geometry::SPHERE:
      visual.shape = Visual::Shape::kSphere;
      visual.size.setConstant(static_cast<const urdf::Sphere&>(geometry).radius);
      return;
  }
  throw std::logic_error("URDF shape that no rule names");
}

Link ReadLink(const urdf::Link& source, const XMLElement& element, const std::filesystem::path& vehicle_file) {
  Link link;
  link.name = source.name;
  link.line = LineOf(element);
  if (source.inertial) ReadInertial(*source.inertial, link);
  for (const urdf::VisualSharedPtr& shape : source.visual_array) {
    Visual visual;
    visual.pose = ToEigen(shape->origin);
    ReadShape(*shape->geometry, vehicle_file, visual);
    link.visuals.push_back(visual);
  }
  return link;
}

/// Whether urdfdom reads all names as we do. XML parsers differ in blanks other than the space.
bool HasAll(const urdf::ModelInterface& model, const UrdfTree& tree, FileFaults& faults) {
  const int errors = faults.errors();
  const auto report = [&](const XMLElement& element) {
    faults.Report(kNameReadDifferently, LineOf(element, "name"), {Describe(element)});
  };
  for (const XMLElement* element : tree.links)
    if (!model.getLink(NameOf(*element))) report(*element);
  for (const XMLElement* element : tree.joints)
    if (!model.getJoint(NameOf(*element))) report(*element);
  return faults.errors() == errors;
}

Joint::Type ToType(int type) {
  switch (type) {
    case urdf::Joint::FIXED: return Joint::Type::kFixed;
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS: return Joint::Type::kRevolute;
    case urdf::Joint::PRISMATIC: return Joint::Type::kPrismatic;
    case urdf::Joint::PLANAR: return Joint::Type::kPlanar;
    case urdf::Joint::FLOATING: return Joint::Type::kFloating;
    default: throw std::logic_error("URDF joint type that no rule names");
  }
}

Joint ReadJoint(const urdf::Joint& source, const XMLElement& element, const UrdfTree& tree) {
  Joint joint;
  joint.name = source.name;
  joint.type = ToType(source.type);
  joint.parent = tree.FindLink(source.parent_link_name);
  joint.child = tree.FindLink(source.child_link_name);
  joint.pose = ToEigen(source.parent_to_joint_origin_transform);
  joint.line = LineOf(element);
  if (joint.type != Joint::Type::kFixed && joint.type != Joint::Type::kFloating)
    joint.axis = ToEigen(source.axis).normalized();
  return joint;
}

std::vector<const XMLElement*> MeshElements(const UrdfTree& tree) {
  std::vector<const XMLElement*> meshes;
  for (const XMLElement* link : tree.links)
    for (const XMLElement* visual : Children(*link, "visual"))
      for (const XMLElement* geometry : Children(*visual, "geometry"))
        for (const XMLElement* mesh : Children(*geometry, "mesh")) meshes.push_back(mesh);
  return meshes;
}

bool IsAddress(const std::string& filename) { return filename.find("://") != std::string::npos; }

Found MeshFault(const std::filesystem::path& path, const std::string& filename) {
  if (IsAddress(filename)) return {&kMeshAddress, {filename}};
  std::error_code failure;
  const bool is_there = std::filesystem::exists(path, failure);
  if (failure) return {&kMeshUnknown, {filename, failure.message()}};
  if (!is_there) return {&kMeshMissing, {filename, path.string()}};
  try {
    CheckMesh(path);
  } catch (const ShapeError& error) {
    return error.About("mesh '" + filename + "'");
  }
  return {};
}

}  // namespace

std::filesystem::path MeshPath(const std::filesystem::path& vehicle_file, const std::string& filename) {
  return std::filesystem::absolute(vehicle_file.parent_path() / filename).lexically_normal();
}

void CheckMeshes(const UrdfTree& tree, FileFaults& faults) {
  std::set<std::string> checked;
  for (const XMLElement* mesh : MeshElements(tree)) {
    const std::string filename = AttributeText(*mesh, "filename").value_or("");
    if (filename.empty() || !checked.insert(filename).second) continue;
    if (const Found fault = MeshFault(MeshPath(faults.file(), filename), filename)) faults.Report(fault, LineOf(*mesh));
  }
}

void ReadUrdf(const std::string& text, const UrdfTree& tree, Vehicle& vehicle, FileFaults& faults) {
  const urdf::ModelInterfaceSharedPtr model = Parse(text, faults);
  if (!model || !HasAll(*model, tree, faults)) return;
  for (const XMLElement* element : tree.links)
    vehicle.links.push_back(ReadLink(*model->getLink(NameOf(*element)), *element, faults.file()));
  for (const XMLElement* element : tree.joints)
    vehicle.joints.push_back(ReadJoint(*model->getJoint(NameOf(*element)), *element, tree));
}

}  // namespace fourpost
