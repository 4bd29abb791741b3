#include "vehicles/response/post_stroke.h"

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>

#include "tests/vehicles/quarter_cars.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

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
  EXPECT_THAT(diagnostics.Format(),
              HasSubstr("fp:post 'post' reaches 50 mm up and down, and heave at 1 Hz asks 51.2 mm of it"));
  EXPECT_THROW(CheckStroke(vehicle, {}, "", diagnostics), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost
