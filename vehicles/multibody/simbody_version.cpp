#include "vehicles/multibody/simbody_version.h"

#include "vehicles/multibody/simbody.h"

namespace fourpost {

std::string SimbodyVersion() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace fourpost
