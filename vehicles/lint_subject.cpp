#include "vehicles/lint_subject.h"

#include "vehicles/gravity.h"
#include "vehicles/multibody.h"

namespace fourpost {
namespace {

Kinematics DesignPose(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  multibody.SetPose(multibody.design_pose());
  const int n = multibody.coordinate_count();
  return {multibody, Eigen::MatrixXd::Identity(n, n)};
}

}  // namespace

LintSubject::LintSubject(const Vehicle& described)
    : vehicle(described),
      values(described.ParameterValues()),
      condensed(described),
      model(condensed.At(values)),
      modes(ModesOf(model)),
      links(condensed.LinkMotions(values)),
      pose(DesignPose(described)) {}

double LintSubject::Weight() const {
  double mass = 0;
  for (const CondensedVehicle::LinkMotion& link : links)
    if (!link.com_jacobian.isZero(0) || !link.spin_jacobian.isZero(0)) mass += link.mass;
  return kGravity * mass;
}

}  // namespace fourpost
