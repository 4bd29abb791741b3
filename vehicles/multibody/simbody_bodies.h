#pragma once

#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "vehicles/description/vehicle.h"
#include "vehicles/multibody/simbody.h"

namespace fourpost {

// Conversion of our vectors, links and joints to Simbody's types, and back.

SimTK::Vec3 ToSimbody(const Eigen::Vector3d& v);
SimTK::Transform ToSimbody(const Eigen::Isometry3d& pose);
Eigen::Vector3d ToEigen(const SimTK::Vec3& v);
Eigen::Isometry3d ToEigen(const SimTK::Transform& transform);
Eigen::VectorXd ToEigen(const SimTK::Vector& v);
Eigen::MatrixXd ToEigen(const SimTK::Matrix& m);

/// Mass properties of a link at these parameter values (SI), in its own frame.
SimTK::MassProperties MassPropertiesAt(const Link& link, std::span<const double> parameters);

/// Attaches a body to `parent` by the joint; all coordinates have dq/dt = u.
SimTK::MobilizedBody AddMobilizer(const Joint& joint, SimTK::MobilizedBody& parent, const SimTK::Body& body);

}  // namespace fourpost
