#include "identify/command_line/locked_friction.h"

#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/command_line/findings.h"

namespace fourpost {

void WarnOfLocked(const Vehicle& vehicle, const std::vector<LockedFriction>& locked, const std::string& motion,
                  Diagnostics& findings) {
  for (const LockedFriction& lock : locked) {
    const Damper& damper = vehicle.dampers[lock.damper];
    const std::string place = lock.frequency_Hz > 0 ? ", near " + Rounded(lock.frequency_Hz, 2) + " Hz" : "";
    if (const auto sticking = damper.law.StickingAt(vehicle.ParameterValues())) {
      findings.Report(kFrictionSticks, {vehicle.file, damper.source_line},
                      {damper.name, motion, FormatQuantity(sticking->stiffness, "kN/m"),
                       Rounded(lock.friction_N, 3) + " N", Rounded(lock.factor, 2), place});
      continue;
    }
    findings.Report(kFrictionHolds, {vehicle.file, damper.source_line},
                    {damper.name, motion, Rounded(lock.friction_N, 3) + " N", Rounded(lock.factor, 2), place});
  }
}

}  // namespace fourpost
