#pragma once

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"

namespace fourpost {

/// Sensor readings per unit height of each post, sensors x posts, at one frequency [Hz, > 0], dashpots at their mean
/// rates:
///   H = S(iw) (K + iw C - w^2 M)^-1 (K_post + iw C_post) + direct shares of the posts, i = sqrt(-1), w = 2 pi f.
Eigen::MatrixXcd LinearResponse(const CondensedModel& model, double frequency_Hz);

}  // namespace fourpost
