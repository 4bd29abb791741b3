#include "vehicles/lint/lint_subject.h"

#include "vehicles/description/gravity.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/mode_names.h"
#include "vehicles/ride/suspension.h"
#include "vehicles/ride/wheel_travel.h"

namespace fourpost {

LintSubject::LintSubject(const Vehicle& described)
    : vehicle(described),
      values(described.ParameterValues()),
      condensed(described),
      model(condensed.At(values)),
      modes(ModesOf(model)),
      links(condensed.LinkMotions(values)),
      pose(DesignKinematics(described)) {
  const Suspension suspension = SuspensionOf(vehicle, pose, values);
  const HeldChassis held(suspension, StiffnessWithoutTyres(vehicle, pose, values, model));
  NameModes(vehicle, pose, suspension, held, modes);
}

double LintSubject::Weight() const {
  double mass = 0;
  for (const LinkMotion& link : links)
    if (!link.com_jacobian.isZero(0) || !link.spin_jacobian.isZero(0)) mass += link.mass;
  return kGravity * mass;
}

}  // namespace fourpost
