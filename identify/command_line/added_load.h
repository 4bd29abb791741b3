#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A load on the body of a vehicle, and what the posts carry at rest.
struct AddedLoad {
  struct OnPost {
    std::string post;
    double without_N = 0;
    double with_N = 0;
  };

  double mass_kg = 0;
  /// In the ground, in the design pose.
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
  std::string body;
  std::vector<OnPost> posts;
};

/// Puts a load such as "250 kg" at a place such as "-1.2,0,0.9" (metres) or "-1200 mm,0,90 cm" on the vehicle, at the
/// values of its file. Warns on stderr of a place that the vehicle's body cannot lean or pitch to, such as one beside
/// the plane of a planar car. Throws FaultyInput about "--add-mass" and "--at": for what is no mass or place, a place
/// far outside the car, and a load under which a post would have to pull.
AddedLoad AddLoad(const std::string& mass, const std::string& place, Vehicle& vehicle);

/// Lines for the terminal.
std::string AddedLoadText(const AddedLoad& load);

nlohmann::ordered_json AddedLoadJson(const AddedLoad& load);

}  // namespace fourpost
