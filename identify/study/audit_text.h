#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "identify/audit/audit.h"

namespace fourpost {

/// "x", "y", "z"
const char* AxisName(int axis);

/// Size of a fault as a user counts it: recorded over true less one, seconds, metres, kilograms.
double CountedSize(const RigFault& fault, double size);

/// What each channel leaves over, and from which size on a fault of it would be seen.
std::string AuditText(const Audit& audit);

/// `audit` of result.json and of `fourpost info STUDY`.
nlohmann::ordered_json AuditJson(const Audit& audit);

}  // namespace fourpost
