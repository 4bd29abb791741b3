#include "vehicles/description/added_mass.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/design_poses.h"

namespace fourpost::added_mass_test {
namespace {

const Link& LinkCalled(const Vehicle& vehicle, const std::string& name) {
  for (const Link& link : vehicle.links)
    if (link.name == name) return link;
  throw std::invalid_argument(name);
}

// By hand: two point masses, one of them the body.
TEST(AddedMass, MovesTheCentreOfMassAndAddsInertia) {
  const Vehicle vehicle = ShippedVehicle("landrover110_model1");
  const std::vector<double> values = vehicle.ParameterValues();
  const Link& body = LinkCalled(vehicle, "chassis");
  const double own = body.mass.At(values);
  const Eigen::Vector3d com = PlaceOf(
      {.link = static_cast<int>(&body - vehicle.links.data()), .xyz = body.ComAt(values)}, DesignPoses(vehicle));
  const Vehicle loaded = WithMass(vehicle, values, 250, com + Eigen::Vector3d(-1, 0, 0));
  const Link& heavier = LinkCalled(loaded, "chassis");
  EXPECT_DOUBLE_EQ(heavier.mass.At(values), own + 250);
  EXPECT_NEAR(heavier.ComAt(values).x(), body.ComAt(values).x() - 250 / (own + 250), 1e-12);               // rounding
  EXPECT_NEAR(heavier.inertia[1].At(values), body.inertia[1].At(values) + own * 250 / (own + 250), 1e-9);  // rounding
  EXPECT_NEAR(heavier.inertia[0].At(values), body.inertia[0].At(values), 1e-9);
}

TEST(AddedMass, RestsOnTheTyres) {
  const Vehicle vehicle = ShippedVehicle("landrover110");
  const std::vector<double> values = vehicle.ParameterValues();
  const auto weight = [&](const Vehicle& v) {
    double sum = 0;
    for (const double load : CondensedVehicle(v).PreloadsAt(values).tyre) sum += load;
    return sum;
  };
  const double before = weight(vehicle);
  const double after = weight(WithMass(vehicle, values, 100, {-1.4, 0.2, 1}));
  EXPECT_NEAR(after - before, 100 * 9.80665, 1e-6 * before);  // what equilibrium is solved to
}

TEST(AddedMass, RefusesNoMass) {
  const Vehicle vehicle = ShippedVehicle("quarter_car");
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(WithMass(vehicle, vehicle.ParameterValues(), bad, {0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::added_mass_test
