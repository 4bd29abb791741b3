#pragma once

#include "tests/closed_form/quarter_car.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost {

/// The table of thesis section 4.2.
inline QuarterCar ThesisCar() {
  return {.sprung_mass = 200, .unsprung_mass = 22, .stiffness = 15e3, .tyre_stiffness = 230e3, .damper = {1500, 1500}};
}

inline QuarterCar BilinearCar() {
  QuarterCar car = ThesisCar();
  car.damper = {800, 2600};
  return car;
}

inline QuarterCar SeriesCar() {
  QuarterCar car = BilinearCar();
  car.series_stiffness = 150e3;
  return car;
}

/// The same car as a description; the tyre of the equations pulls.
inline Vehicle Describe(const QuarterCar& car) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.tyres[0].lifts_off = false;
  Set(vehicle, "m_sprung", car.sprung_mass);
  Set(vehicle, "m_unsprung", car.unsprung_mass);
  Set(vehicle, "k", car.stiffness);
  Set(vehicle, "kt", car.tyre_stiffness);
  Set(vehicle, "c_bump", -car.damper.Force(-1));
  Set(vehicle, "c_rebound", car.damper.Force(1));
  if (car.series_stiffness > 0) vehicle.dampers[0].series = SpringDescription{.stiffness = {car.series_stiffness}};
  return vehicle;
}

}  // namespace fourpost
