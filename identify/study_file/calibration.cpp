#include "identify/study_file/calibration.h"

namespace fourpost {

std::string Calibration::Name() const {
  const char* const kinds[] = {"gain", "delay", "offset"};
  return std::string(kinds[static_cast<int>(kind)]) + " of " + of;
}

std::string Calibration::Unit() const {
  const char* const units[] = {"1", "s", "N"};
  return units[static_cast<int>(kind)];
}

}  // namespace fourpost
