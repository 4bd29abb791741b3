#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "vehicles/condensed/state_space.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A list of rows.
nlohmann::ordered_json MatrixJson(const Eigen::MatrixXd& matrix);

/// X' = A X + B z, y = C X + D z + D_rate z' + D_acceleration z'', with names and units of z and y.
nlohmann::ordered_json StateSpaceJson(const std::vector<Sensor>& sensors, const std::vector<std::string>& posts,
                                      const StateSpace& space);

}  // namespace fourpost
