#include "analysis/signals/fit_quality.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fourpost::fit_quality_test {
namespace {

const std::vector<double> kMeasured = {1, 2, 3, 4};

TEST(FitQuality, PerfectModel) {
  EXPECT_EQ(NormalisedMse_percent(kMeasured, kMeasured), 0);
  EXPECT_EQ(VarianceAccountedFor_percent(kMeasured, kMeasured), 100);
}

// Variance 5/4; the mean square of the errors (1, -1, 0, 0) is 1/2, their mean 0.
TEST(FitQuality, IsRelativeToTheVarianceOfWhatWasMeasured) {
  EXPECT_DOUBLE_EQ(NormalisedMse_percent(kMeasured, std::vector<double>{0, 3, 3, 4}), 40);
  EXPECT_DOUBLE_EQ(VarianceAccountedFor_percent(kMeasured, std::vector<double>{0, 3, 3, 4}), 60);
}

TEST(FitQuality, TheMeanAloneMissesAll) {
  EXPECT_EQ(NormalisedMse_percent(kMeasured, std::vector<double>(4, 2.5)), 100);
}

TEST(FitQuality, OnlyTheErrorSeesAnOffset) {
  EXPECT_DOUBLE_EQ(NormalisedMse_percent(kMeasured, std::vector<double>{2, 3, 4, 5}), 80);
  EXPECT_EQ(VarianceAccountedFor_percent(kMeasured, std::vector<double>{2, 3, 4, 5}), 100);
}

// A linear damper in place of a bilinear one of rates 2.6 : 1, sinusoidal speed: 100 (D^2/2) / ((m^2 + D^2)/2 - 4 D^2 /
// pi^2) with m the mean of the rates and D half their difference, 19.04 % (thesis section 3.4: about 19 %).
TEST(FitQuality, OfALinearModelOfABilinearDamper) {
  std::vector<double> bilinear;
  std::vector<double> linear;
  constexpr int kSamples = 100000;
  for (int k = 0; k < kSamples; ++k) {
    const double v = std::sin(2 * std::numbers::pi * k / kSamples);
    bilinear.push_back((v > 0 ? 2.6 : 1) * v);
    linear.push_back(1.8 * v);
  }
  EXPECT_NEAR(NormalisedMse_percent(bilinear, linear), 19.04, 0.005);  // printed digits
}

TEST(FitQuality, RefusesSignalsOfOtherLengths) {
  EXPECT_THROW(NormalisedMse_percent(kMeasured, std::vector<double>(3)), std::invalid_argument);
  EXPECT_THROW(VarianceAccountedFor_percent({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::fit_quality_test
