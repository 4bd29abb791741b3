#include "identify/report/scene_json.h"

#include <complex>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vehicles/shipped_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/linear_response.h"

namespace fourpost::scene_json_test {
namespace {

using Json = nlohmann::ordered_json;

/// Six digits.
constexpr double kPictureDigits = 1e-5;

TEST(SceneJson, LinksMoveAsTheirCoordinatesSay) {
  const Json scene = SceneJson(ShippedVehicle("quarter_car"), {});
  EXPECT_EQ(scene["coordinates"], 2);
  ASSERT_EQ(scene["links"].size(), 3u);
  for (const Json& link : scene["links"]) {
    ASSERT_EQ(link["motion"].size(), 12u);
    // A quarter car moves up and down only.
    for (std::size_t i = 0; i < 12; ++i)
      if (i % 6 != 2) {
        EXPECT_EQ(link["motion"][i], 0) << link["name"];
      }
  }
}

TEST(SceneJson, HasModesAndElements) {
  const Json scene = SceneJson(ShippedVehicle("landrover110_linkage"), {});
  std::vector<std::string> names;
  for (const Json& mode : scene["modes"]) names.push_back(mode["name"]);
  EXPECT_THAT(names, testing::UnorderedElementsAre("heave", "pitch", "front hop", "rear hop"));
  EXPECT_EQ(scene["springs"].size(), 2u);
  EXPECT_EQ(scene["dampers"].size(), 2u);
  EXPECT_EQ(scene["posts"].size(), 2u);
  EXPECT_EQ(scene["sensors"].size(), 13u);
  // Body, and one wheel for four places.
  EXPECT_EQ(scene["meshes"].size(), 2u);
  EXPECT_EQ(scene["missing"].size(), 0u);
}

TEST(SceneJson, AnswersToThePostsAsTheSensorsDo) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  // Without a step in the damper's rate both engines are linear.
  Set(vehicle, "c_rebound", ValueOf(vehicle, "c_bump"));
  const Json scene = SceneJson(vehicle, {.steady = {{.name = "heave", .excitation = {{2.0}, {0.01}, {1.0}}}}});
  const Json& motion = scene["motions"][0];
  EXPECT_EQ(motion["frequency_Hz"][0], 2.0);
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  for (std::size_t link = 1; link < 3; ++link) {
    std::complex<double> rise;
    for (std::size_t j = 0; j < 2; ++j)
      rise += scene["links"][link]["motion"][6 * j + 2].get<double>() *
              std::complex<double>(motion["coordinates"][0][2 * j], motion["coordinates"][0][2 * j + 1]);
    const std::string sensor = scene["links"][link]["name"] == "sprung" ? "z_sprung" : "z_unsprung";
    for (std::size_t s = 0; s < vehicle.sensors.size(); ++s)
      if (vehicle.sensors[s].name == sensor) {
        const std::complex<double> expected = LinearResponse(model, 2.0)(static_cast<Eigen::Index>(s), 0);
        EXPECT_LT(std::abs(rise - expected), kPictureDigits * std::abs(expected)) << sensor;
      }
  }
}

TEST(SceneJson, TellsHistoriesAtFourDigits) {
  Eigen::MatrixXd posts(2, 1);
  posts << 0.012, -0.004;
  Eigen::MatrixXd coordinates(2, 2);
  coordinates << 0.02, 0, -0.0150001, 0;
  const Json scene =
      SceneJson(ShippedVehicle("quarter_car"), {.over_time = {{"sweep", {1.5, 60, posts, coordinates}}}});
  const Json& history = scene["histories"][0];
  EXPECT_EQ(history["name"], "sweep");
  EXPECT_EQ(history["frames"], 2);
  const auto at = [](const Json& column, std::size_t k) {
    return column["unit"].get<double>() * column["steps"][k].get<double>();
  };
  // Half a step of 9999 of the largest.
  EXPECT_NEAR(at(history["posts"][0], 0), 0.012, 0.51e-4 * 0.012);
  EXPECT_NEAR(at(history["posts"][0], 1), -0.004, 0.51e-4 * 0.012);
  EXPECT_NEAR(at(history["coordinates"][0], 1), -0.0150001, 0.51e-4 * 0.02);
  // Of what does not move nothing is left.
  EXPECT_EQ(at(history["coordinates"][1], 0), 0);
}

TEST(SceneJson, RefusesHistoriesOfAnotherVehicle) {
  EXPECT_THAT(
      [] {
        SceneJson(ShippedVehicle("quarter_car"),
                  {.over_time = {{"sweep", {0, 60, Eigen::MatrixXd::Zero(2, 1), Eigen::MatrixXd::Zero(2, 7)}}}});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("7 coordinates and this vehicle 2; fit again")));
}

TEST(SceneJson, NamesMeshesThatCannotBeRead) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  vehicle.links[1].visuals.front().mesh_file = "/nowhere/box.stl";
  const Json scene = SceneJson(vehicle, {});
  ASSERT_EQ(scene["missing"].size(), 1u);
  EXPECT_THAT(scene["missing"][0].get<std::string>(), testing::StartsWith("box.stl: "));
}

}  // namespace
}  // namespace fourpost::scene_json_test
