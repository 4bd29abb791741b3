#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/suggest/addition_source.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::spring_additions_test {
namespace {

constexpr const char* kElasticFriction =
    R"(<linear rate="1 N*s/m"/><friction force="40 N"/><series stiffness="80 kN/m"/>)";

/// How often elastic friction beside the spring of the quarter car is offered, where a damper stands there.
std::size_t OfferedBeside(const std::string& ends, const std::string& law) {
  const std::filesystem::path file = std::filesystem::path(FOURPOST_SOURCE_DIR) / "urdf/quarter_car.urdf";
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::string changed = text.str();
  changed.insert(changed.rfind("</robot>"),
                 "<fp:damper name=\"leaves\" " + ends + " axis=\"0 0 1\">" + law + "</fp:damper>");
  Diagnostics findings;
  const std::optional<Vehicle> vehicle = ReadVehicleText(changed, file, findings);
  EXPECT_TRUE(vehicle) << findings.Format();
  const std::vector<double> values = vehicle->ParameterValues();
  const AdditionSource source(*vehicle, values);
  std::vector<Addition> found;
  AddHysteresisAdditions(source, found);
  return found.size();
}

TEST(SpringAdditions, OfferNoElasticFrictionWhereThereIsSomeWhicheverEndItNamesFirst) {
  EXPECT_EQ(OfferedBeside(R"(parent="strut_top" child="strut_bottom")", "<linear rate=\"1 N*s/m\"/>"), 3u);
  EXPECT_EQ(OfferedBeside(R"(parent="strut_top" child="strut_bottom")", kElasticFriction), 0u);
  EXPECT_EQ(OfferedBeside(R"(parent="strut_bottom" child="strut_top")", kElasticFriction), 0u);
}

}  // namespace
}  // namespace fourpost::spring_additions_test
