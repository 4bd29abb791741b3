#pragma once

namespace fourpost {

// Amplitudes of the posts of any rig for vehicles: least of what a servo-hydraulic post resolves, most of its stroke.
constexpr double kLeastAmplitude_m = 0.1e-3;
constexpr double kMostAmplitude_m = 0.25;
/// Amplitudes of some mm that are taken for some um; between this and the least it may be a very gentle test.
constexpr double kSurelyNoAmplitude_m = 0.02e-3;

}  // namespace fourpost
