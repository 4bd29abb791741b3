#include "identify/report/scene_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "analysis/report/picture_number.h"
#include "identify/experiments/fit_balance.h"
#include "identify/report/coordinate_sensors.h"
#include "identify/report/measured_motion.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/engine/engine.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/ride/named_modes.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/shapes/mesh.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Meshes above this make a page that nobody wants to open.
constexpr Eigen::Index kMostTriangles = 60000;

OrderedJson PoseJson(const Eigen::Vector3d& place, const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond turn(rotation);
  return {{"place", PictureNumbers(place)}, {"turn", PictureNumbers(turn.coeffs())}};
}

/// Meshes that several visuals share are listed once.
class MeshList {
 public:
  /// Index of the file; -1 where it cannot be shown.
  int Add(const std::string& file) {
    const auto known = std::find(files_.begin(), files_.end(), file);
    if (known != files_.end()) return indices_[static_cast<std::size_t>(known - files_.begin())];
    files_.push_back(file);
    indices_.push_back(Read(file));
    return indices_.back();
  }

  const OrderedJson& meshes() const { return meshes_; }
  const OrderedJson& missing() const { return missing_; }

 private:
  int Read(const std::string& file) {
    const std::string name = std::filesystem::path(file).filename().string();
    try {
      const Mesh mesh = ReadMesh(file);
      if (mesh.triangles.cols() > kMostTriangles)
        throw std::runtime_error(std::to_string(mesh.triangles.cols()) + " triangles; up to " +
                                 std::to_string(kMostTriangles) + " are shown");
      meshes_.push_back({{"vertices", PictureNumbers(mesh.vertices)}, {"triangles", PictureNumbers(mesh.triangles)}});
      return static_cast<int>(meshes_.size()) - 1;
    } catch (const std::runtime_error& fault) {
      missing_.push_back(name + ": " + fault.what());
      return -1;
    }
  }

  std::vector<std::string> files_;
  std::vector<int> indices_;
  OrderedJson meshes_ = OrderedJson::array();
  OrderedJson missing_ = OrderedJson::array();
};

OrderedJson ShapesOf(const Link& link, MeshList& meshes) {
  constexpr std::array<const char*, 4> kShapes = {"mesh", "box", "cylinder", "sphere"};
  OrderedJson shapes = OrderedJson::array();
  for (const Visual& visual : link.visuals) {
    OrderedJson shape = PoseJson(visual.pose.translation(), visual.pose.linear());
    shape["kind"] = kShapes[static_cast<std::size_t>(visual.shape)];
    shape["size"] = PictureNumbers(visual.size);
    if (visual.shape == Visual::Shape::kMesh) {
      const int mesh = meshes.Add(visual.mesh_file);
      if (mesh < 0) continue;
      shape["mesh"] = mesh;
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

/// `motion`: 6 x n column by column, velocity of the link's origin above its angular velocity, ground axes.
OrderedJson LinksJson(const Vehicle& vehicle, const Kinematics& pose, const std::vector<double>& values,
                      MeshList& meshes) {
  OrderedJson links = OrderedJson::array();
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const Link& link = vehicle.links[i];
    const Point origin{.link = static_cast<int>(i)};
    const Eigen::MatrixXd linear = pose.PointJacobian(origin);
    Eigen::MatrixXd motion(6, linear.cols());
    motion << linear, pose.AngularJacobian(origin.link);
    OrderedJson json = PoseJson(pose.Location(origin), pose.Rotation(origin.link));
    json["name"] = link.name;
    json["mass"] = PictureNumber(link.mass.At(values));
    json["com"] = PictureNumbers(link.ComAt(values));
    json["motion"] = PictureNumbers(motion);
    json["shapes"] = ShapesOf(link, meshes);
    links.push_back(std::move(json));
  }
  return links;
}

OrderedJson PointJson(const Point& point) { return {{"link", point.link}, {"xyz", PictureNumbers(point.xyz)}}; }

OrderedJson LineJson(const std::string& name, const Point& parent, const Point& child) {
  return {{"name", name}, {"ends", {PointJson(parent), PointJson(child)}}};
}

template <typename Element>
OrderedJson LinesJson(const std::vector<Element>& elements) {
  OrderedJson list = OrderedJson::array();
  for (const Element& element : elements) {
    if constexpr (requires { element.line; })
      list.push_back(LineJson(element.name, element.line.parent, element.line.child));
    else list.push_back(LineJson(element.name, element.parent, element.child));
  }
  return list;
}

OrderedJson SpringsJson(const Vehicle& vehicle) {
  constexpr std::array<const char*, 3> kKinds = {"coil", "stop", "gas"};
  OrderedJson list = OrderedJson::array();
  for (const Spring& spring : vehicle.springs) {
    list.push_back(LineJson(spring.name, spring.line.parent, spring.line.child));
    list.back()["kind"] = kKinds[static_cast<std::size_t>(spring.kind)];
  }
  return list;
}

OrderedJson BarsJson(const Vehicle& vehicle) {
  OrderedJson list = OrderedJson::array();
  for (const AntiRollBar& bar : vehicle.antiroll_bars) {
    list.push_back(LineJson(bar.name, bar.left.parent, bar.right.parent));
    list.back()["drops"] = {LineJson(bar.name, bar.left.parent, bar.left.child),
                            LineJson(bar.name, bar.right.parent, bar.right.child)};
  }
  return list;
}

/// `load`: at rest.
OrderedJson TyresJson(const Vehicle& vehicle, const CondensedModel& model) {
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i) {
    const Tyre& tyre = vehicle.tyres[i];
    list.push_back({{"name", tyre.name},
                    {"point", PointJson(tyre.point)},
                    {"radius", tyre.radius},
                    {"load", PictureNumber(model.preloads.tyre[i])}});
  }
  return list;
}

OrderedJson PostsJson(const Vehicle& vehicle) {
  OrderedJson list = OrderedJson::array();
  for (const Post& post : vehicle.posts) list.push_back({{"name", post.name}, {"tyre", post.tyre}});
  return list;
}

OrderedJson SensorsJson(const Vehicle& vehicle) {
  constexpr std::array<const char*, 5> kTypes = {"accelerometer", "displacement", "strut", "load cell", "gyro"};
  OrderedJson list = OrderedJson::array();
  for (const Sensor& sensor : vehicle.sensors) {
    OrderedJson json = {{"name", sensor.name}, {"type", kTypes[static_cast<std::size_t>(sensor.type)]}};
    if (sensor.type == Sensor::Type::kLoadCell) json["tyre"] = sensor.tyre;
    else if (sensor.type == Sensor::Type::kStrut) json["point"] = PointJson(sensor.line.parent);
    else {
      json["point"] = PointJson(sensor.point);
      json["axis"] = PictureNumbers(sensor.axis);
    }
    list.push_back(std::move(json));
  }
  return list;
}

template <typename Complex>
OrderedJson ComplexJson(const Complex& values) {
  OrderedJson list = OrderedJson::array();
  for (const std::complex<double>& value : values) {
    list.push_back(PictureNumber(value.real()));
    list.push_back(PictureNumber(value.imag()));
  }
  return list;
}

OrderedJson ModesJson(const Vehicle& vehicle, const Kinematics& pose, const CondensedModel& model,
                      const std::vector<double>& values) {
  OrderedJson list = OrderedJson::array();
  const Suspension suspension = SuspensionOf(vehicle, pose, values);
  for (const Mode& mode : NamedModes(vehicle, pose, suspension, model, values)) {
    OrderedJson energy = OrderedJson::array();
    for (const MotionShare& share : mode.energy)
      energy.push_back({{"motion", share.motion}, {"share", PictureNumber(share.share)}});
    list.push_back({{"name", mode.name},
                    {"kind", KindName(mode.kind)},
                    {"frequency_Hz", PictureNumber(mode.frequency_Hz)},
                    {"damping_ratio", PictureNumber(mode.damping_ratio)},
                    {"poles", ComplexJson(PolesOf(mode))},
                    {"shape", ComplexJson(mode.shape)},
                    {"energy", energy}});
  }
  return list;
}

/// A row per frequency.
OrderedJson RowsJson(const Eigen::MatrixXcd& rows) {
  OrderedJson list = OrderedJson::array();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::VectorXcd row = rows.row(i).transpose();
    list.push_back(ComplexJson(std::vector<std::complex<double>>(row.begin(), row.end())));
  }
  return list;
}

OrderedJson MotionsJson(const Vehicle& vehicle, const CondensedModel& model,
                        const std::vector<RecordedMotion>& motions) {
  OrderedJson list = OrderedJson::array();
  const std::vector<Sensor> coordinates = CoordinateSensors(model);
  const CondensedModel seen = WithCoordinatesAsSensors(model);
  for (const RecordedMotion& motion : motions) {
    const FrequencyResponse response = SolveHarmonicBalance(seen, coordinates, motion.excitation, kFitBalance).response;
    Eigen::MatrixXcd answers(static_cast<Eigen::Index>(response.frequency_Hz.size()), model.mass.rows());
    for (Eigen::Index j = 0; j < answers.cols(); ++j)
      for (Eigen::Index i = 0; i < answers.rows(); ++i)
        answers(i, j) = response.channels[static_cast<std::size_t>(j)].response[static_cast<std::size_t>(i)];
    list.push_back({{"name", motion.name},
                    {"engine", EngineName(Engine::kReduced)},
                    {"frequency_Hz", motion.excitation.frequency_Hz},
                    {"amplitude_m", motion.excitation.amplitude_m},
                    {"posts", motion.excitation.shape},
                    {"coordinates", RowsJson(answers)}});
    if (const Eigen::MatrixXcd measured = MeasuredMotion(vehicle, model, motion, answers); measured.rows() > 0)
      list.back()["measured"] = RowsJson(measured);
  }
  return list;
}

/// Columns as whole numbers of a unit of their own: a picture needs no more than four digits of the largest.
OrderedJson ColumnsJson(const Eigen::MatrixXd& columns) {
  constexpr double kDigits = 9999;
  OrderedJson list = OrderedJson::array();
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const double unit = columns.col(j).cwiseAbs().maxCoeff() / kDigits;
    OrderedJson steps = OrderedJson::array();
    for (const double value : columns.col(j)) steps.push_back(unit > 0 ? std::lround(value / unit) : 0);
    list.push_back({{"unit", PictureNumber(unit)}, {"steps", std::move(steps)}});
  }
  return list;
}

OrderedJson HistoriesJson(const CondensedModel& model, const std::vector<RecordedHistory>& histories) {
  OrderedJson list = OrderedJson::array();
  for (const auto& [name, motion] : histories) {
    if (motion.coordinates.cols() != model.mass.rows())
      throw std::invalid_argument("the motion of '" + name + "' has " + std::to_string(motion.coordinates.cols()) +
                                  " coordinates and this vehicle " + std::to_string(model.mass.rows()) + "; fit again");
    list.push_back({{"name", name},
                    {"start_s", PictureNumber(motion.start_s)},
                    {"rate_Hz", PictureNumber(motion.rate_Hz)},
                    {"frames", motion.posts.rows()},
                    {"posts", ColumnsJson(motion.posts)},
                    {"coordinates", ColumnsJson(motion.coordinates)}});
  }
  return list;
}

}  // namespace

OrderedJson SceneJson(const Vehicle& vehicle, const RecordedMotions& motions) {
  const std::vector<double> values = vehicle.ParameterValues();
  const CondensedModel model = CondensedVehicle(vehicle).At(values);
  const Kinematics pose = DesignKinematics(vehicle);
  MeshList meshes;
  OrderedJson links = LinksJson(vehicle, pose, values, meshes);
  return {{"name", vehicle.name},
          {"coordinates", model.mass.rows()},
          {"links", std::move(links)},
          {"meshes", meshes.meshes()},
          {"missing", meshes.missing()},
          {"springs", SpringsJson(vehicle)},
          {"dampers", LinesJson(vehicle.dampers)},
          {"bushings", LinesJson(vehicle.bushings)},
          {"rods", LinesJson(vehicle.rods)},
          {"bars", BarsJson(vehicle)},
          {"tyres", TyresJson(vehicle, model)},
          {"posts", PostsJson(vehicle)},
          {"sensors", SensorsJson(vehicle)},
          {"modes", ModesJson(vehicle, pose, model, values)},
          {"motions", MotionsJson(vehicle, model, motions.steady)},
          {"histories", HistoriesJson(model, motions.over_time)}};
}

}  // namespace fourpost
