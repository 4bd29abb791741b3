#pragma once

#include <optional>
#include <string_view>

namespace fourpost {

/// How a vehicle's motion is found; the same for steady responses and for time histories.
enum class Engine {
  /// The reduced model, checked by the full one, whose result is used where the two visibly differ.
  kAuto,
  /// Kinematics linearised about static equilibrium, the laws of all elements exact: what a fit uses.
  kReduced,
  /// The full multibody system: by harmonic balance, or over time by FullSystem.
  kFull,
  /// Steady responses only: the full multibody system integrated to steady state, the reference.
  kTimeIntegration,
};

/// "auto", "reduced", "full", "time".
const char* EngineName(Engine engine);

/// The engine of this name; "linearised" and "condensed" are earlier names of the reduced one, "march"
/// of time integration.
std::optional<Engine> EngineNamed(std::string_view name);

/// Differences above these are visible: the repeatability of a rig's gains and phases, and the resolution of a plot.
inline constexpr double kVisible_dB = 0.05;
inline constexpr double kVisible_deg = 0.3;
/// The same of a time history, rms of a channel: 0.05 dB.
inline constexpr double kVisibleShare = 0.006;

}  // namespace fourpost
