#include "vehicles/response/post_stroke.h"

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "tests/findings.h"
#include "tests/vehicles/quarter_cars.h"
#include "vehicles/response/findings.h"

namespace fourpost::post_stroke_test {
namespace {

TEST(PostStroke, IsHalfUpAndHalfDown) {
  Vehicle vehicle = ShippedVehicle("quarter_car");
  Diagnostics diagnostics;
  const auto check = [&](double excursion) {
    CheckStroke(vehicle, std::vector{excursion}, "heave at 1 Hz", diagnostics);
  };
  check(5);
  vehicle.posts[0].stroke = 0.1;
  check(0.05);
  EXPECT_EQ(diagnostics.Format(), "");
  check(0.0512);
  EXPECT_THAT(diagnostics, Reports(kStrokeExceeded, {"fp:post 'post'", "50 mm", "heave at 1 Hz", "51.2 mm"}));
  EXPECT_THROW(CheckStroke(vehicle, {}, "", diagnostics), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::post_stroke_test
