#include "vehicles/condensed/reduced_bytes.h"

#include <cstring>
#include <filesystem>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/vehicles/curved_tyres.h"
#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::reduced_bytes_test {
namespace {

/// All vehicles that lie in the repository.
std::vector<std::filesystem::path> ShippedFiles() {
  std::set<std::filesystem::path> files;
  for (const char* folder : {"urdf", "studies", "examples"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(FOURPOST_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".urdf") files.insert(entry.path());
  return {files.begin(), files.end()};
}

template <typename Matrix>
bool HaveSameBits(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0);
}

void ExpectSameBits(const CondensedModel& a, const CondensedModel& b) {
  EXPECT_TRUE(HaveSameBits(a.mass, b.mass));
  EXPECT_TRUE(HaveSameBits(a.damping, b.damping));
  EXPECT_TRUE(HaveSameBits(a.stiffness, b.stiffness));
  EXPECT_TRUE(HaveSameBits(a.post_stiffness, b.post_stiffness));
  EXPECT_TRUE(HaveSameBits(a.post_damping, b.post_damping));
  EXPECT_TRUE(HaveSameBits(a.actuators, b.actuators));
  EXPECT_TRUE(HaveSameBits(a.on_position, b.on_position));
  EXPECT_TRUE(HaveSameBits(a.on_velocity, b.on_velocity));
  EXPECT_TRUE(HaveSameBits(a.on_acceleration, b.on_acceleration));
  EXPECT_TRUE(HaveSameBits(a.on_post_height, b.on_post_height));
  EXPECT_TRUE(HaveSameBits(a.on_post_velocity, b.on_post_velocity));
  EXPECT_TRUE(HaveSameBits(a.on_post_acceleration, b.on_post_acceleration));
  EXPECT_EQ(a.preloads.spring, b.preloads.spring);
  EXPECT_EQ(a.preloads.tyre, b.preloads.tyre);
  EXPECT_EQ(a.preloads.bushing, b.preloads.bushing);
  ASSERT_EQ(a.dashpots.size(), b.dashpots.size());
  for (std::size_t i = 0; i < a.dashpots.size(); ++i) {
    EXPECT_TRUE(HaveSameBits(a.dashpots[i].direction, b.dashpots[i].direction));
    EXPECT_EQ(a.dashpots[i].law, b.dashpots[i].law);
    EXPECT_EQ(a.dashpots[i].series, b.dashpots[i].series);
  }
  ASSERT_EQ(a.stiffenings.size(), b.stiffenings.size());
  for (std::size_t i = 0; i < a.stiffenings.size(); ++i) {
    EXPECT_TRUE(HaveSameBits(a.stiffenings[i].direction, b.stiffenings[i].direction));
    EXPECT_EQ(a.stiffenings[i].law, b.stiffenings[i].law);
  }
  ASSERT_EQ(a.hydraulics.size(), b.hydraulics.size());
  for (std::size_t i = 0; i < a.hydraulics.size(); ++i) {
    EXPECT_TRUE(HaveSameBits(a.hydraulics[i].direction, b.hydraulics[i].direction));
    EXPECT_EQ(a.hydraulics[i].law, b.hydraulics[i].law);
    EXPECT_EQ(a.hydraulics[i].dashpot, b.hydraulics[i].dashpot);
  }
  ASSERT_EQ(a.liftoffs.size(), b.liftoffs.size());
  for (std::size_t i = 0; i < a.liftoffs.size(); ++i) {
    EXPECT_TRUE(HaveSameBits(a.liftoffs[i].direction, b.liftoffs[i].direction));
    EXPECT_EQ(a.liftoffs[i].post, b.liftoffs[i].post);
    EXPECT_EQ(a.liftoffs[i].preload, b.liftoffs[i].preload);
    EXPECT_EQ(a.liftoffs[i].stiffness, b.liftoffs[i].stiffness);
    EXPECT_EQ(a.liftoffs[i].damping, b.liftoffs[i].damping);
    EXPECT_EQ(a.liftoffs[i].load_cells, b.liftoffs[i].load_cells);
  }
  ASSERT_EQ(a.curved_tyres.size(), b.curved_tyres.size());
  for (std::size_t i = 0; i < a.curved_tyres.size(); ++i) {
    EXPECT_TRUE(HaveSameBits(a.curved_tyres[i].direction, b.curved_tyres[i].direction));
    EXPECT_EQ(a.curved_tyres[i].post, b.curved_tyres[i].post);
    EXPECT_EQ(a.curved_tyres[i].law, b.curved_tyres[i].law);
    EXPECT_EQ(a.curved_tyres[i].damping, b.curved_tyres[i].damping);
    EXPECT_EQ(a.curved_tyres[i].load_cells, b.curved_tyres[i].load_cells);
  }
}

std::vector<double> DrawnValues(const std::vector<Parameter>& parameters, std::mt19937_64& random) {
  std::vector<double> values;
  for (const Parameter& parameter : parameters)
    values.push_back(parameter.lower < parameter.upper
                         ? std::uniform_real_distribution(parameter.lower, parameter.upper)(random)
                         : parameter.value);
  return values;
}

TEST(ReducedBytes, VehicleReadBackHasTheSameModelToTheLastBit) {
  std::mt19937_64 random(1);
  int compared = 0;
  for (const std::filesystem::path& file : ShippedFiles()) {
    SCOPED_TRACE(file);
    Diagnostics diagnostics;
    const std::optional<Vehicle> vehicle = ReadVehicle(file, diagnostics);
    // Dampers on a bench stand on nothing.
    if (!vehicle || Fault(*vehicle).HasErrors()) continue;
    const CondensedVehicle condensed(*vehicle);
    const std::string bytes = BytesOf(condensed.reduced().data());
    const ReducedVehicle back(ReducedDataOf(bytes));
    EXPECT_EQ(BytesOf(back.data()), bytes);
    for (int draw = 0; draw < 5; ++draw) {
      const std::vector<double> values = DrawnValues(vehicle->parameters, random);
      ExpectSameBits(condensed.At(values), back.At(values));
    }
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

TEST(ReducedBytes, VehicleOnTyreCurvesIsReadBack) {
  for (const bool is_measured : {false, true}) {
    Vehicle vehicle = ShippedVehicle("landrover110_model3");
    if (is_measured) MeasureTyres(vehicle);
    else MakeProgressive(vehicle, 5);
    const CondensedVehicle condensed(vehicle);
    const ReducedVehicle back(ReducedDataOf(BytesOf(condensed.reduced().data())));
    const CondensedModel model = back.At(vehicle.ParameterValues());
    EXPECT_EQ(model.curved_tyres.size(), vehicle.tyres.size());
    ExpectSameBits(condensed.At(vehicle.ParameterValues()), model);
  }
}

// Its last matrices have columns and no rows.
TEST(ReducedBytes, VehicleWithoutSensorsIsReadBack) {
  Vehicle vehicle = ShippedVehicle("landrover110_linkage");
  vehicle.sensors.clear();
  const CondensedVehicle condensed(vehicle);
  const std::string bytes = BytesOf(condensed.reduced().data());
  const ReducedVehicle back(ReducedDataOf(bytes));
  EXPECT_EQ(BytesOf(back.data()), bytes);
  ExpectSameBits(condensed.At(vehicle.ParameterValues()), back.At(vehicle.ParameterValues()));
}

TEST(ReducedBytes, KeepNamesUnitsAndBounds) {
  const CondensedVehicle condensed(ShippedVehicle("landrover110_linkage"));
  const ReducedData& data = condensed.reduced().data();
  const ReducedData back = ReducedDataOf(BytesOf(data));
  EXPECT_EQ(back.name, data.name);
  EXPECT_EQ(back.posts, data.posts);
  ASSERT_EQ(back.parameters.size(), data.parameters.size());
  for (std::size_t i = 0; i < data.parameters.size(); ++i) {
    EXPECT_EQ(back.parameters[i].name, data.parameters[i].name);
    EXPECT_EQ(back.parameters[i].value, data.parameters[i].value);
    EXPECT_EQ(back.parameters[i].lower, data.parameters[i].lower);
    EXPECT_EQ(back.parameters[i].upper, data.parameters[i].upper);
    EXPECT_EQ(back.parameters[i].unit, data.parameters[i].unit);
  }
  ASSERT_EQ(back.sensors.size(), data.sensors.size());
  for (std::size_t i = 0; i < data.sensors.size(); ++i) {
    EXPECT_EQ(back.sensors[i].name, data.sensors[i].name);
    EXPECT_EQ(back.sensors[i].type, data.sensors[i].type);
  }
}

TEST(ReducedBytes, OfAnythingElseAreRefused) {
  const std::string bytes = BytesOf(CondensedVehicle(ShippedVehicle("landrover110_linkage")).reduced().data());
  EXPECT_THROW(ReducedDataOf(""), std::invalid_argument);
  EXPECT_THROW(ReducedDataOf("<robot/>"), std::invalid_argument);
  EXPECT_THROW(ReducedDataOf(bytes + "x"), std::invalid_argument);
  // Cut anywhere.
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 50)
    EXPECT_THROW(ReducedDataOf(std::string_view(bytes).substr(0, size)), std::invalid_argument) << size;
}

}  // namespace
}  // namespace fourpost::reduced_bytes_test
