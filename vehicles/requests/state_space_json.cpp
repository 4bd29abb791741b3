#include "vehicles/requests/state_space_json.h"

#include "vehicles/response/response_recorder.h"

namespace fourpost {

using Json = nlohmann::ordered_json;

Json MatrixJson(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

Json StateSpaceJson(const std::vector<Sensor>& sensors, const std::vector<std::string>& posts,
                    const StateSpace& space) {
  Json names = Json::array();
  Json units = Json::array();
  for (const Sensor& sensor : sensors) {
    names.push_back(sensor.name);
    units.push_back(UnitOf(sensor.type));
  }
  return {{"inputs", posts},
          {"input_unit", "m"},
          {"outputs", names},
          {"output_units", units},
          {"A", MatrixJson(space.a)},
          {"B", MatrixJson(space.b)},
          {"C", MatrixJson(space.c)},
          {"D", MatrixJson(space.d)},
          {"D_rate", MatrixJson(space.d_rate)},
          {"D_acceleration", MatrixJson(space.d_acceleration)}};
}

}  // namespace fourpost
