#include "identify/report/travels_json.h"

#include <string>

#include "analysis/report/picture_number.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Of all wheels; those of other axles keep the height of the design pose.
Eigen::VectorXd RiseOf(const AxleStation& station, const Axle& axle, std::size_t wheels) {
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(wheels));
  for (std::size_t k = 0; k < axle.wheels.size(); ++k)
    rise[static_cast<Eigen::Index>(axle.wheels[k])] = station.wheels[k].rise;
  return rise;
}

/// Each link's place and turn, x y z and a quaternion x y z w.
OrderedJson LinksJson(const Kinematics& pose, std::size_t links) {
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < links; ++i) {
    const Point origin{.link = static_cast<int>(i)};
    const Eigen::Quaterniond turn(pose.Rotation(origin.link));
    Eigen::Matrix<double, 7, 1> place;
    place << pose.Location(origin), turn.coeffs();
    list.push_back(PictureNumbers(place));
  }
  return list;
}

/// A pad stands where its wheel does.
OrderedJson PostsJson(const Vehicle& vehicle, const Eigen::VectorXd& rise) {
  OrderedJson list = OrderedJson::array();
  for (const Post& post : vehicle.posts) list.push_back(PictureNumber(rise[post.tyre]));
  return list;
}

OrderedJson TravelJson(SuspensionRig& rig, const AxleTravel& travel, const Axle& axle) {
  const Vehicle& vehicle = rig.vehicle();
  const auto design = static_cast<std::size_t>(&travel.Design() - travel.stations.data());
  std::vector<OrderedJson> stations(travel.stations.size());
  const auto add = [&](std::size_t i, SuspensionRig::Pose& pose) {
    const AxleStation& station = travel.stations[i];
    const Eigen::VectorXd rise = RiseOf(station, axle, vehicle.tyres.size());
    pose = rig.Move(pose, rise);
    stations[i] = {{"travel", PictureNumber(station.travel)},
                   {"posts", PostsJson(vehicle, rise)},
                   {"links", LinksJson(rig.At(pose), vehicle.links.size())}};
  };
  // From the design pose to either side, each on the way from its neighbour.
  SuspensionRig::Pose pose = rig.Design();
  for (std::size_t i = design; i < travel.stations.size(); ++i) add(i, pose);
  pose = rig.Design();
  for (std::size_t i = design; i-- > 0;) add(i, pose);
  return {{"name", axle.name + ' ' + travel.name}, {"stations", stations}};
}

}  // namespace

OrderedJson TravelsJson(SuspensionRig& rig, const std::vector<AxleKinematics>& axles) {
  OrderedJson list = OrderedJson::array();
  for (const AxleKinematics& kinematics : axles)
    for (const AxleTravel& travel : kinematics.travels)
      list.push_back(TravelJson(rig, travel, rig.suspension().axles[kinematics.axle]));
  return list;
}

}  // namespace fourpost
