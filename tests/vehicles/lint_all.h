#pragma once

#include "vehicles/lint/vehicle_lint.h"

namespace fourpost {

/// What `fourpost check` finds odd about a vehicle that reads.
inline Diagnostics Lint(const Vehicle& vehicle) {
  Diagnostics findings = LintDescription(vehicle);
  const Diagnostics more = LintAssembled(vehicle);
  for (const Diagnostic& item : more.items()) findings.Add(item);
  return findings;
}

}  // namespace fourpost
