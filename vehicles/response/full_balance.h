#pragma once

#include <cstddef>
#include <functional>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/full_balance_options.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// Steady response of the full nonlinear multibody system to a stepped sine: unlike SolveHarmonicBalance it sees the
/// pose that damper jacking shifts the vehicle to, products of harmonics, loops that bend the motion, and the sensors'
/// nonlinear kinematics.
///
/// The condensed vehicle moves as the full system does if the forces are added by which the two differ:
///   g(t) = what the condensed vehicle needs to move as s(t) - what Multibody::Residual needs to, along dq/ds.
/// Linear shares of both cancel, and so do most of the kinks of their laws: g is small and smooth, a dozen samples of a
/// cycle tell its harmonics, and some more where it is large. The linearised cycle is solved under g, g found at its
/// solution, and so on with Anderson acceleration, two to eight times. s: the coordinates of Chart about the design
/// pose, which is the static equilibrium.
///
/// Hydraulic dampers remember, and their tension has many harmonics: over a fine grid of the cycle each is stepped
/// through the extension that the linearised one has, with all its harmonics, and the few by which the dozen samples
/// of the full system depart from it.
///
/// `multibody` must carry the parameters and preloads of `model`. Its post motion is removed afterwards.
/// Where the iteration does not converge, leaves what Simbody can evaluate, or closes a chamber of a hydraulic damper,
/// the frequency is reported unconverged and its values are those of SolveHarmonicBalance.
/// `progress` hears how many frequencies are done, and may throw to end the work.
/// Throws std::invalid_argument for options, an excitation or a model that do not fit.
PeriodicResponse SolveFullBalance(Multibody& multibody, const CondensedModel& model, const Excitation& excitation,
                                  const FullBalanceOptions& options = {},
                                  const std::function<void(std::size_t done)>& progress = {});

}  // namespace fourpost
