#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "identify/audit/audit_subject.h"

namespace fourpost {

/// A way in which the wiring of a rig may be wrong.
struct RigFault {
  enum class Kind {
    /// Readings are (1 + value) times too small: true = (1 + value) recorded.
    kScale,
    /// Readings come `value` seconds late.
    kDelay,
    /// A sensor sits `value` metres further along an axis than its file says.
    kPlace,
    /// Load cells feel `value` kilograms more, which move with their posts, than their wheelpans in the file have.
    kWheelpan,
    /// Two channels are exchanged.
    kExchange,
    /// A channel is not what its name says.
    kOther,
  };
  /// What is wrong: sensors and load cells of one or several devices, posts, the weight at rest, or the rig's clock
  /// (frequencies).
  enum class Where { kSensors, kCells, kPosts, kWeight, kClock };

  Kind kind = Kind::kScale;
  Where where = Where::kSensors;
  /// Indices of sensors, tyres (cells) or posts.
  std::vector<std::size_t> members;
  /// Of kPlace: 0 x, 1 y, 2 z.
  int axis = 0;
  /// "a_cg", "all struts"
  std::string name;
  /// Standard deviation of what a good rig is allowed of it.
  double allowed = 0;
};

/// What a good rig may be off by, as standard deviations.
struct RigTolerance {
  /// Of a sensor, and of all sensors of a device together.
  double scale = 0.004;
  double device_scale = 0.002;
  /// [s]
  double delay = 0.2e-3;
  double device_delay = 0.2e-3;
  /// [m]
  double place = 0.007;
  /// Of the weight at rest, beside its own standard deviation.
  double weight = 0.002;
  double frequency = 0.001;
  /// Of a wheelpan [kg], of which the tread of a tyre is a part, and as a share of what the file has.
  double wheelpan = 0.5;
  double wheelpan_share = 0.02;
  /// Of each reading, independent from one frequency to the next: bodies bend, lines are not quite straight. Share of
  /// the reading, and of the loudest of its device.
  double reading = 0.001;
  double floor = 0.0005;
};

/// All that can be wrong with what was recorded.
std::vector<RigFault> PossibleFaults(const AuditSubject& subject, const RigTolerance& tolerance);

/// The records as they would be had the fault of this size not been there.
AuditSubject Corrected(AuditSubject subject, const RigFault& fault, double value);

}  // namespace fourpost
