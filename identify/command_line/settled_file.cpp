#include "identify/command_line/settled_file.h"

#include <cmath>

#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "identify/suggest/vehicle_edit.h"
#include "vehicles/poses/findings.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

using tinyxml2::XMLElement;

/// Far below the digits of a file [m, rad]: it has not moved.
constexpr double kUnchanged = 1e-9;

std::string Numbers(const Eigen::Vector3d& vector) {
  const auto number = [](double value) { return FormatNumber(std::abs(value) < 1e-15 ? 0 : value); };
  return number(vector.x()) + ' ' + number(vector.y()) + ' ' + number(vector.z());
}

/// URDF's roll, pitch and yaw: about x, then y, then z of the parent.
Eigen::Vector3d RollPitchYaw(const Eigen::Matrix3d& turn) {
  return {std::atan2(turn(2, 1), turn(2, 2)), std::atan2(-turn(2, 0), std::hypot(turn(2, 1), turn(2, 2))),
          std::atan2(turn(1, 0), turn(0, 0))};
}

/// Seen in the plane y = 0 as a mirror.
Eigen::Isometry3d MirrorImage(const Eigen::Isometry3d& pose) {
  const Eigen::DiagonalMatrix<double, 3> mirror(1, -1, 1);
  Eigen::Isometry3d image = Eigen::Isometry3d::Identity();
  image.linear() = mirror * pose.linear() * mirror;
  image.translation() = mirror * pose.translation();
  return image;
}

bool AreEqual(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < kUnchanged;
}

class SettledFile {
 public:
  SettledFile(const Vehicle& vehicle, const SettledPose& pose, const std::filesystem::path& folder,
              Diagnostics& findings)
      : vehicle_(vehicle),
        pose_(pose),
        findings_(findings),
        text_(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder)),
        edit_(text_) {}

  std::string AtRest(StatedForces stated) {
    stated_ = stated;
    for (const Joint& joint : vehicle_.joints) Move(joint);
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i)
      if (!pose_.springs[i].is_held) Change(vehicle_.springs[i], pose_.springs[i]);
    for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i)
      if (!pose_.tyres[i].is_held && IsMoved(pose_.tyres[i]))
        SetForce(edit_.Find("fp:tyre", vehicle_.tyres[i].name), "preload", pose_.tyres[i].force, pose_.tyres[i],
                 vehicle_.tyres[i].source_line);
    for (const Damper& damper : vehicle_.dampers)
      if (damper.hydraulic &&
          std::abs(Length(damper.line, pose_.rest) - Length(damper.line, pose_.design)) > kUnchanged)
        Refuse("fp:damper '" + damper.name + "'", Length(damper.line, pose_.rest) - Length(damper.line, pose_.design),
               damper.source_line);
    for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i)
      if (pose_.bushings[i] > kUnchanged)
        Refuse("fp:bushing '" + vehicle_.bushings[i].name + "'", pose_.bushings[i], vehicle_.bushings[i].source_line);
    for (std::size_t i = 0; i < vehicle_.antiroll_bars.size(); ++i)
      if (std::abs(pose_.antiroll_bars[i]) > kUnchanged)
        Refuse("fp:antiroll '" + vehicle_.antiroll_bars[i].name + "'", pose_.antiroll_bars[i],
               vehicle_.antiroll_bars[i].source_line);
    return edit_.Text();
  }

  std::string Held(Holding holding) {
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
      const Spring& spring = vehicle_.springs[i];
      const SettledPose::Strut& strut = pose_.springs[i];
      const XMLElement* const element = edit_.Find("fp:spring", spring.name);
      if (spring.kind != Spring::Kind::kCoil || strut.is_held || !element) continue;
      const XMLElement* const law = element->FirstChildElement();
      const bool by_length = holding == Holding::kFreeLength;
      const std::optional<double>& value = by_length ? strut.holding_length : strut.holding_force;
      if (!law || !value) {
        findings_.Report(kDesignPoseNotHeld, {vehicle_.file, spring.source_line}, {strut.element});
        continue;
      }
      const char* const said = AttributeText(*law, "free_length") ? "free_length" : "preload";
      const char* const wanted = by_length ? "free_length" : "preload";
      if (std::string(said) == wanted) edit_.Set(*law, wanted, FormatQuantity(*value, by_length ? "m" : "N"));
      else edit_.Exchange(*law, said, wanted, FormatQuantity(*value, by_length ? "m" : "N"));
    }
    return edit_.Text();
  }

 private:
  static bool IsMoved(const SettledPose::Strut& strut) {
    return std::abs(strut.length - strut.design_length) > kUnchanged;
  }

  void Refuse(const std::string& element, double change, int line) {
    findings_.Report(kLawCountsFromDesign, {vehicle_.file, line},
                     {element, FormatQuantity(std::round(change * 1e6) * 1e-6, "mm")});
  }
  void Refuse(const SettledPose::Strut& strut, int line) {
    Refuse(strut.element, strut.length - strut.design_length, line);
  }

  static double Length(const ForceLine& line, const std::vector<Eigen::Isometry3d>& poses) {
    const auto place = [&](const Point& point) { return poses[static_cast<std::size_t>(point.link)] * point.xyz; };
    const Eigen::Vector3d span = place(line.parent) - place(line.child);
    if (!line.axis) return span.norm();
    return (poses[static_cast<std::size_t>(line.parent.link)].linear() * *line.axis).dot(span);
  }

  Eigen::Isometry3d Relative(const Joint& joint, const std::vector<Eigen::Isometry3d>& poses) const {
    return poses[static_cast<std::size_t>(joint.parent)].inverse() * poses[static_cast<std::size_t>(joint.child)];
  }

  void Move(const Joint& joint) {
    const Eigen::Isometry3d rest = Relative(joint, pose_.rest);
    if (const auto twin = vehicle_.twins.find(joint.name); twin != vehicle_.twins.end()) {
      for (const Joint& written : vehicle_.joints)
        if (written.name == twin->second && !AreEqual(MirrorImage(Relative(written, pose_.rest)), rest))
          findings_.Report(kSettledUnevenly, {vehicle_.file, joint.line}, {"joint '" + written.name + "'"});
      return;
    }
    const XMLElement* const element = edit_.Find("joint", joint.name);
    if (!element || AreEqual(rest, joint.pose)) return;
    const std::string xyz = Numbers(rest.translation());
    const std::string rpy = Numbers(RollPitchYaw(rest.linear()));
    if (const XMLElement* const origin = element->FirstChildElement("origin")) {
      edit_.Set(*origin, "xyz", xyz);
      edit_.Set(*origin, "rpy", rpy);
    } else {
      edit_.AddChild(*element, "<origin xyz=\"" + xyz + "\" rpy=\"" + rpy + "\"/>");
    }
  }

  /// One that follows a parameter cannot.
  void SetForce(const XMLElement* element, const char* attribute, double force, const SettledPose::Strut& strut,
                int line) {
    if (!element) return;
    if (AttributeText(*element, attribute).value_or("").find('$') != std::string::npos) return Refuse(strut, line);
    edit_.Set(*element, attribute, FormatQuantity(force, "N"));
  }

  void Change(const Spring& spring, const SettledPose::Strut& strut) {
    if (spring.kind == Spring::Kind::kCoil && stated_ == StatedForces::kLeftToEquilibrium) Leave(spring);
    if (!IsMoved(strut)) return;
    const XMLElement* const element = edit_.Find(spring.kind == Spring::Kind::kCoil   ? "fp:spring"
                                                 : spring.kind == Spring::Kind::kStop ? "fp:stop"
                                                                                      : "fp:damper",
                                                 spring.name);
    // A mirror partner follows the one that is written.
    if (!element) return;
    switch (spring.kind) {
      case Spring::Kind::kCoil:
        if (!MovesAlong(spring)) return Refuse(strut, spring.source_line);
        if (!spring.law.table.empty()) MovePlace(*element->FirstChildElement(), spring, strut);
        if (spring.preload && stated_ == StatedForces::kKept)
          SetForce(element->FirstChildElement(), "preload", strut.force, strut, spring.source_line);
        return;
      case Spring::Kind::kStop:
        MoveGap(element->FirstChildElement("bump"), strut.length - strut.design_length, strut, spring.source_line);
        MoveGap(element->FirstChildElement("rebound"), strut.design_length - strut.length, strut, spring.source_line);
        return;
      case Spring::Kind::kGas:
        SetForce(element->FirstChildElement("gas"), "force", -strut.force, strut, spring.source_line);
    }
  }

  /// A table counts from its own zero, other bent laws from the design pose.
  static bool MovesAlong(const Spring& spring) { return spring.law.IsLinear() || !spring.law.table.empty(); }

  /// The place on its table at which a spring stands at rest, where the file does not follow it from a free length.
  void MovePlace(const XMLElement& table, const Spring& spring, const SettledPose::Strut& strut) {
    const std::optional<std::string> at = AttributeText(table, "at");
    if (!at && spring.law.is_placed) return;
    const double place = spring.law.place.value + strut.length - strut.design_length;
    const std::vector<double> values = vehicle_.ParameterValues();
    const bool is_on_table =
        spring.law.table.front().extension.At(values) <= place && place <= spring.law.table.back().extension.At(values);
    if (spring.law.place.parameter >= 0 || !is_on_table) return Refuse(strut, spring.source_line);
    edit_.Set(table, "at", FormatQuantity(place, "m"));
  }

  void Leave(const Spring& spring) {
    const XMLElement* const element = edit_.Find("fp:spring", spring.name);
    if (element && element->FirstChildElement())
      edit_.Exchange(*element->FirstChildElement(), spring.preload ? "preload" : "free_length", "preload",
                     "equilibrium");
  }

  void MoveGap(const XMLElement* stop, double more, const SettledPose::Strut& strut, int line) {
    if (!stop) return;
    const std::optional<Quantity> gap = ParseQuantity(AttributeText(*stop, "gap").value_or(""));
    if (!gap || gap->si + more < 0) return Refuse(strut, line);
    edit_.Set(*stop, "gap", FormatQuantity(gap->si + more, "m"));
  }

  const Vehicle& vehicle_;
  const SettledPose& pose_;
  Diagnostics& findings_;
  StatedForces stated_ = StatedForces::kKept;
  std::string text_;
  VehicleEdit edit_;
};

}  // namespace

std::string SettledText(const Vehicle& vehicle, const SettledPose& pose, StatedForces stated,
                        const std::filesystem::path& folder, Diagnostics& findings) {
  return SettledFile(vehicle, pose, folder, findings).AtRest(stated);
}

std::string HeldText(const Vehicle& vehicle, const SettledPose& pose, Holding holding,
                     const std::filesystem::path& folder, Diagnostics& findings) {
  return SettledFile(vehicle, pose, folder, findings).Held(holding);
}

}  // namespace fourpost
