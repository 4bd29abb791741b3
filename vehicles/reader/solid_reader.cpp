#include "vehicles/reader/solid_reader.h"

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "vehicles/reader/findings.h"
#include "vehicles/shapes/mesh.h"
#include "vehicles/shapes/shape_error.h"
#include "vehicles/shapes/solid.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

std::string ShapeName(const Visual& visual) {
  switch (visual.shape) {
    case Visual::Shape::kMesh: return "mesh '" + visual.mesh_file + "'";
    case Visual::Shape::kBox: return "box";
    case Visual::Shape::kCylinder: return "cylinder";
    case Visual::Shape::kSphere: return "sphere";
  }
  return "";
}

/// A number per unit density, times the density.
Scalar TimesDensity(double number, const Scalar& density, std::span<const double> parameters) {
  Scalar product{.value = number * density.value, .parameter = density.parameter, .factor = number * density.factor};
  // As a fit computes it, to the last digit.
  product.value = product.At(parameters);
  return product;
}

void SetMass(const Solid& solid, const Scalar& density, std::span<const double> parameters, Link& link) {
  const Eigen::Matrix3d inertia = solid.Inertia();
  const std::array<double, 6> numbers = {inertia(0, 0), inertia(1, 1), inertia(2, 2),
                                         inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  for (Eigen::Index i = 0; i < 3; ++i) link.com[static_cast<std::size_t>(i)].value = solid.com[i];
  link.mass = TimesDensity(solid.volume, density, parameters);
  for (std::size_t i = 0; i < numbers.size(); ++i) link.inertia[i] = TimesDensity(numbers[i], density, parameters);
}

class SolidReader {
 public:
  SolidReader(const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle, FileFaults& faults)
      : tree_(tree), parameters_(parameters), vehicle_(vehicle), faults_(faults) {}

  /// False when the link has not got its mass.
  bool Read(const Tag& tag) {
    const int errors = faults_.errors();
    const Scalar density = parameters_.ReadScalar(tag, "density");
    const int index = ReadLink(tag);
    if (faults_.errors() > errors || index < 0 || vehicle_.links.empty()) return false;
    Link& link = vehicle_.links[static_cast<std::size_t>(index)];
    const std::optional<Solid> solid = SolidOf(link, tag);
    if (solid) SetMass(*solid, density, vehicle_.ParameterValues(), link);
    return solid.has_value();
  }

 private:
  /// `words` follow the tag and its link.
  void Fault(const Finding& kind, const Tag& tag, std::vector<std::string> words = {}) {
    words.insert(words.begin(), {Describe(*tag.element), tag.Text("link")});
    faults_.Report(kind, tag.Line("link"), words);
  }

  void Fault(const ShapeError& error, const Visual& visual, const Tag& tag) {
    faults_.Report(error.About(ShapeName(visual) + " of link '" + tag.Text("link") + "'"), tag.Line("link"));
  }

  /// Position of the link, with a fault where it takes no mass from its shapes.
  int ReadLink(const Tag& tag) {
    const std::string name = tag.Text("link");
    const int index = tree_.FindLink(name);
    if (index < 0) {
      if (!name.empty()) Fault(kSolidLink, tag, {tree_.LinkMeant(name, faults_)});
      return index;
    }
    const XMLElement& link = *tree_.links[static_cast<std::size_t>(index)];
    const auto [first, is_new] = lines_.try_emplace(index, tag.Line());
    if (!is_new) Fault(kSolidTwice, tag, {std::to_string(first->second)});
    if (index == 0) Fault(kSolidGround, tag);
    else if (link.FirstChildElement("inertial")) Fault(kSolidInertial, tag);
    else if (!link.FirstChildElement("visual")) Fault(kSolidNoVisual, tag);
    return index;
  }

  /// All visual shapes together; nothing after a fault.
  std::optional<Solid> SolidOf(const Link& link, const Tag& tag) {
    Solid sum;
    for (const Visual& visual : link.visuals) {
      const std::optional<Solid> solid = SolidOf(visual, tag);
      if (!solid) return std::nullopt;
      sum = sum + *solid;
    }
    return sum;
  }

  std::optional<Solid> SolidOf(const Visual& visual, const Tag& tag) {
    try {
      if (visual.shape == Visual::Shape::kMesh) Load(visual.mesh_file);
      return ShapeSolid(visual);
    } catch (const ShapeError& error) {
      Fault(error, visual, tag);
      return std::nullopt;
    }
  }

  /// In link axes.
  Solid ShapeSolid(const Visual& visual) const {
    const Eigen::Affine3d pose(visual.pose);
    switch (visual.shape) {
      case Visual::Shape::kMesh:
        return Mapped(MeshSolid(meshes_.at(visual.mesh_file)), pose * Eigen::Scaling(visual.size));
      case Visual::Shape::kBox: return Mapped(BoxSolid(visual.size), pose);
      case Visual::Shape::kCylinder: return Mapped(CylinderSolid(visual.size.x(), visual.size.z()), pose);
      case Visual::Shape::kSphere: return Mapped(SphereSolid(visual.size.x()), pose);
    }
    throw std::logic_error("shape without a solid");
  }

  /// Reads a mesh file unless it is known.
  void Load(const std::string& file) {
    if (!meshes_.contains(file)) meshes_.emplace(file, ReadMesh(file));
  }

  const UrdfTree& tree_;
  ParameterReader& parameters_;
  Vehicle& vehicle_;
  FileFaults& faults_;
  /// Line of the tag of each link.
  std::map<int, int> lines_;
  std::map<std::string, Mesh> meshes_;
};

}  // namespace

bool ReadSolids(const XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, Vehicle& vehicle,
                FileFaults& faults) {
  SolidReader reader(tree, parameters, vehicle, faults);
  bool is_complete = true;
  for (const Tag& tag : TagsOf(robot, "fp:solid"))
    if (!reader.Read(tag)) is_complete = false;
  return is_complete;
}

}  // namespace fourpost
