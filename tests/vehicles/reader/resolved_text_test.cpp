#include "vehicles/reader/resolved_text.h"

#include <functional>

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "tests/vehicles/element_car.h"
#include "tests/vehicles/ride_vehicles.h"
#include "tests/vehicles/same_model.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/tags/tag.h"

namespace fourpost::resolved_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Calls `visit` for each attribute of our tags with a default.
void VisitDefaults(const tinyxml2::XMLElement& element, const std::string& path,
                   const std::function<void(const tinyxml2::XMLElement&, const AttributeRule&)>& visit) {
  for (const tinyxml2::XMLElement* child : Children(element)) {
    const std::string below = path.empty() ? child->Name() : path + "/" + child->Name();
    if (const TagRule* rule = FormOf(*child, below))
      for (const AttributeRule& attribute : rule->attributes)
        if (!attribute.fallback.empty()) visit(*child, attribute);
    VisitDefaults(*child, below, visit);
  }
}

class Resolved : public VehicleFileTest {
 protected:
  std::string Resolve(const std::string& text) { return ResolvedText(Read(text).value(), folder_); }
};

TEST_F(Resolved, FillsInWhatIsLeftOutAndNothingElse) {
  std::string expected = kSmallVehicle;
  const auto fill = [&](const std::string& before, const std::string& defaults) {
    expected = Replaced(expected, before, before + defaults);
  };
  fill(R"(<fp:bind to="link[body]/mass")", R"( factor="1")");
  fill(R"(xyz="0.1 0 0.4")", R"( rpy="0 0 0" dx="0 mm" dy="0 mm" dz="0 mm")");
  fill(R"(<linear stiffness="$k")", R"( preload="equilibrium")");
  fill(R"(<series stiffness="800 N/mm")", R"( cubic="0 N/m^3")");
  fill(R"(damping="50 N*s/m" preload="2 kN")",
       R"( progression="0 1/m" radius="0 m" lateral="0 N/m" longitudinal="0 N/m" lateral_damping="0 N*s/m" )"
       R"(longitudinal_damping="0 N*s/m" liftoff="true")");
  fill(R"(type="accelerometer" link="body" xyz="1 0 0")", R"( axis="0 0 1")");
  fill(R"(type="load_cell" tyre="tyre")", R"( wheelpan="0 kg")");
  const std::string note = "<!-- fourpost check, resolved: defaults of fp: tags are filled in. -->";
  EXPECT_EQ(Resolve(kSmallVehicle), Replaced(expected, R"(<?xml version="1.0"?>)", "<?xml version=\"1.0\"?>\n" + note));
}

// The table of tags says what has a default.
TEST_F(Resolved, LeavesNoDefaultOfAnyTagOut) {
  int filled = 0;
  for (const std::string& text : {kElementCar, BeamAxleCar(), kIndependentCar}) {
    const std::string resolved = Resolve(text);
    tinyxml2::XMLDocument document;
    ASSERT_EQ(document.Parse(resolved.c_str()), tinyxml2::XML_SUCCESS);
    VisitDefaults(*document.RootElement(), "", [&](const auto& element, const AttributeRule& attribute) {
      ++filled;
      EXPECT_TRUE(AttributeText(element, attribute.name) || AttributeText(element, "free_length"))
          << Describe(element) << " " << attribute.name;
    });
  }
  EXPECT_GT(filled, 100);
}

TEST_F(Resolved, ReadsAsTheSameVehicle) {
  for (const std::string& text : {kElementCar, BeamAxleCar(), kIndependentCar}) {
    const Vehicle vehicle = Read(text).value();
    const Vehicle again = Read(ResolvedText(vehicle, folder_)).value();
    EXPECT_EQ(again.ParameterValues(), vehicle.ParameterValues());
    ExpectSameModel(CondensedVehicle(again).At(vehicle.ParameterValues()),
                    CondensedVehicle(vehicle).At(vehicle.ParameterValues()));
  }
}

TEST_F(Resolved, HasNothingMoreToFillIn) {
  const std::string once = Resolve(kElementCar);
  EXPECT_TRUE(Resolve(once) == once);
}

TEST_F(Resolved, GivesNoPreloadBesideAFreeLength) {
  const std::string text =
      Replaced(kSmallVehicle, R"(<linear stiffness="$k"/>)", R"(<linear stiffness="$k" free_length="1 m"/>)");
  EXPECT_THAT(Resolve(text), HasSubstr(R"(<linear stiffness="$k" free_length="1 m"/>)"));
}

TEST_F(Resolved, TellsWhatItLeavesUnexpanded) {
  EXPECT_THAT(Resolve(kSmallVehicle), Not(HasSubstr("not written out")));
  EXPECT_THAT(Resolve(kIndependentCar), HasSubstr("The mirror partners that fp:mirror makes are not written out. -->"));
  const std::string text = Replaced(kSmallVehicle, "<fp:frame name=\"top\"", "<frame name=\"top\"");
  EXPECT_THAT(Resolve(text), HasSubstr("Tags of Drake stand as they are. -->"));
}

TEST_F(Resolved, PutsItsNoteOnTopOfATextWithoutDeclaration) {
  const std::string text = Replaced(kSmallVehicle, "<?xml version=\"1.0\"?>\n", "");
  EXPECT_THAT(Resolve(text), testing::StartsWith("<!-- fourpost check"));
  EXPECT_THAT(Resolve("\xEF\xBB\xBF" + text), testing::StartsWith("\xEF\xBB\xBF<!-- fourpost check"));
}

// The parser takes any instruction at the top for the declaration, and none behind a comment.
TEST_F(Resolved, PutsItsNoteBehindAnotherInstruction) {
  const std::string text = Replaced(kSmallVehicle, R"(<?xml version="1.0"?>)", "<?lmv version=\"1.0\"?>");
  const std::string resolved = Resolve(text);
  EXPECT_THAT(resolved, testing::StartsWith("<?lmv version=\"1.0\"?>\n<!-- fourpost check, resolved"));
  EXPECT_TRUE(Read(resolved).has_value()) << diagnostics_.Format();
}

TEST_F(Resolved, NamesMeshesFromItsFolder) {
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf" / "quarter_car.urdf";
  const Vehicle vehicle = ReadVehicle(file, diagnostics_).value();
  const std::filesystem::path root = std::filesystem::weakly_canonical(FOURPOST_SOURCE_DIR);
  EXPECT_THAT(ResolvedText(vehicle, root), HasSubstr(R"(filename="meshes/wheel.stl")"));
  EXPECT_THAT(ResolvedText(vehicle, file.parent_path()), HasSubstr(R"(filename="../meshes/wheel.stl")"));
}

TEST_F(Resolved, NeedsAVehicleThatWasRead) { EXPECT_THROW(ResolvedText(Vehicle(), folder_), std::invalid_argument); }

}  // namespace
}  // namespace fourpost::resolved_text_test
