#pragma once

#include "analysis/text/finding.h"

// What is wrong with a damper's recording on a bench.
namespace fourpost {

inline const Finding kForceDead{"force-dead", Severity::kError,
                                "force is {} throughout, whatever the motion, so the channel is dead",
                                "check its plug and its amplifier"};
inline const Finding kForceDeadInCycle{
    "force-dead-in-cycle", Severity::kError,
    "force stays within {} in the cycle that begins at {}, which has {} of the speed of another cycle of {}, so the "
    "channel is dead there",
    "check its plug, and save what lies before and behind as separate recordings"};
inline const Finding kCycleIncomplete{"cycle-incomplete", Severity::kError,
                                      "less than one cycle, displacement turns back {} within {}",
                                      "record at least one cycle, better ten"};
inline const Finding kChannelsSwapped{
    "channels-swapped", Severity::kError,
    "displacement spans {} and force {}, and their product is negative work, so the two columns look swapped",
    "exchange their names, and the units with them"};
inline const Finding kStrokeTooLong{"stroke-too-long", Severity::kError,
                                    "displacement spans {}, more than the damper's length of {}, and looks like mm",
                                    "correct the row of units"};
inline const Finding kStrokeTooShort{"stroke-too-short", Severity::kWarning,
                                     "displacement spans only {}, less than any bench is set to",
                                     "check the row of units"};
inline const Finding kBenchUnitsTooLarge{
    "bench-units-too-large", Severity::kError,
    "force is {} rms for a motion of {} rms, for which the damper would give {} at the values of the vehicle file, so "
    "displacement looks like mm stated as m, or force like kN stated as N",
    "correct the row of units, or values in the vehicle file that are off by a thousand"};
inline const Finding kBenchUnitsTooSmall{
    "bench-units-too-small", Severity::kError,
    "force is {} rms for a motion of {} rms, for which the damper would give {} at the values of the vehicle file, so "
    "displacement looks like m stated as mm, or force like N stated as kN",
    "correct the row of units, or values in the vehicle file that are off by a thousand"};
inline const Finding kSampledSlowly{"sampled-slowly", Severity::kWarning,
                                    "motion at {} and more is sampled at {}, {} samples a cycle, which leaves its "
                                    "speed between the samples unknown",
                                    "record at least ten samples a cycle"};
inline const Finding kDisplacementJumps{
    "displacement-jumps", Severity::kError,
    "displacement jumps by {} from one sample to the next at {}{}, as where samples are missing and the times were "
    "closed up",
    "save what lies before and behind as separate recordings"};
inline const Finding kForceUnrelated{"force-unrelated", Severity::kWarning,
                                     "only {} of the force goes with displacement or speed, the rest is noise or the "
                                     "channel is another one",
                                     "check plugs and names"};
inline const Finding kForceSign{"force-sign", Severity::kError,
                                "force acts along the motion, the damper would give off {}",
                                "change the sign of force or of displacement; extension and tension are positive"};
inline const Finding kSidesSwapped{"sides-swapped", Severity::kWarning,
                                   "bump resists harder than rebound, by a factor of {} in work, which few dampers do",
                                   "if both signs are changed, correct them; extension and tension are positive"};
inline const Finding kForceAhead{
    "force-ahead", Severity::kWarning,
    "force comes {} before the speed at {}, its phase against displacement is {}, outside the 0 to 90 degrees of "
    "everything that stores and dissipates",
    "record both channels with one device and one filter, and subtract the inertia of what is between damper and load "
    "cell"};
inline const Finding kForceLate{
    "force-late", Severity::kWarning,
    "force comes {} after the speed at {}, its phase against displacement is {}, outside the 0 to 90 degrees of "
    "everything that stores and dissipates",
    "record both channels with one device and one filter; state a known delay as 'force: {channel: NAME, delay: ...}'; "
    "a damper's own spring is part of this one"};
inline const Finding kSpike{"spike", Severity::kWarning, "{} has a sample that stands out, at {} with {}",
                            "check plugs and cables, put the mean of the neighbours there, or fit with "
                            "'refine: {loss: huber}'"};
inline const Finding kSpikes{"spikes", Severity::kWarning, "{} has {} samples that stand out, the first at {} with {}",
                             "check plugs and cables, put the mean of the neighbours there, or fit with "
                             "'refine: {loss: huber}'"};
inline const Finding kClipped{"clipped", Severity::kError, "{} is clipped, {}",
                              "record with a wider range, or save the whole cycles between such stretches as separate "
                              "recordings"};
inline const Finding kLooksClipped{"looks-clipped", Severity::kWarning, "{} looks clipped, {}",
                                   "record with a wider range, or save the whole cycles between such stretches as "
                                   "separate recordings"};
inline const Finding kDisplacementCoarse{"displacement-coarse", Severity::kWarning,
                                         "displacement has a resolution of {}, which is {} of the speed's rms",
                                         "record with a finer range, or at a lower sampling rate"};
inline const Finding kForceCoarse{"force-coarse", Severity::kWarning, "force has a resolution of {} in a span of {}",
                                  "record with a finer range"};
inline const Finding kSignalDrifts{"signal-drifts", Severity::kWarning,
                                   "{} drifts by {} from begin to end, of a span of {}",
                                   "warm up the amplifier and the damper, or write 'trend: remove' at its channel"};
inline const Finding kForcePushes{
    "force-offset-bump", Severity::kWarning,
    "force is {} in the mean of its turning points, where the damper is at rest, of a span of {}, and the vehicle file "
    "has no gas or spring that makes it",
    "subtract the load cell's offset, or give the damper '<gas force=...>' with a parameter to fit"};
inline const Finding kForcePulls{
    "force-offset-rebound", Severity::kWarning,
    "force is {} in the mean of its turning points, where the damper is at rest, of a span of {}, and the vehicle file "
    "has no gas or spring that makes it",
    "subtract the load cell's offset; gas would push, and this pulls"};
inline const Finding kDisplacementOffset{
    "displacement-offset", Severity::kWarning,
    "displacement is about {}, of a span of {}, where the elements of the vehicle file act differently from mid-stroke",
    "subtract the sensor's offset, or check that the recording is of such a place"};

}  // namespace fourpost
