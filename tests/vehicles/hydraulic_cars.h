#pragma once

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Columns of 150 mm, else the defaults of a file.
inline HydraulicDescription Oil(double bleed, double rebound_valve, double compression_valve,
                                double bulk_modulus = 300e6) {
  return {.bleed = {bleed},
          .rebound_valve = {rebound_valve},
          .compression_valve = {compression_valve},
          .bulk_modulus = {bulk_modulus},
          .piston_diameter = {0.030},
          .rod_diameter = {0.0125},
          .rebound_column = {0.15},
          .compression_column = {0.15},
          .gas_pressure = {2e6},
          .gas_volume = {60e-6},
          .gas_exponent = {1.3},
          .density = {860},
          .cavitation = {5e3}};
}

/// Of an axle's both sides in one: bore 45 mm.
inline HydraulicDescription AxleOil(double bleed, double rebound_valve, double compression_valve) {
  HydraulicDescription oil = Oil(bleed, rebound_valve, compression_valve);
  oil.piston_diameter = {0.045};
  oil.gas_volume = {200e-6};
  return oil;
}

/// The quarter car on this damper.
inline Vehicle QuarterCarOnOil(const HydraulicDescription& oil, double mount = 0) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.dampers[0].law = {};
  vehicle.dampers[0].hydraulic = oil;
  if (mount > 0) vehicle.dampers[0].series = SpringDescription{.stiffness = {mount}};
  return vehicle;
}

/// The linkage car on hydraulic dampers.
inline Vehicle LinkageCarOnOil() {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  for (Damper& damper : vehicle.dampers) damper.law = {};
  vehicle.dampers[0].hydraulic = AxleOil(3e-6, 4e6, 2e6);
  vehicle.dampers[1].hydraulic = AxleOil(4e-6, 5e6, 2e6);
  return vehicle;
}

/// The same with a mount and friction in front; behind the shipped damper on a mount. States of the multibody: the
/// extension of the rear's mount, then the front's pressures. Of the condensed model: first what stands for the front's
/// oil.
inline Vehicle LinkageCarOnMixedDampers() {
  Vehicle vehicle = LinkageCarOnOil();
  vehicle.dampers[0].series = SpringDescription{.stiffness = {800e3}};
  vehicle.dampers[0].law.friction = DashpotDescription::Friction{{40}, {0.02}};
  vehicle.dampers[1] = ShippedVehicle("landrover110_linkage").dampers[1];
  vehicle.dampers[1].series = SpringDescription{.stiffness = {500e3}, .cubic = {1e11}};
  return vehicle;
}

}  // namespace fourpost
