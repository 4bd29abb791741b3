#include "vehicles/shapes/solid.h"

#include <gmock/gmock.h>

#include "tests/rounding.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/reader/findings.h"
#include "vehicles/shapes/findings.h"
#include "vehicles/tags/findings.h"

namespace fourpost::solid_reader_test {
namespace {

const std::filesystem::path kBlocks = std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests" / "data" / "meshes";

/// Free in space; a quarter turn about x takes the box's y to z and its z to -y. The mesh holds 1 x 2 x 4 with a
/// corner at the origin.
const std::string kFreeBlock = R"(<robot name="free" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="ground"/>
  <link name="block">
    <visual>
      <origin xyz="0.5 1 2" rpy="1.5707963267948966 0 0"/>
      <geometry><box size="1 4 2"/></geometry>
    </visual>
    <visual><origin xyz="5 0 0"/><geometry><sphere radius="0.5"/></geometry></visual>
    <visual><origin xyz="0 5 0"/><geometry><cylinder radius="0.5" length="2"/></geometry></visual>
    <visual><origin xyz="0 0 5"/><geometry><mesh filename="block.obj" scale="0.1 -0.2 0.3"/></geometry></visual>
  </link>
  <joint name="free" type="floating"><parent link="ground"/><child link="block"/></joint>
  <fp:parameter name="rho" value="2 t/m^3" lower="1 t/m^3" upper="8 t/m^3" precision="1 kg/m^3" source="guess"/>
  <fp:solid link="block" density="0.5*$rho"/>
</robot>
)";

/// What the block's shapes make up, in the link.
Solid Expected() {
  const auto at = [](double x, double y, double z) { return Eigen::Affine3d(Eigen::Translation3d(x, y, z)); };
  return Mapped(BoxSolid({1, 2, 4}), at(0.5, 1, 2)) + Mapped(SphereSolid(0.5), at(5, 0, 0)) +
         Mapped(CylinderSolid(0.5, 2), at(0, 5, 0)) + Mapped(BoxSolid({0.1, 0.4, 1.2}), at(0.05, -0.2, 5.6));
}

Eigen::Matrix3d InertiaAt(const Link& link, std::span<const double> values) {
  const auto at = [&](std::size_t i) { return link.inertia[i].At(values); };
  Eigen::Matrix3d inertia;
  inertia << at(0), at(3), at(4),  //
      at(3), at(1), at(5),         //
      at(4), at(5), at(2);
  return inertia;
}

/// Sums of four shapes and turns, at numbers of this size.
double Rounding(double size) { return 32 * kUlp * size; }

void ExpectMass(const Link& link, std::span<const double> values, const Solid& solid, double density) {
  const double mass = density * solid.volume;
  EXPECT_NEAR(link.mass.At(values), mass, Rounding(mass));
  EXPECT_LE((link.ComAt({}) - solid.com).cwiseAbs().maxCoeff(), Rounding(solid.com.maxCoeff()));
  const Eigen::Matrix3d inertia = density * solid.Inertia();
  EXPECT_LE((InertiaAt(link, values) - inertia).cwiseAbs().maxCoeff(), Rounding(inertia.maxCoeff()));
}

class SolidTag : public VehicleFileTest {
 protected:
  SolidTag() { Write(ReadText(kBlocks / "block.obj"), "block.obj"); }

  /// The block with one thing changed must have this fault in the line of its `fp:solid`.
  void ExpectFault(const std::string& from, const std::string& to, const Finding& kind,
                   const std::vector<std::string>& words = {}) {
    const std::string text = Replaced(kFreeBlock, from, to);
    EXPECT_FALSE(Read(text).has_value());
    Expect(LineOf(text, "<fp:solid"), kind, words);
  }

  /// The same for a change of the mesh.
  void ExpectMeshFault(const std::string& from, const std::string& to, const Finding& kind) {
    Write(Replace(ReadText(kBlocks / "block.obj"), from, to), "block.obj");
    EXPECT_FALSE(Read(kFreeBlock).has_value());
    Expect(LineOf(kFreeBlock, "<fp:solid"), kind, {"block.obj'"});
  }
};

TEST_F(SolidTag, GivesALinkTheMassOfAllItsShapes) {
  const Vehicle vehicle = Read(kFreeBlock).value();
  const Link& link = vehicle.links.at(1);
  ExpectMass(link, vehicle.ParameterValues(), Expected(), 1000);
  EXPECT_EQ(link.mass.value, link.mass.At(vehicle.ParameterValues()));
  EXPECT_EQ(link.inertia[4].value, link.inertia[4].At(vehicle.ParameterValues()));
}

TEST_F(SolidTag, FollowsTheParameterOfItsDensity) {
  const Vehicle vehicle = Read(kFreeBlock).value();
  for (const double density : {1500.0, 7850.0})
    ExpectMass(vehicle.links.at(1), std::vector<double>{density}, Expected(), 0.5 * density);
}

TEST_F(SolidTag, MayHaveAConstantDensity) {
  std::string text = Replaced(kFreeBlock, "0.5*$rho", "7.85 g/cm^3");
  text.erase(text.find("  <fp:parameter"), text.find("  <fp:solid") - text.find("  <fp:parameter"));
  const Vehicle vehicle = Read(text).value();
  EXPECT_EQ(vehicle.links.at(1).mass.parameter, -1);
  ExpectMass(vehicle.links.at(1), {}, Expected(), 7850);
}

TEST_F(SolidTag, SumsUpSeveralLinks) {
  const std::string second = R"(<link name="second"><visual><geometry><mesh filename="block.obj" scale="1 1 1"/>)"
                             R"(</geometry></visual></link><joint name="weld" type="fixed"><parent link="block"/>)"
                             R"(<child link="second"/></joint><fp:solid link="second" density="1 kg/m^3"/></robot>)";
  const Vehicle vehicle = Read(Replaced(kFreeBlock, "</robot>", second)).value();
  ExpectMass(vehicle.links.at(1), vehicle.ParameterValues(), Expected(), 1000);
  EXPECT_EQ(vehicle.links.at(2).mass.value, 8);
}

// The text has no number of the tree to rewrite.
TEST_F(SolidTag, KeepsItsTextButForTheParameter) {
  const Vehicle vehicle = Read(kFreeBlock).value();
  const std::vector<double> values = {3250.5};
  EXPECT_EQ(VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder_), kFreeBlock);
  const std::string text = VehicleTextWithValues(vehicle, values, folder_);
  EXPECT_EQ(text, Replaced(kFreeBlock, R"(value="2 t/m^3")", R"(value="3.2505 t/m^3")"));
  const Vehicle again = Read(text).value();
  EXPECT_EQ(again.ParameterValues(), values);
  ExpectMass(again.links.at(1), values, Expected(), 0.5 * values[0]);
}

// At zero angles, with I about the link's origin and c the centre of mass: [I, m c x; -m c x, m].
TEST_F(SolidTag, GivesTheMultibodyItsMassMatrix) {
  const Vehicle vehicle = Read(kFreeBlock).value();
  const std::vector<double> values = {3000};
  Multibody multibody(vehicle);
  multibody.SetParameters(values, {});
  const Eigen::VectorXd rest = multibody.RestState();
  ASSERT_EQ(rest.size(), 12);
  const Eigen::VectorXd weight = multibody.Residual(0, rest, Eigen::VectorXd::Zero(12));
  Eigen::MatrixXd matrix(6, 6);
  for (int i = 0; i < 6; ++i)
    matrix.col(i) = multibody.Residual(0, rest, Eigen::VectorXd::Unit(12, 6 + i)).head(6) - weight.head(6);

  const Solid solid = Expected();
  const double mass = 1500 * solid.volume;
  Eigen::Matrix3d arm;
  arm << 0, -solid.com.z(), solid.com.y(),  //
      solid.com.z(), 0, -solid.com.x(),     //
      -solid.com.y(), solid.com.x(), 0;
  Eigen::MatrixXd expected(6, 6);
  expected << 1500 * solid.Inertia() - mass * arm * arm, mass * arm,  //
      -mass * arm, mass * Eigen::Matrix3d::Identity();
  // Differences of forces of the weight's size.
  EXPECT_LE((matrix - expected).cwiseAbs().maxCoeff(), Rounding(10 * expected.cwiseAbs().maxCoeff()));
}

TEST_F(SolidTag, NeedsAKnownLink) {
  ExpectFault(R"(<fp:solid link="block")", R"(<fp:solid link="blok")", kSolidLink, {"link 'blok'", "'block'"});
}

TEST_F(SolidTag, IsNotForTheGround) {
  ExpectFault(R"(<fp:solid link="block")", R"(<fp:solid link="ground")", kSolidGround);
}

TEST_F(SolidTag, IsNotForALinkWithAnInertial) {
  ExpectFault(R"(<link name="block">)",
              R"(<link name="block"><inertial><mass value="1"/>)"
              R"(<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)",
              kSolidInertial, {"link 'block'"});
}

TEST_F(SolidTag, NeedsAShape) {
  ExpectFault(kFreeBlock.substr(kFreeBlock.find("    <visual>"),
                                kFreeBlock.find("  </link>") - kFreeBlock.find("    <visual>")),
              "", kSolidNoVisual);
}

TEST_F(SolidTag, StandsOncePerLink) {
  const std::string text =
      Replaced(kFreeBlock, "</robot>", "  <fp:solid link=\"block\" density=\"1 kg/m^3\"/>\n</robot>");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "<fp:solid") + 1, kSolidTwice, {"'block'", "line " + std::to_string(LineOf(text, "<fp:solid"))});
}

TEST_F(SolidTag, NeedsADensityAboveZero) { ExpectFault("0.5*$rho", "-$rho", kNumberNotPositive); }

TEST_F(SolidTag, NeedsADensityByItsDimension) {
  const std::string text =
      Replaced(Replaced(kFreeBlock, "2 t/m^3", "2 t"), R"( lower="1 t/m^3" upper="8 t/m^3" precision="1 kg/m^3")", "");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "<fp:solid"), kParameterOfOtherDimension);
}

TEST_F(SolidTag, NeedsClosedMeshes) { ExpectMeshFault("f 2 8 6\n", "", kSurfaceOpen); }

TEST_F(SolidTag, NeedsOneSurface) { ExpectMeshFault("f 2 8 6\n", "f 2 8 6\nf 2 8 6\n", kSurfaceBranches); }

TEST_F(SolidTag, NeedsMeshesOfOneOrientation) { ExpectMeshFault("f 2 8 6", "f 2 6 8", kSurfaceFlipped); }

TEST_F(SolidTag, NeedsMeshesThatFaceOutward) {
  std::string text = ReadText(kBlocks / "block.obj");
  text = text.substr(0, text.find("f 1 3 4")) + "f 1 4 3\nf 1 2 4\nf 5 8 6\nf 5 7 8\nf 1 6 2\nf 1 5 6\n" +
         "f 3 8 7\nf 3 4 8\nf 1 7 5\nf 1 3 7\nf 2 8 4\nf 2 6 8\n";
  Write(text, "block.obj");
  EXPECT_FALSE(Read(kFreeBlock).has_value());
  Expect(LineOf(kFreeBlock, "<fp:solid"), kSurfaceInward);
}

TEST_F(SolidTag, NeedsMeshesWithAVolume) {
  ExpectFault(R"(scale="0.1 -0.2 0.3")", R"(scale="0.1 0 0.3")", kShapeScale);
}

TEST_F(SolidTag, NeedsBoxesWithAVolume) { ExpectFault(R"(size="1 4 2")", R"(size="1 -4 2")", kShapeLength); }

TEST_F(SolidTag, NeedsItsMeshes) {
  const std::string text = Replaced(kFreeBlock, "block.obj", "none.obj");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "none.obj"), kMeshMissing, {"'none.obj'"});
  Expect(LineOf(text, "<fp:solid"), kMeshUnreadable);
}

}  // namespace
}  // namespace fourpost::solid_reader_test
