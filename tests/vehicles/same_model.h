#pragma once

#include <array>

#include <gtest/gtest.h>

#include "vehicles/condensed/condensed_model.h"

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
    EXPECT_EQ(a.dashpots[i].series.stiffness, b.dashpots[i].series.stiffness);
    EXPECT_EQ(a.dashpots[i].series.cubic, b.dashpots[i].series.cubic);
  }
  ASSERT_EQ(a.stiffenings.size(), b.stiffenings.size());
  for (std::size_t i = 0; i < a.stiffenings.size(); ++i) {
    EXPECT_EQ(a.stiffenings[i].direction, b.stiffenings[i].direction);
    for (const double x : {-0.1, -0.03, -0.01, 0.01, 0.03, 0.1})
      EXPECT_EQ(a.stiffenings[i].law.Force(x), b.stiffenings[i].law.Force(x));
  }
  ASSERT_EQ(a.hydraulics.size(), b.hydraulics.size());
  for (std::size_t i = 0; i < a.hydraulics.size(); ++i) {
    EXPECT_EQ(a.hydraulics[i].direction, b.hydraulics[i].direction);
    const std::array<double, 2> pressures = {3e6, 1.5e6};
    EXPECT_EQ(a.hydraulics[i].law.damper.PressureRates(0.01, 0.1, pressures),
              b.hydraulics[i].law.damper.PressureRates(0.01, 0.1, pressures));
    EXPECT_EQ(a.hydraulics[i].law.mount.stiffness, b.hydraulics[i].law.mount.stiffness);
  }
  ASSERT_EQ(a.liftoffs.size(), b.liftoffs.size());
  for (std::size_t i = 0; i < a.liftoffs.size(); ++i) {
    EXPECT_EQ(a.liftoffs[i].direction, b.liftoffs[i].direction);
    EXPECT_EQ(a.liftoffs[i].preload, b.liftoffs[i].preload);
  }
  ASSERT_EQ(a.curved_tyres.size(), b.curved_tyres.size());
  for (std::size_t i = 0; i < a.curved_tyres.size(); ++i) {
    EXPECT_EQ(a.curved_tyres[i].direction, b.curved_tyres[i].direction);
    EXPECT_EQ(a.curved_tyres[i].law, b.curved_tyres[i].law);
    EXPECT_EQ(a.curved_tyres[i].damping, b.curved_tyres[i].damping);
  }
}

}  // namespace fourpost
