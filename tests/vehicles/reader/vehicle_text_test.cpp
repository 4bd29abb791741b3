#include <gmock/gmock.h>

#include "tests/temporary_folder.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/tags/xml_scanner.h"

namespace fourpost::vehicle_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(XmlScanner, FindsAttributesInDocumentOrder) {
  const std::string text =
      "<?xml version='1.0'?><!-- <a x='1'/> --><b y = 'say \"hi\"'\n z=\"2 > 1\"><![CDATA[<c/>]]><d/></b>";
  const std::vector<TagPlaces> tags = ScanTags(text);
  ASSERT_EQ(tags.size(), 2U);
  ASSERT_EQ(tags[0].attributes.size(), 2U);
  const AttributePlace& y = tags[0].attributes[0];
  EXPECT_EQ(y.name, "y");
  EXPECT_EQ(text.substr(y.begin, y.end - y.begin), R"(say "hi")");
  EXPECT_EQ(y.quote, '\'');
  const AttributePlace& z = tags[0].attributes[1];
  EXPECT_EQ(z.name, "z");
  EXPECT_EQ(text.substr(z.begin, z.end - z.begin), "2 > 1");
  EXPECT_TRUE(tags[1].attributes.empty());
  EXPECT_EQ(text.substr(tags[1].name_end - 2, 3), "<d/");
}

class VehicleText : public VehicleFileTest {
 protected:
  /// The text with these values, and the vehicle that it describes.
  std::string Rewrite(const std::string& text, const std::vector<double>& values) {
    const std::optional<Vehicle> vehicle = Read(text);
    const std::string rewritten = VehicleTextWithValues(vehicle.value(), values, folder_);
    const std::optional<Vehicle> again = Read(rewritten);
    EXPECT_EQ(again.value_or(Vehicle()).ParameterValues(), values);
    return rewritten;
  }
};

TEST_F(VehicleText, StaysAsItIsForTheSameValues) { EXPECT_EQ(Rewrite(kSmallVehicle, {200, 2, 15000}), kSmallVehicle); }

TEST_F(VehicleText, ChangesParametersAndWhatIsBoundToThem) {
  std::string expected = Replaced(kSmallVehicle, R"(value="200 kg")", R"(value="180.3 kg")");
  expected = Replaced(expected, R"(<mass value="200"/>)", R"(<mass value="180.3"/>)");
  expected = Replaced(expected, R"(value="2 kg*m^2")", R"(value="2.25 kg*m^2")");
  expected = Replaced(expected, R"(iyy="4")", R"(iyy="4.5")");
  expected = Replaced(expected, R"(value="15 N/mm")", R"(value="12.34 N/mm")");
  EXPECT_EQ(Rewrite(kSmallVehicle, {180.3, 2.25, 12340}), expected);
}

TEST_F(VehicleText, ReadsBackAnyDouble) { Rewrite(kSmallVehicle, {500.0 / 3, 7.0 / 3, 1e5 / 7}); }

TEST_F(VehicleText, KeepsLayoutAndCommentsThatLookAlike) {
  const std::string layout =
      "<!-- <fp:parameter name=\"k\" value=\"15 N/mm\"/> > -->\r\n  <fp:parameter\n    name = 'k'\n\tvalue\n= '15 "
      "N/mm' ";
  const std::string text = Replaced(kSmallVehicle, R"(<fp:parameter name="k" value="15 N/mm" )", layout);
  EXPECT_EQ(Rewrite(text, {200, 2, 16000}), Replaced(text, "= '15 N/mm'", "= '16 N/mm'"));
}

TEST_F(VehicleText, FollowsTheTextNotTheValuesBesideIt) {
  Vehicle vehicle = Read(kSmallVehicle).value();
  vehicle.parameters[2].value = 16000;
  EXPECT_THAT(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder_), HasSubstr(R"(value="16 N/mm")"));
}

TEST_F(VehicleText, TellsWhereAValueComesFrom) {
  Vehicle vehicle = Read(kSmallVehicle).value();
  const std::vector<double> values = vehicle.ParameterValues();
  EXPECT_EQ(VehicleTextWithValues(vehicle, values, folder_), kSmallVehicle);
  vehicle.parameters[2].source = "fitted & checked";
  EXPECT_THAT(VehicleTextWithValues(vehicle, values, folder_), HasSubstr(R"(source="fitted &amp; checked")"));
}

TEST_F(VehicleText, LeavesOutAPriorThatTheVehicleDoesNotHave) {
  const std::string known = Replaced(kSmallVehicle, "value=\"15 N/mm\" ", "value=\"15 N/mm\"\n  prior_sd = '1 N/mm'  ");
  Vehicle vehicle = Read(known).value();
  const std::vector<double> values = vehicle.ParameterValues();
  EXPECT_EQ(VehicleTextWithValues(vehicle, values, folder_), known);
  vehicle.parameters[2].prior_sd.reset();
  EXPECT_EQ(VehicleTextWithValues(vehicle, values, folder_),
            Replaced(kSmallVehicle, "value=\"15 N/mm\" ", "value=\"15 N/mm\"  "));
}

/// The small vehicle with each value written once, in its parameter.
std::string WithReferences() {
  std::string text = Replaced(kSmallVehicle, R"(<mass value="200"/>)", R"(<mass value="$m_body"/>)");
  text = Replaced(text, R"(    <fp:bind to="link[body]/mass"/>)", "");
  text = Replaced(text, R"(iyy="4")", R"(iyy="2*$I_body")");
  return Replaced(text, R"(    <fp:bind to="link[body]/inertia/iyy" factor="2"/>)", "");
}

TEST_F(VehicleText, NumbersOfTheTreeMayNameTheirParameter) {
  const std::string text = WithReferences();
  const Vehicle vehicle = Read(text).value();
  const Vehicle bound = Read(kSmallVehicle).value();
  for (const std::vector<double>& values : {std::vector<double>{200, 2, 15000}, std::vector<double>{180, 2.5, 12000}}) {
    EXPECT_EQ(vehicle.links[2].mass.At(values), bound.links[2].mass.At(values));
    EXPECT_EQ(vehicle.links[2].inertia[1].At(values), bound.links[2].inertia[1].At(values));
  }
  std::string expected = Replaced(text, R"(value="200 kg")", R"(value="180 kg")");
  EXPECT_EQ(Rewrite(text, {180, 2, 15000}), expected);
}

TEST_F(VehicleText, OneNumberOfACentreOfMassMayNameItsParameter) {
  const std::string text = Replaced(
      Replaced(kSmallVehicle, R"(<origin xyz="0.1 0 0.2"/>)", R"(<origin xyz="0.1 0 $h"/>)"),
      "<fp:parameter name=\"k\"", "<fp:parameter name=\"h\" value=\"200 mm\" source=\"x\"/>\n<fp:parameter name=\"k\"");
  const Vehicle vehicle = Read(text).value();
  const std::vector<double> values = {200, 2, 0.3, 15000};
  EXPECT_EQ(vehicle.links[2].ComAt(values), Eigen::Vector3d(0.1, 0, 0.3));
  EXPECT_THAT(Rewrite(text, values), HasSubstr(R"(<origin xyz="0.1 0 $h"/>)"));
}

TEST_F(VehicleText, MovesMeshes) {
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / "quarter_car.urdf";
  const Vehicle vehicle = ReadVehicle(file, diagnostics_).value();
  const std::vector<double> values = vehicle.ParameterValues();
  const std::filesystem::path root = std::filesystem::weakly_canonical(FOURPOST_SOURCE_DIR);
  EXPECT_THAT(VehicleTextWithValues(vehicle, values, root), HasSubstr(R"(filename="meshes/wheel.stl")"));
  EXPECT_THAT(VehicleTextWithValues(vehicle, values, root / "build" / "a & b"),
              HasSubstr(R"(filename="../../meshes/wheel.stl")"));
  EXPECT_EQ(VehicleTextWithValues(vehicle, values, file.parent_path()), ReadText(file));
}

TEST_F(VehicleText, NeedsAValueForEachParameter) {
  const Vehicle vehicle = Read(kSmallVehicle).value();
  EXPECT_THROW(VehicleTextWithValues(vehicle, std::vector<double>{1}, folder_), std::invalid_argument);
}

// A fit takes minutes; its result must not depend on what became of the file meanwhile.
TEST_F(VehicleText, OutlivesItsFile) {
  const Vehicle vehicle = Read(kSmallVehicle).value();
  Write("<robot/>");
  EXPECT_EQ(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder_), kSmallVehicle);
  std::filesystem::remove(vehicle.file);
  EXPECT_EQ(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder_), kSmallVehicle);
}

TEST_F(VehicleText, NeedsAVehicleThatWasRead) {
  EXPECT_THROW(VehicleTextWithValues(Vehicle(), {}, folder_), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::vehicle_text_test
