#include "identify/versions.h"

#include <ceres/version.h>
#include <Eigen/Core>

#include "vehicles/multibody/simbody_version.h"

namespace fourpost {

std::vector<std::pair<std::string, std::string>> Versions() {
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
  return {
      {"fourpost", FOURPOST_VERSION}, {"simbody", SimbodyVersion()}, {"ceres", CERES_VERSION_STRING}, {"eigen", eigen}};
}

}  // namespace fourpost
