#include "tests/vehicles/small_vehicle.h"

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "tests/temporary_folder.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/findings.h"
#include "vehicles/tags/tag_table.h"

namespace fourpost::vehicle_file_test {
namespace {

using ::testing::HasSubstr;
using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

const std::filesystem::path kSource = FOURPOST_SOURCE_DIR;

class VehicleFile : public VehicleFileTest {};

TEST_F(VehicleFile, GivesTheTree) {
  const std::optional<Vehicle> vehicle = Read(kSmallVehicle);
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->name, "small");
  EXPECT_EQ(vehicle->file, folder_ / "vehicle.urdf");
  ASSERT_EQ(vehicle->links.size(), 3U);
  const Link& body = vehicle->links[2];
  EXPECT_EQ(body.ComAt({}), Eigen::Vector3d(0.1, 0, 0.2));
  EXPECT_EQ(body.mass.parameter, 0);
  EXPECT_EQ(body.inertia[1].parameter, 1);
  EXPECT_EQ(body.inertia[1].factor, 2);
  EXPECT_EQ(body.inertia[2].value, 5);
  EXPECT_EQ(body.line, 10);
  ASSERT_EQ(body.visuals.size(), 1U);
  EXPECT_EQ(body.visuals[0].size, Eigen::Vector3d(1, 2, 3));
  ASSERT_EQ(vehicle->joints.size(), 2U);
  EXPECT_EQ(vehicle->joints[0].type, Joint::Type::kPrismatic);
  EXPECT_EQ(vehicle->joints[0].axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(vehicle->joints[1].type, Joint::Type::kRevolute);
  // A quarter turn left: the body's x axis points along the wheel's y axis.
  EXPECT_TRUE((vehicle->joints[1].pose * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(0, 1, 0.5), 1e-15));
}

TEST_F(VehicleFile, GivesTheParameters) {
  const std::optional<Vehicle> vehicle = Read(kSmallVehicle);
  ASSERT_TRUE(vehicle.has_value());
  ASSERT_EQ(vehicle->parameters.size(), 3U);
  const Parameter& mass = vehicle->parameters[0];
  EXPECT_EQ(mass.name, "m_body");
  EXPECT_EQ(mass.upper, 250);
  EXPECT_EQ(mass.precision, 0.1);
  EXPECT_EQ(mass.dimension, kMass);
  EXPECT_EQ(mass.unit, "kg");
  EXPECT_EQ(mass.source, "weighed");
  EXPECT_EQ(mass.line, 31);
  const Parameter& fixed = vehicle->parameters[1];
  EXPECT_EQ(fixed.lower, fixed.value);
  EXPECT_EQ(fixed.upper, fixed.value);
  EXPECT_EQ(fixed.precision, 0);
}

TEST_F(VehicleFile, GivesTheForces) {
  const std::optional<Vehicle> vehicle = Read(kSmallVehicle);
  ASSERT_TRUE(vehicle.has_value());
  ASSERT_EQ(vehicle->springs.size(), 2U);
  const Spring& coil = vehicle->springs[0];
  EXPECT_EQ(coil.law.stiffness.At(vehicle->ParameterValues()), 7500);
  EXPECT_EQ(coil.preload->value, -2000);
  EXPECT_EQ(coil.line.parent.link, 2);
  EXPECT_EQ(coil.line.parent.xyz, Eigen::Vector3d(0.1, 0, 0.4));
  EXPECT_EQ(coil.line.child.link, 1);
  EXPECT_EQ(*coil.line.axis, Eigen::Vector3d::UnitZ());
  EXPECT_FALSE(vehicle->springs[1].preload.has_value());
  EXPECT_FALSE(vehicle->springs[1].line.axis.has_value());
  ASSERT_EQ(vehicle->dampers.size(), 2U);
  EXPECT_EQ(vehicle->dampers[0].law.compression.value, 1000);
  EXPECT_EQ(vehicle->dampers[0].law.rebound.value, 2000);
  EXPECT_EQ(vehicle->dampers[0].series->stiffness.value, 8e5);
  EXPECT_EQ(vehicle->dampers[1].law.compression.value, 10);
  EXPECT_EQ(vehicle->dampers[1].law.rebound.value, 10);
  const Tyre& tyre = vehicle->tyres.at(0);
  EXPECT_EQ(tyre.law.stiffness.value, 2e5);
  EXPECT_EQ(tyre.damping.value, 50);
  EXPECT_EQ(tyre.preload->value, 2000);
  EXPECT_EQ(vehicle->posts.at(0).tyre, 0);
  EXPECT_EQ(vehicle->rods.at(0).parent.link, 2);
  EXPECT_EQ(vehicle->balls.at(0).child.link, 0);
}

TEST_F(VehicleFile, GivesTheSensors) {
  const std::optional<Vehicle> vehicle = Read(kSmallVehicle);
  ASSERT_TRUE(vehicle.has_value());
  ASSERT_EQ(vehicle->sensors.size(), 4U);
  EXPECT_EQ(vehicle->sensors[0].type, Sensor::Type::kAccelerometer);
  EXPECT_EQ(vehicle->sensors[0].axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(vehicle->sensors[1].type, Sensor::Type::kDisplacement);
  EXPECT_EQ(vehicle->sensors[1].axis, Eigen::Vector3d(0, 0.6, 0.8));
  EXPECT_EQ(vehicle->sensors[2].type, Sensor::Type::kStrut);
  EXPECT_EQ(vehicle->sensors[2].line.child.link, 1);
  EXPECT_EQ(vehicle->sensors[3].type, Sensor::Type::kLoadCell);
  EXPECT_EQ(vehicle->sensors[3].tyre, 0);
}

TEST_F(VehicleFile, FillsInDefaults) {
  const std::optional<Vehicle> vehicle = Read(Replaced(kSmallVehicle, " damping=\"50 N*s/m\" preload=\"2 kN\"", ""));
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->tyres.at(0).damping.value, 0);
  EXPECT_FALSE(vehicle->tyres.at(0).preload.has_value());
}

TEST_F(VehicleFile, TellsAllFaultsAtOnce) {
  std::string text = Replaced(kSmallVehicle, "<mass value=\"22\"/>", "<mass value=\"-22\"/>");
  text = Replaced(text, "200 kN/m", "200");
  text = Replaced(text, "under=\"tyre\"", "under=\"tire\"");
  EXPECT_FALSE(Read(text).has_value());
  Expect(6, kNumberNegative);
  Expect(46, kNumberWithoutUnit);
  Expect(47, kReferenceUnknown, {"'tyre'"});
}

TEST_F(VehicleFile, WarnsOncePerForeignPrefix) {
  const std::string foreign = "  <x:lamp colour=\"red\"><x:bulb/></x:lamp>\n  <x:lamp/>\n</robot>";
  EXPECT_TRUE(Read(Replaced(kSmallVehicle, "</robot>", foreign)).has_value());
  Expect(54, kForeignPrefix, {"'x:'"});
}

// Files of earlier versions.
TEST_F(VehicleFile, ReadsAnEarlierSpellingWithAWarning) {
  const std::string text = Replaced(kSmallVehicle, R"(bump="1 kN*s/m")", R"(compression="1 kN*s/m")");
  const std::optional<Vehicle> vehicle = Read(text);
  ASSERT_TRUE(vehicle.has_value());
  EXPECT_EQ(vehicle->dampers.at(0).law.compression.value, 1000);
  Expect(LineOf(text, "compression="), kAttributeFormer, {"'compression'", "fp:damper 'shock'", "'bump'"});
}

TEST_F(VehicleFile, TakesOneSpellingOnly) {
  const std::string text = Replaced(kSmallVehicle, R"(bump="1 kN*s/m")", R"(bump="1 kN*s/m" compression="1 kN*s/m")");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "compression="), kAttributeTwice, {"'compression'", "'bump'"});
}

TEST_F(VehicleFile, GivesTheTextAsItWasRead) { EXPECT_EQ(Read(kSmallVehicle).value().text, kSmallVehicle); }

TEST_F(VehicleFile, ReportsAFileThatIsNotThere) {
  EXPECT_FALSE(ReadVehicle(folder_ / "vehicle.urdf", diagnostics_).has_value());
  Expect(0, kFileNotThere);
}

TEST_F(VehicleFile, ReportsAFolder) {
  std::filesystem::create_directory(folder_ / "vehicle.urdf");
  EXPECT_FALSE(ReadVehicle(folder_ / "vehicle.urdf", diagnostics_).has_value());
  Expect(0, kFileUnreadable);
}

TEST_F(VehicleFile, ReportsAnEmptyFileAsEmpty) {
  EXPECT_FALSE(Read("").has_value());
  Expect(0, kXmlEmpty);
}

TEST_F(VehicleFile, ReportsWhatUrdfdomSaysAndPrintsNothing) {
  CaptureStderr();
  EXPECT_FALSE(Read(Replaced(kSmallVehicle, "<robot ", "<robot version=\"7.0\" ")).has_value());
  EXPECT_EQ(GetCapturedStderr(), "");
  Expect(0, kUrdfdomError);
}

TEST_F(VehicleFile, IsSoundForEveryVehicleOfTheProject) {
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "urdf")) {
    if (entry.path().extension() != ".urdf") continue;
    EXPECT_TRUE(ReadVehicle(entry.path(), diagnostics_).has_value()) << entry.path();
  }
}

TEST_F(VehicleFile, IsSoundForTheWorkedExampleOfTheReadme) {
  const std::string readme = ReadText(kSource / "urdf" / "README.md");
  const std::string begin = "```xml\n";
  const std::size_t at = readme.find(begin) + begin.size();
  EXPECT_TRUE(Read(readme.substr(at, readme.find("```", at) - at)).has_value());
}

TEST(TagTable, IsTheReferenceInTheReadme) {
  const std::string readme = ReadText(kSource / "urdf" / "README.md");
  EXPECT_THAT(readme, HasSubstr("<!-- tags: begin -->\n" + TagReference() + "<!-- tags: end -->\n"));
}

TEST(TagTable, DescribesEveryTagAndAttribute) {
  for (const TagRule& tag : OwnTags()) {
    EXPECT_FALSE(tag.doc.empty()) << tag.path;
    for (const AttributeRule& attribute : tag.attributes)
      EXPECT_FALSE(attribute.doc.empty()) << tag.path << attribute.name;
  }
}

}  // namespace
}  // namespace fourpost::vehicle_file_test
