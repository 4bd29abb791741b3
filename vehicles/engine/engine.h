#pragma once

#include <optional>
#include <string_view>

namespace fourpost {

/// How a vehicle's motion is found; the same for steady responses and for time histories.
enum class Engine {
  /// The reduced model, checked by the full one, which answers where the two visibly differ.
  kAuto,
  /// Kinematics linearised about static equilibrium, the laws of all elements exact: what a fit uses.
  kReduced,
  /// The full multibody system: by harmonic balance, or over time by FullSystem.
  kFull,
  /// Of steady responses: the full multibody system integrated to steady state, the reference.
  kMarch,
};

/// "auto", "reduced", "full", "march".
const char* EngineName(Engine engine);

/// The engine of this name; "linearised" and "condensed" are older names of the reduced one.
std::optional<Engine> EngineNamed(std::string_view name);

/// From where on what linear kinematics leave out is visible: what a rig's gains and phases repeat within, and what a
/// plot shows.
inline constexpr double kVisible_dB = 0.05;
inline constexpr double kVisible_deg = 0.3;
/// The same of a time history, rms of a channel: 0.05 dB.
inline constexpr double kVisibleShare = 0.006;

}  // namespace fourpost
