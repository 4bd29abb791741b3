#include "vehicles/vehicle_lint.h"

#include <array>

#include "vehicles/lint_subject.h"
#include "vehicles/loop_lint.h"
#include "vehicles/motion_lint.h"
#include "vehicles/number_lint.h"
#include "vehicles/parameter_lint.h"
#include "vehicles/place_lint.h"
#include "vehicles/static_lint.h"
#include "vehicles/symmetry_lint.h"

namespace fourpost {
namespace {

constexpr std::array<LintRule, 20> kRules = {
    LintNumbers,       LintHardening,      LintPlacesInMillimetres, LintStopGaps,
    LintOpenClosures,  LintSwappedDamping, LintMirroredPoints,      LintMirroredNumbers,
    LintBarSides,      LintSensorPlaces,   LintTyreHeights,         LintLengths,
    LintPosts,         LintSensors,        LintTyreLoads,           LintSpringLoads,
    LintWeightOnTyres, LintFreeMotions,    LintRingingModes,        LintIdleParameters,
};

}  // namespace

Diagnostics Lint(const Vehicle& vehicle) {
  const LintSubject subject(vehicle);
  Diagnostics findings;
  FileFaults file(vehicle.file, findings);
  file.SetTwins(vehicle.twins);
  for (const LintRule rule : kRules) rule(subject, file);
  return findings;
}

}  // namespace fourpost
