#pragma once

#include <ostream>
#include <vector>

#include "vehicles/laws/mounted_hydraulic_damper.h"

namespace fourpost {

struct HydraulicSetting {
  const char* name;
  MountedHydraulicDamper damper;
};

inline std::ostream& operator<<(std::ostream& out, const HydraulicSetting& setting) { return out << setting.name; }

/// Stiff and soft oil, oil that boils at decimetres per second, with and without mounts; no friction.
inline std::vector<HydraulicSetting> HydraulicSettings() {
  const HydraulicDamper usual{.friction = 0};
  const HydraulicDamper soft{.rebound_valve_resistance = 3e7, .bulk_modulus = 1e8, .friction = 0};
  const HydraulicDamper boiling{.bleed_resistance = 2e5, .compression_valve_resistance = 3e7, .friction = 0};
  const SpringLaw mount{.stiffness = 400e3, .cubic = 5e12, .knees = {}};
  const SpringLaw soft_mount{.stiffness = 100e3, .cubic = 0, .knees = {}};
  return {{"Usual", {usual, {}}},
          {"Soft", {soft, {}}},
          {"Boiling", {boiling, {}}},
          {"UsualOnAMount", {usual, mount}},
          {"SoftOnASoftMount", {soft, soft_mount}},
          {"BoilingOnAMount", {boiling, mount}}};
}

}  // namespace fourpost
