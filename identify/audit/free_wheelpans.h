#pragma once

#include <cstddef>
#include <vector>

#include "identify/audit/audit_subject.h"

namespace fourpost {

/// Tyres whose load cells were recorded and whose wheelpans no parameter sets.
std::vector<std::size_t> StatedWheelpans(const AuditSubject& subject);

/// With the wheelpans of these tyres as unknown parameters, at the end of AuditedCar::reach in their order: kilograms
/// beside what the file has, each known to `reach_kg`.
AuditSubject WithFreeWheelpans(AuditSubject subject, const std::vector<std::size_t>& tyres, double reach_kg);

}  // namespace fourpost
