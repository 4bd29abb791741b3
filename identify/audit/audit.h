#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/audit/audit_subject.h"
#include "identify/audit/rig_fault.h"

namespace fourpost {

/// How well the records of a rig would show a fault.
struct Resolution {
  RigFault fault;
  /// Standard deviation of an estimate of its size, what a good rig may be off by included; infinite where redundancy
  /// shows nothing of it, or less than what no reading would leave room for: all of a reading, a period of the lowest
  /// frequency.
  double sd = 0;
  /// The size that is certainly seen, kSuspicious standard deviations.
  double Seen() const;
};

/// A fault that explains what the records of a rig leave over.
struct Suspicion {
  RigFault fault;
  /// Estimated size and its standard deviation without what a good rig may be off by; 0 of an exchange.
  double size = 0;
  double sd = 0;
  /// Of kWheelpan the mean of the masses that the vehicle's file has [kg].
  double wheelpan_kg = 0;
  /// Fall of the sum of squares, over its mean when nothing is wrong: the square of a normal variable then.
  double score = 0;
  /// Faults that would explain it as well, with their sizes.
  struct Rival {
    RigFault fault;
    double size = 0;
    double score = 0;
  };
  std::vector<Rival> rivals;
  /// Best score of all that are no rivals.
  double next_score = 0;
};

/// What one channel leaves over of the motion and the forces that all of them agree on.
struct ChannelRest {
  std::string name;
  bool is_force = false;
  std::string run;
  /// Root mean squares over frequencies, as shares of the reading's; `expected` by its standard deviations.
  double share = 0;
  double expected = 0;
};

struct Audit {
  std::vector<ChannelRest> channels;
  std::vector<Suspicion> suspicions;
  std::vector<Resolution> resolutions;
  /// Root mean square of all that is left over, once suspicions are corrected, over its standard deviation; about 1 for
  /// a rigid car whose noise is known.
  double misfit = 0;
  /// In all recordings; elsewhere a misfit above 1 is no contradiction.
  bool is_noise_known = true;
  /// Whether any reading can be checked by others: a fault of one is seen, or suspected.
  bool is_redundant = false;
};

/// Whether redundancy clears these channels: nothing is suspected, and of each a scale that is off by a tenth and a
/// delay of 5 ms would have been, a few degrees where bodies resonate, far less than what errors beyond the model need.
bool ClearsChannels(const Audit& audit, const std::vector<std::string>& channels);

/// Standard deviations beyond which a fault is suspected. Of 200 to 400 possible faults in good records one is by
/// chance that far off in one audit of some 3000 when all that a good rig may be off by is normal.
inline constexpr double kSuspicious = 4.5;

/// The mass that moves with the post of this load cell beside its file's wheelpan, as suspicions say [kg]; null where
/// they or resolutions say nothing of it as small as `least_kg`.
struct FoundWheelpan {
  double kg = 0;
  double sd = 0;
};
std::optional<FoundWheelpan> WheelpanBy(const Audit& audit, const std::string& cell, double least_kg);

/// Looks for faults of a rig in its records without fitting the car, see AuditEquations. What a good rig may be off by
/// (`tolerance`) counts as noise that all readings of a channel share, so that a fault counts by how far it is beyond
/// that; all noise is widened by `misfit` where that is above 1. The fault that explains most is taken out, and the
/// search goes on, at most four times. Where channels contradict each other then, wheelpans are sought that resolve it.
Audit AuditRig(const AuditSubject& subject, const RigTolerance& tolerance = {});

}  // namespace fourpost
