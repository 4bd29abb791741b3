#include "vehicles/posts/road_tracks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::road_tracks_test {
namespace {

TEST(RoadTracks, OfACarAreLeftAndRight) {
  const RoadTracks tracks = RoadTracksOf(ShippedVehicle("landrover110_model3"));
  ASSERT_EQ(tracks.posts.size(), 4u);
  // FL, FR, RL, RR.
  for (const std::size_t i : {0u, 2u}) EXPECT_EQ(tracks.posts[i].side, 1);
  for (const std::size_t i : {1u, 3u}) EXPECT_EQ(tracks.posts[i].side, -1);
  for (const std::size_t i : {0u, 1u}) EXPECT_EQ(tracks.posts[i].behind, 0);
  for (const std::size_t i : {2u, 3u}) EXPECT_NEAR(tracks.posts[i].behind, 2.794, 1e-12);
  EXPECT_NEAR(tracks.distance, 2 * 0.743, 1e-12);
  EXPECT_NEAR(tracks.length(), 2.794, 1e-12);
}

TEST(RoadTracks, OfAHalfCarAreOne) {
  const RoadTracks tracks = RoadTracksOf(ShippedVehicle("landrover110_linkage"));
  EXPECT_EQ(tracks.distance, 0);
  for (const RoadTracks::Place& place : tracks.posts) EXPECT_EQ(place.side, 1);
}

// x K1(x): 1 at 0, and at 1 the tabulated K1(1) (Abramowitz and Stegun, table 9.8).
TEST(RoadTracks, CoherenceFallsFromLongToShortWaves) {
  EXPECT_EQ(TrackCoherence(0.3, 0), 1);
  EXPECT_NEAR(TrackCoherence(1 / (2 * M_PI), 1), 0.6019072302, 1e-10);
  EXPECT_LT(TrackCoherence(2, 1.5), 1e-6);
  EXPECT_EQ(TrackCoherence(1000, 1.5), 0);
}

// At 0.1 cycles/m a class's roughness, per hertz at 20 m/s.
TEST(RoadTracks, DensityIsThatOfTheClass) {
  EXPECT_NEAR(RoadDensity(64e-6, 20, 2), 64e-6 / 20, 1e-20);
  EXPECT_NEAR(RoadDensity(64e-6, 20, 4), 16e-6 / 20, 1e-20);
}

}  // namespace
}  // namespace fourpost::road_tracks_test
