#include "vehicles/lint/vehicle_lint.h"

#include <array>

#include "vehicles/description/drawn_vehicle.h"
#include "vehicles/lint/lint_subject.h"
#include "vehicles/lint/loop_lint.h"
#include "vehicles/lint/motion_lint.h"
#include "vehicles/lint/number_lint.h"
#include "vehicles/lint/parameter_lint.h"
#include "vehicles/lint/place_lint.h"
#include "vehicles/lint/static_lint.h"
#include "vehicles/lint/symmetry_lint.h"
#include "vehicles/lint/table_lint.h"

namespace fourpost {
namespace {

/// A plausibility check that needs only the description, so that it also works on a vehicle that cannot be assembled or
/// held: adds a warning, with a remedy, for each finding.
using DrawnLintRule = void (*)(const DrawnVehicle& drawn, FileFaults& findings);

constexpr std::array<DrawnLintRule, 18> kDrawnRules = {
    LintNumbers,  LintMeanRates,    LintHardening,      LintPlacesInMillimetres, LintStopGaps,
    LintGaps,     LintOilColumns,   LintSwappedDamping, LintMirroredPoints,      LintMirroredNumbers,
    LintBarSides, LintSensorPlaces, LintInertias,       LintTyreHeights,         LintLengths,
    LintPosts,    LintSensors,      LintDamperTables,
};

constexpr std::array<LintRule, 10> kRules = {
    LintOpenClosures, LintTyreLoads,    LintSpringLoads,    LintWeightOnTyres, LintFreeMotions,
    LintRingingModes, LintBlindSensors, LintIdleParameters, LintSpringTables,  LintTyreTables,
};

template <typename Subject, typename Rules>
Diagnostics Findings(const Vehicle& vehicle, const Rules& rules) {
  const Subject subject(vehicle);
  Diagnostics findings;
  FileFaults file(vehicle.file, findings);
  file.SetTwins(vehicle.twins);
  for (const auto rule : rules) rule(subject, file);
  return findings;
}

}  // namespace

Diagnostics LintDescription(const Vehicle& vehicle) { return Findings<DrawnVehicle>(vehicle, kDrawnRules); }

Diagnostics LintAssembled(const Vehicle& vehicle) { return Findings<LintSubject>(vehicle, kRules); }

}  // namespace fourpost
