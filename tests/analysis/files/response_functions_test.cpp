#include "analysis/files/response_functions.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "analysis/files/frequency_response_file.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::response_functions_test {
namespace {

/// A frequency response at 0, 2 and 4 Hz of a quantity to that of a post, as data set 58.
std::string Function(const std::string& name, int quantity, const std::string& unit, int reference,
                     const std::string& reference_unit, const std::string& post = "post") {
  const auto padded = [](std::string text, std::size_t size) { return text.resize(size, ' '), text; };
  const auto axis = [&](int code, const std::string& text) {
    const std::string number = std::to_string(code);
    return std::string(10 - number.size(), ' ') + number + "    0    0    0 " + padded("NONE", 20) + " " +
           padded(text, 20) + "\n";
  };
  return "    -1\n    58\n" + name + "\nNONE\nNONE\nNONE\nNONE\n    4         1    0         0 " + padded(name, 10) +
         "         0   0 " + padded(post, 10) + "         1   3\n" +
         "         5         3         1  0.00000E+00  2.00000E+00  0.00000E+00\n" + axis(18, "Hz") +
         axis(quantity, unit) + axis(reference, reference_unit) + axis(0, "NONE") +
         "  9.00000E+00  0.00000E+00  3.00000E+00  0.00000E+00  0.00000E+00  5.00000E+00\n    -1\n";
}

class ResponseFunctions : public ::testing::Test {
 protected:
  std::optional<FrequencyResponse> Read(const std::string& text, std::optional<double> amplitude_m = 0.005) {
    return ReadFrequencyResponse(folder_.Write("f.uff", text), diagnostics_, amplitude_m);
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(ResponseFunctions, AreASteppedSineInSi) {
  const auto sine = Read(Function("s_FL", 8, "mm", 8, "mm") + Function("F_FL", 13, "kN", 8, "mm"));
  ASSERT_TRUE(sine) << diagnostics_.Format();
  EXPECT_EQ(sine->frequency_Hz, (std::vector<double>{2, 4}));
  EXPECT_EQ(sine->amplitude_m, (std::vector<double>{0.005, 0.005}));
  ASSERT_EQ(sine->channels.size(), 2);
  // Gain and phase and back: a few roundings.
  EXPECT_NEAR(std::abs(sine->channels[0].response[0] - 3.0), 0, 1e-14);
  EXPECT_NEAR(std::abs(sine->channels[0].response[1] - std::complex<double>(0, 5)), 0, 1e-14);
  // kN/mm are 1e6 N/m.
  EXPECT_NEAR(std::abs(sine->channels[1].response[0] - 3e6), 0, 1e-8);
  EXPECT_EQ(sine->channels[1].unit, "N");
}

TEST_F(ResponseFunctions, ReferToTheDisplacementOfThePostWhateverWasMeasuredOfIt) {
  const double w = 2 * std::numbers::pi * 2;
  const auto sine = Read(Function("s", 8, "m", 12, "m/s^2") + Function("a", 12, "g", 12, "g") +
                         Function("b", 12, "m/s^2", 8, "m") + Function("v", 8, "m", 11, "m/s"));
  ASSERT_TRUE(sine) << diagnostics_.Format();
  // By hand: x = -a / w^2, v = i w x; accelerometers are relative to the post's acceleration.
  EXPECT_NEAR(std::abs(sine->channels[0].response[0] / (-3 * w * w) - 1.0), 0, 1e-14);
  EXPECT_NEAR(std::abs(sine->channels[1].response[0] - 3.0), 0, 1e-14);
  EXPECT_NEAR(std::abs(sine->channels[2].response[0] / (-3 / (w * w)) - 1.0), 0, 1e-14);
  EXPECT_NEAR(std::abs(sine->channels[3].response[0] / std::complex<double>(0, 3 * w) - 1.0), 0, 1e-14);
}

TEST_F(ResponseFunctions, NeedTheAmplitudeOfTheStudy) {
  EXPECT_FALSE(Read(Function("s", 8, "m", 8, "m"), std::nullopt));
  EXPECT_THAT(diagnostics_, ReportsOnly(kAmplitudeMissing, 0));
}

TEST_F(ResponseFunctions, OfSeveralReferencesAreRefused) {
  EXPECT_FALSE(Read(Function("s", 8, "m", 8, "m", "FL") + Function("t", 8, "m", 8, "m", "FR")));
  EXPECT_THAT(diagnostics_, Reports(kResponsesOfSeveralPoints, {"FL", "FR"}));
}

TEST_F(ResponseFunctions, ToAForceAreRefused) {
  EXPECT_FALSE(Read(Function("s", 8, "m", 13, "N")));
  EXPECT_THAT(diagnostics_, Reports(kResponseReference, 2, {"'s'", "'N'"}));
}

TEST_F(ResponseFunctions, OfOtherUnitsAreLeftOut) {
  const auto sine = Read(Function("s", 8, "m", 8, "m") + Function("p", 15, "kPa", 8, "m"));
  ASSERT_TRUE(sine) << diagnostics_.Format();
  EXPECT_EQ(sine->channels.size(), 1);
  EXPECT_THAT(diagnostics_, ReportsOnly(kResponseUnit, 17, {"'p'", "kPa"}));
}

}  // namespace
}  // namespace fourpost::response_functions_test
