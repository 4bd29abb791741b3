#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/reader/urdf_tree.h"
#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"

namespace fourpost {

/// URDF's roll, pitch, yaw: turns about the fixed x, y and z axes, in this order.
Eigen::Matrix3d TurnOf(const Eigen::Vector3d& rpy);

/// Reads the points of elements, the ends that name a frame or a link, and the lines between them.
class LineReader {
 public:
  /// Reads the file's frames, whose shifts may be parameters.
  LineReader(const tinyxml2::XMLElement& robot, const UrdfTree& tree, ParameterReader& parameters, FileFaults& faults);

  /// From the attributes `link` and `xyz`.
  Point ReadPoint(const Tag& tag) const;
  /// The link that the attribute `link` names; -1 after an error.
  int ReadLink(const Tag& tag) const;
  /// From `parent` and `child`, which must be on two links; `on_one`: the finding about a line on one.
  std::pair<Point, Point> ReadEnds(const Tag& tag, const Finding& on_one) const;
  /// From `parent`, `child` and `axis`.
  ForceLine ReadLine(const Tag& tag) const;
  /// The attribute `axis` as a unit vector; nothing when there is none.
  static std::optional<Eigen::Vector3d> ReadAxis(const Tag& tag);
  /// Axes of the frame that `parent` names, in its link; those of the link when it names one.
  Eigen::Matrix3d ReadAxes(const Tag& tag) const;

  /// Reports an unknown name.
  void Unknown(const Tag& tag, std::string_view attribute, const std::string& kind,
               const std::vector<std::string>& legal) const;

 private:
  struct Frame {
    Point point;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  };

  void ReadFrame(const Tag& tag, ParameterReader& parameters);
  /// Legal names of an end.
  std::vector<std::string> EndNames() const;
  Point ReadEnd(const Tag& tag, std::string_view attribute) const;

  const UrdfTree& tree_;
  FileFaults& faults_;
  /// See LostNames: references to them are not reported.
  std::set<std::string, std::less<>> lost_names_;
  std::map<std::string, Frame> frames_;
};

}  // namespace fourpost
