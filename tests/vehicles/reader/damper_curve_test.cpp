#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/vehicles/small_vehicle.h"
#include "vehicles/reader/findings.h"

namespace fourpost::damper_curve_test {
namespace {

const std::string kSegments = R"(<segment to="-1 m/s" rate="500 N*s/m"/>
<segment to="-0.1 m/s" rate="1 kN*s/m"/>
<segment to="0.05 m/s" rate="4 kN*s/m"/>
<segment to="0.5 m/s" rate="2 kN*s/m"/>)";

std::string WithCurve(const std::string& segments, const std::string& more = "") {
  return Replaced(kSmallVehicle, R"(<linear rate="10 N*s/m"/>)", "<curve>" + segments + "</curve>" + more);
}

class DamperCurve : public VehicleFileTest {
 protected:
  void Refuses(const std::string& from, const std::string& to, const std::string& at, const Finding& kind) {
    const std::string text = WithCurve(Replaced(kSegments, from, to));
    EXPECT_FALSE(Read(text).has_value());
    Expect(LineOf(text, at), kind);
  }
};

TEST_F(DamperCurve, PassesThroughTheEndsOfItsSegments) {
  const std::optional<Vehicle> vehicle = Read(WithCurve(kSegments));
  ASSERT_TRUE(vehicle.has_value());
  const DashpotLaw law = vehicle->dampers.at(1).law.At(vehicle->ParameterValues());
  EXPECT_EQ(law.Force(0), 0);
  EXPECT_DOUBLE_EQ(law.Force(0.05), 200);
  EXPECT_DOUBLE_EQ(law.Force(0.5), 200 + 900);
  EXPECT_DOUBLE_EQ(law.Force(-0.1), -100);
  EXPECT_DOUBLE_EQ(law.Force(-1), -100 - 450);
  // Straight on, with the slope at the end.
  EXPECT_NEAR(law.Force(-2), -550 + (law.Force(-1.001) - law.Force(-1)) * 1000, 1e-6);
}

TEST_F(DamperCurve, GoesInSeriesWithASpringWhereItRises) {
  EXPECT_TRUE(Read(WithCurve(kSegments, R"(<series stiffness="800 kN/m"/>)")).has_value());
  const std::string flat = Replaced(kSegments, "2 kN*s/m", "0 N*s/m");
  const std::string text = WithCurve(flat, "\n<series stiffness=\"700 kN/m\"/>");
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "700 kN/m"), kSeriesWithoutRate);
}

TEST_F(DamperCurve, RefusesSegmentsThatDoNotRise) {
  Refuses(R"(to="0.5 m/s")", R"(to="0.04 m/s")", "0.04 m/s", kSegmentOrder);
}

TEST_F(DamperCurve, RefusesSegmentsThatEndAtRest) {
  Refuses(R"(to="0.05 m/s")", R"(to="0 m/s")", "to=\"0 m/s", kSegmentAtRest);
}

TEST_F(DamperCurve, RefusesOneSide) {
  const std::string text = WithCurve(kSegments.substr(kSegments.find("<segment to=\"0.05")));
  EXPECT_FALSE(Read(text).has_value());
  Expect(LineOf(text, "<curve>"), kCurveOneSided);
}

}  // namespace
}  // namespace fourpost::damper_curve_test
