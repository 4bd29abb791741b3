#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/suggest/addition_source.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::body_additions_test {
namespace {

std::vector<Addition> PartsOf(const Vehicle& vehicle) {
  std::vector<Addition> additions;
  AddBodyAdditions(AdditionSource(vehicle, vehicle.ParameterValues()), additions);
  return additions;
}

Vehicle Read(const std::string& file) {
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicle(std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / file, findings);
  EXPECT_TRUE(vehicle) << findings.Format();
  return *vehicle;
}

double CentreOf(const Vehicle& vehicle) {
  double mass = 0;
  double moment = 0;
  for (const Joint& joint : vehicle.joints) {
    const std::string& name = vehicle.links[static_cast<std::size_t>(joint.child)].name;
    if (!name.starts_with("chassis") && !name.starts_with("part")) continue;
    const Link& link = vehicle.links[static_cast<std::size_t>(joint.child)];
    const double own = link.mass.At(vehicle.ParameterValues());
    const double x = link.ComAt(vehicle.ParameterValues()).x();
    mass += own;
    moment += own * (x + (name == "chassis" ? 0 : joint.pose.translation().x()));
  }
  return moment / mass;
}

/// Else the part would shift the loads of the axles, which contradict it.
TEST(BodyAdditions, KeepTheCentreOfMassOfBodyAndPart) {
  const Vehicle before = Read("landrover110_model1.urdf");
  const std::vector<Addition> parts = PartsOf(before);
  ASSERT_EQ(parts.size(), 12u);
  for (const Addition& one : parts) {
    Diagnostics findings;
    std::optional<Vehicle> with = ReadVehicleText(one.vehicle, before.file, findings);
    ASSERT_TRUE(with) << findings.Format();
    for (const double share : {0.05, 0.2}) {
      const std::vector<double> values = one.values(share);
      ASSERT_EQ(values.size(), one.parameters.size());
      for (Parameter& parameter : with->parameters) {
        for (std::size_t i = 0; i < values.size(); ++i)
          if (parameter.name == one.parameters[i]) parameter.value = values[i];
        // The body's own mass follows, as in a fit.
        if (parameter.name == "m_sprung") parameter.value = (1 - share) * 1725;
      }
      // Rounding.
      EXPECT_NEAR(CentreOf(*with), CentreOf(before), 1e-9) << one.words << " " << share;
    }
  }
}

/// The first part names the body's centre, and its mounts hang on the body as a coil does.
TEST(BodyAdditions, OfAFurtherPartHaveItsOwnPlace) {
  const Vehicle before = Read("landrover110_model1.urdf");
  Diagnostics findings;
  const std::vector<Addition> first = PartsOf(before);
  const std::optional<Vehicle> with_one = ReadVehicleText(first.back().vehicle, before.file, findings);
  ASSERT_TRUE(with_one) << findings.Format();
  const std::vector<Addition> second = PartsOf(*with_one);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t k = 0; k < second.size(); ++k) {
    const Addition& one = second[k];
    EXPECT_EQ(one.words.rfind("second part of 'chassis'", 0), 0u) << one.words;
    EXPECT_EQ(one.Key(), first[k].Key());
    const std::vector<std::string> names = {"m_part_chassis_2", "k_part_chassis_2", "c_part_chassis_2",
                                            "x_part_chassis_2"};
    EXPECT_EQ(one.parameters, names);
    EXPECT_EQ(one.count, 4);
    const std::optional<Vehicle> with_two = ReadVehicleText(one.vehicle, before.file, findings);
    ASSERT_TRUE(with_two) << findings.Format();
    const Joint& joint = with_two->joints.back();
    const Link& part = with_two->links[static_cast<std::size_t>(joint.child)];
    EXPECT_EQ(part.name, "part2_chassis");
    EXPECT_EQ(part.com[0].parameter, static_cast<int>(with_two->parameters.size()) - 1);
    // Where the axles' springs stand, as of the first.
    EXPECT_EQ(joint.pose.translation().x(), k < second.size() / 2 ? 1.456 : -1.338);
  }
}

TEST(BodyAdditions, OfABodyThatDoesNotPitchHaveNoPlaceToFollow) {
  for (const Addition& one : PartsOf(Read("quarter_car.urdf"))) EXPECT_EQ(one.parameters.size(), 3u);
}

}  // namespace
}  // namespace fourpost::body_additions_test
