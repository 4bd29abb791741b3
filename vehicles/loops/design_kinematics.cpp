#include "vehicles/loops/design_kinematics.h"

#include "vehicles/loops/chart.h"

namespace fourpost {

Kinematics DesignKinematics(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  return {multibody, chart.MoveTo(Eigen::VectorXd::Zero(chart.size()))};
}

}  // namespace fourpost
