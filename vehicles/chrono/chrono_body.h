#pragma once

#include "vehicles/chrono/chrono_node.h"
#include "vehicles/templates/axle_knowledge.h"

namespace fourpost {

/// A part: "Mass", "COM" and "Inertia", or "Moments of Inertia" and "Products of Inertia" (xy, xz, yz), all about axes
/// of the vehicle. `at`: its centre of mass where it states none; `offset`: of its subsystem in the vehicle.
KnownBody ChronoBody(const ChronoNode& part, const Eigen::Vector3d& offset,
                     const std::optional<Eigen::Vector3d>& at = std::nullopt);

/// The same where the file may leave its mass out.
KnownBody MaybeChronoBody(const ChronoNode& owner, const char* part, const Eigen::Vector3d& offset,
                          const Eigen::Vector3d& at);

/// A rod's halves, each with half of the mass at one of its ends.
KnownBody HalfAt(const KnownBody& rod, const Eigen::Vector3d& end);

}  // namespace fourpost
