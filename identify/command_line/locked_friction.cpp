#include "identify/command_line/locked_friction.h"

#include "analysis/text/text_table.h"

namespace fourpost {

void WarnOfLocked(const Vehicle& vehicle, const std::vector<LockedFriction>& locked, const std::string& motion,
                  Diagnostics& findings) {
  for (const LockedFriction& lock : locked) {
    const Damper& damper = vehicle.dampers[lock.damper];
    const std::string place = lock.frequency_Hz > 0 ? ", near " + Rounded(lock.frequency_Hz, 2) + " Hz" : "";
    findings.Warning(vehicle.file, damper.source_line,
                     "fp:damper '" + damper.name + "' never slides in " + motion + ": its friction of " +
                         Rounded(lock.friction_N, 3) + " N holds, and its rates count for nothing; it takes about " +
                         Rounded(lock.factor, 2) + " times the motion" + place);
  }
}

}  // namespace fourpost
