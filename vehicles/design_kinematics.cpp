#include "vehicles/design_kinematics.h"

#include "vehicles/chart.h"

namespace fourpost {

Kinematics DesignKinematics(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  return {multibody, chart.MoveTo(Eigen::VectorXd::Zero(chart.size()))};
}

}  // namespace fourpost
