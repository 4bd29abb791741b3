#include "vehicles/chrono/chrono_body.h"

#include "analysis/text/number.h"
#include "vehicles/chrono/findings.h"

namespace fourpost {

KnownBody ChronoBody(const ChronoNode& part, const Eigen::Vector3d& offset, const std::optional<Eigen::Vector3d>& at) {
  KnownBody body;
  if (part.IsNull()) return body;
  body.mass = part.Number("Mass");
  body.com = at ? *at : offset + part.Vector("COM");
  if (part.Has("Moments of Inertia")) {
    body.inertia.diagonal() = part.Vector("Moments of Inertia");
    if (part.Has("Products of Inertia")) {
      const Eigen::Vector3d products = part.Vector("Products of Inertia");
      body.inertia(0, 1) = body.inertia(1, 0) = products.x();
      body.inertia(0, 2) = body.inertia(2, 0) = products.y();
      body.inertia(1, 2) = body.inertia(2, 1) = products.z();
    }
  } else {
    body.inertia.diagonal() = part.Vector("Inertia");
  }
  if (!(body.mass >= 0)) part.ReportAt("Mass", kChronoMass, {part.Called("Mass"), FormatNumber(body.mass) + " kg"});
  if (!(body.inertia.diagonal().minCoeff() >= 0))
    part.Report(kChronoMass, {"a moment of inertia of " + part.Called(),
                              FormatNumber(body.inertia.diagonal().minCoeff()) + " kg*m^2"});
  return body;
}

KnownBody MaybeChronoBody(const ChronoNode& owner, const char* part, const Eigen::Vector3d& offset,
                          const Eigen::Vector3d& at) {
  if (!owner.Has(part)) return {};
  const ChronoNode child = owner.Child(part);
  return child.Has("Mass") ? ChronoBody(child, offset, at) : KnownBody{};
}

KnownBody HalfAt(const KnownBody& rod, const Eigen::Vector3d& end) {
  return {.mass = 0.5 * rod.mass, .com = end, .inertia = Eigen::Matrix3d::Zero()};
}

}  // namespace fourpost
