#pragma once

#include <cstddef>
#include <functional>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/full_balance_options.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// Steady response of the full nonlinear multibody system to a stepped sine. Unlike SolveHarmonicBalance it includes
/// the shift of the pose by damper jacking, products of harmonics, the curvature of motion by loops, and the sensors'
/// nonlinear kinematics.
///
/// The reduced vehicle moves like the full system if the difference of their forces is added:
///   g(t) = force that the reduced vehicle needs to move as s(t) - that of the full system, Multibody::Residual along
///   dq/ds.
/// Linear parts of both cancel, and so do most of the kinks of their laws: g is small and smooth. A dozen samples of a
/// cycle give its harmonics; more are taken where it is large. The linearised cycle is solved under g, g is found at
/// its solution, and so on with Anderson acceleration, two to eight times. s: the coordinates of Chart about the design
/// pose, which is the static equilibrium.
///
/// Hydraulic dampers have memory, and their tension has many harmonics. Each is stepped over a fine grid of the cycle
/// through the extension of the linearised solution, with all its harmonics, and the few harmonics by which the samples
/// of the full system differ from it.
///
/// `multibody` must carry the parameters and preloads of `model`. Its post motion is removed afterwards. If the
/// iteration does not converge, leaves the range that Simbody can evaluate, or closes a chamber of a hydraulic damper,
/// the frequency is reported unconverged and its values are those of SolveHarmonicBalance. `progress` is called with
/// the number of frequencies done, and may throw to end the work. Throws std::invalid_argument for options, an
/// excitation or a model that do not fit.
PeriodicResponse SolveFullBalance(Multibody& multibody, const CondensedModel& model, const Excitation& excitation,
                                  const FullBalanceOptions& options = {},
                                  const std::function<void(std::size_t done)>& progress = {});

}  // namespace fourpost
