#pragma once

#include <gtest/gtest.h>

#include "vehicles/condensed_model.h"

namespace fourpost {

/// Two condensed vehicles that come of the same numbers by the same steps: equal to the last bit.
inline void ExpectSameModel(const CondensedModel& a, const CondensedModel& b) {
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.post_stiffness, b.post_stiffness);
  EXPECT_EQ(a.post_damping, b.post_damping);
  EXPECT_EQ(a.on_position, b.on_position);
  EXPECT_EQ(a.on_velocity, b.on_velocity);
  EXPECT_EQ(a.on_acceleration, b.on_acceleration);
  EXPECT_EQ(a.on_post_height, b.on_post_height);
  EXPECT_EQ(a.on_post_velocity, b.on_post_velocity);
  EXPECT_EQ(a.on_post_acceleration, b.on_post_acceleration);
  EXPECT_EQ(a.preloads.spring, b.preloads.spring);
  EXPECT_EQ(a.preloads.tyre, b.preloads.tyre);
  EXPECT_EQ(a.preloads.bushing, b.preloads.bushing);
  ASSERT_EQ(a.dashpots.size(), b.dashpots.size());
  for (std::size_t i = 0; i < a.dashpots.size(); ++i) {
    EXPECT_EQ(a.dashpots[i].direction, b.dashpots[i].direction);
    EXPECT_EQ(a.dashpots[i].law.MeanRate(), b.dashpots[i].law.MeanRate());
    EXPECT_EQ(a.dashpots[i].series_stiffness, b.dashpots[i].series_stiffness);
  }
}

}  // namespace fourpost
