#include "analysis/files/universal/universal_writer.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/files/universal/universal_file.h"
#include "tests/analysis/files/byte_writer.h"
#include "tests/temporary_folder.h"

namespace fourpost::universal_writer_test {
namespace {

TEST(UniversalWriter, RoundTripIsBitEqual) {
  Recording recording = {.format = "", .description = "run 3"};
  recording.channels.push_back(
      {.name = "a_hub", .unit = "m/s^2", .step_s = 0.002, .values = {std::numbers::pi, -1e-300, 1.0 / 3}});
  // A step that five decimals do not hold, and a name that no field but the description does.
  recording.channels.push_back(
      {.name = "tyre force of the left front wheel", .unit = "N", .start_s = 0.1, .step_s = 1.0 / 3, .values = {1, 2}});
  recording.channels.push_back({.name = "jittered", .unit = "", .values = {5, 6, 7}, .times_s = {0, 0.1, 0.25}});
  const Recording again = ReadBytes(UniversalBytes(recording));
  ASSERT_EQ(again.channels.size(), 3);
  EXPECT_EQ(again.description.substr(0, 5), "run 3");
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.channels[i].name, recording.channels[i].name);
    EXPECT_EQ(again.channels[i].unit, recording.channels[i].unit);
    EXPECT_EQ(again.channels[i].values, recording.channels[i].values);
  }
  EXPECT_EQ(again.channels[0].step_s, 0.002);
  EXPECT_EQ(again.channels[1].times_s, (std::vector<double>{0.1, 0.1 + 1.0 / 3}));
  EXPECT_EQ(again.channels[2].times_s, recording.channels[2].times_s);
}

TEST(UniversalWriter, ResponsesReadBackBitForBit) {
  const TemporaryFolder folder;
  const std::vector<double> frequencies = {0.5, std::numbers::pi, 20};
  const std::vector<UniversalResponse> responses = {
      {"a_body_front_left", "m/s^2", {{-1e-300, 2}, {3, 1.0 / 3}, {5, 6}}}, {"F", "N", {{1, 2}, {3, 4}, {5, 6}}}};
  const UniversalFile file(folder.Write("heave.uff", UniversalBytes(frequencies, "FL", responses)));
  ASSERT_EQ(file.responses().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const UniversalFunction& function = file.responses()[i];
    const UniversalNumbers numbers = file.Numbers(function);
    EXPECT_EQ(NameOf(function), responses[i].name);
    EXPECT_EQ(function.ordinate.unit, responses[i].unit);
    EXPECT_EQ(function.reference.entity, "FL");
    EXPECT_EQ(function.denominator.unit, "m");
    EXPECT_EQ(numbers.abscissa, frequencies);
    EXPECT_EQ(numbers.values, responses[i].values);
  }
  EXPECT_THROW(UniversalBytes(frequencies, "FL", {}), std::invalid_argument);
  EXPECT_THROW(UniversalBytes(std::vector<double>{1}, "FL", responses), std::invalid_argument);
}

TEST(UniversalWriter, RefusesChannelsWithoutValuesOrTimes) {
  EXPECT_THROW(UniversalBytes({}), std::invalid_argument);
  Recording recording = {.format = "", .description = "", .channels = {{.name = "a", .unit = "m", .values = {1, 2}}}};
  EXPECT_THROW(UniversalBytes(recording), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::universal_writer_test
