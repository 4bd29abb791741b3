#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/missing_force/force_record.h"

namespace fourpost {

/// Share of a body's mass by which any reading of a good rig may be off: no mass or part is named that is lighter.
inline constexpr double kLeastShareOfMass = 1e-3;

/// Something that a car may have and its model lacks, whose force follows from the motion up to an amount a:
/// - along lines, tension a e (stiffness, N/m), a e' (damping, N s/m), a tanh(e' / 2 mm/s) (friction, N);
/// - at a link, a mass a [kg] on its centre of mass, or on mounts above a place of it, which answers a vertical
///   motion by a (1 + 2 i z r) / (1 - r^2 + 2 i z r), r = frequency over its natural frequency, z its damping ratio.
struct ForceMechanism {
  enum class Kind { kSpring, kDamper, kFriction, kAddedMass, kPartOnMounts };
  Kind kind = Kind::kSpring;
  /// Of one amount, as indices into ForceRecord::lines; empty of masses.
  std::vector<std::size_t> lines;
  /// Index into ForceRecord::links.
  std::size_t link = 0;
  /// Of a part on mounts: along x from the link's centre of mass [m], natural frequency and damping ratio.
  double place_m = 0;
  double frequency_Hz = 0;
  double damping_ratio = 0;

  /// How many numbers beside the amount are chosen to explain most.
  int ShapeNumbers() const { return kind == Kind::kPartOnMounts ? 3 : 0; }
  /// Whether a car can lack this much of it: what it has too much of is not missing; no mass or part is heavier than
  /// the link that carries it, or lighter than kLeastShareOfMass of it.
  bool Allows(double amount, const ForceRecord& record) const;
};

/// Directions that forces at the mechanism's place have, n x k.
Eigen::MatrixXd ForceDirections(const ForceMechanism& mechanism, const ForceRecord& record);
/// Amplitude along each of these directions, k, per unit amount.
Eigen::VectorXcd ForceAmplitudes(const ForceMechanism& mechanism, const ForceRecord& record, const ForceSample& sample);
/// Force on the n coordinates per unit amount.
Eigen::VectorXcd ForceOf(const ForceMechanism& mechanism, const ForceRecord& record, const ForceSample& sample);

/// All that is tried: each mechanism at each line, at mirror partners alike, and at each link.
std::vector<ForceMechanism> PossibleMechanisms(const ForceRecord& record);

/// As suggestions name it: "friction", "part_on_mounts".
std::string MechanismName(ForceMechanism::Kind kind);
/// "damper 'FL' and damper 'FR'", "link 'chassis'"
std::string PlaceName(const ForceMechanism& mechanism, const ForceRecord& record);
/// Names in the vehicle's file.
std::vector<std::string> ElementNames(const ForceMechanism& mechanism, const ForceRecord& record);

}  // namespace fourpost
