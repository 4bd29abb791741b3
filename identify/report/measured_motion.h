#pragma once

#include <Eigen/Core>

#include "identify/experiments/recorded_motion.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// The motion that sensors saw, as coordinates of the model: at each frequency those of the model, and the least change
/// of them that explains best by what the readings of accelerometers, gyros and displacements differ. What no sensor
/// sees is as modelled. `modelled`, and the result: frequencies x n, per metre of the reference post. Empty where no
/// sensor of the motion was measured.
Eigen::MatrixXcd MeasuredMotion(const Vehicle& vehicle, const CondensedModel& model, const RecordedMotion& motion,
                                const Eigen::MatrixXcd& modelled);

}  // namespace fourpost
