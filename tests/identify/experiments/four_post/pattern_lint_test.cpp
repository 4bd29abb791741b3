#include "identify/experiments/four_post/pattern_lint.h"

#include <random>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/recording_lint.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Car {
  explicit Car(const std::string& name)
      : study(ShippedStudy(name)), model(CondensedVehicle(study.vehicle).At(study.vehicle.ParameterValues())) {}

  std::optional<std::string> Doubt(MeasuredRun run, const std::vector<double>& told) const {
    run.excitation.shape = told;
    const std::optional<PatternFault> fault = PatternDoubt(study.vehicle, model, run);
    if (!fault) return std::nullopt;
    return fault->text;
  }

  /// Nothing for one that its posts cannot make.
  std::optional<std::vector<double>> Pattern(std::string_view name) const {
    try {
      return PostPattern(study.vehicle, name);
    } catch (const std::invalid_argument&) {
      return std::nullopt;
    }
  }

  LoadedStudy study;
  CondensedModel model;
};

std::vector<double> Opposite(std::vector<double> shape) {
  for (double& share : shape) share = -share;
  return shape;
}

class PatternOfCar : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(PatternLint, PatternOfCar, testing::Values("model1", "model2", "model3", "full"));

TEST_P(PatternOfCar, TellsEachWrongMotionOfTheRigsRecordings) {
  const Car car(GetParam());
  for (const MeasuredRun& run : Sines(car.study).runs) {
    const std::vector<double>& right = run.excitation.shape;
    EXPECT_EQ(car.Doubt(run, right), std::nullopt);
    for (const std::string_view name : kPostPatterns) {
      const auto wrong = car.Pattern(name);
      if (!wrong || *wrong == right) continue;
      const std::string real = run.name == "bounce" ? "heave" : run.name;
      EXPECT_THAT(car.Doubt(run, *wrong).value_or(""),
                  AllOf(HasSubstr("'" + run.name + "' is told to be of posts that move as " + std::string(name)),
                        HasSubstr("look like " + real + " (")))
          << run.name;
    }
    // Front and rear, or left and right swapped; or the reference turned round.
    EXPECT_THAT(car.Doubt(run, Opposite(right)).value_or(""), HasSubstr("look like ")) << run.name;
  }
}

// One axle or side alone, and its mirror image.
TEST(PatternLint, TellsEndsAndSidesThatAreSwapped) {
  const Car car("model3");
  MeasuredRun run = Sines(car.study).runs.front();
  const std::vector<std::vector<double>> shapes = {
      {1, 1, 0, 0}, {0, 0, 1, 1}, {1, 0, 1, 0}, {0, 1, 0, 1}, {1, 0, 0, 0}};
  for (const std::vector<double>& shape : shapes) {
    run.excitation.shape = shape;
    const FrequencyResponse response = ModelledResponses(car.model, car.study.vehicle.sensors, {run}).front();
    for (MeasuredChannel& channel : run.channels) channel.response = response.channels[channel.sensor].response;
    EXPECT_EQ(car.Doubt(run, shape), std::nullopt);
    EXPECT_NE(car.Doubt(run, {shape[1], shape[0], shape[3], shape[2]}) == std::nullopt,
              shape[0] != shape[1] || shape[2] != shape[3]);
    EXPECT_NE(car.Doubt(run, {shape[2], shape[3], shape[0], shape[1]}) == std::nullopt,
              shape[0] != shape[2] || shape[1] != shape[3]);
  }
}

TEST(PatternLint, TellsOfAMotionThatAPlanarCarCannotMake) {
  const Car planar("model1");
  const Car whole("model3");
  MeasuredRun run = Sines(planar.study).runs.front();
  // What means of left and right leave of a roll: next to nothing, and that of noise.
  std::mt19937_64 engine(3);
  std::normal_distribution<double> draw;
  for (MeasuredChannel& channel : run.channels)
    for (std::complex<double>& value : channel.response)
      value = 0.02 * std::complex<double>(draw(engine), draw(engine));
  EXPECT_THAT(planar.Doubt(run, run.excitation.shape).value_or(""), HasSubstr("none that these posts can make"));
  const std::optional<PatternFault> fault = PatternDoubt(planar.study.vehicle, planar.model, run);
  ASSERT_TRUE(fault);
  EXPECT_FALSE(fault->is_certain);
}

// Rates and masses of a file may be off by a third, and twins have noise.
TEST(PatternLint, IsSilentAboutNoisyTwinsAndRoughVehicleFiles) {
  for (const char* name : {"model1", "model3"}) {
    const Car car(name);
    std::mt19937_64 engine(7);
    std::normal_distribution<double> noise(0, 0.05);
    std::uniform_real_distribution<double> spread(0.7, 1.4);
    for (int twin = 0; twin < 10; ++twin) {
      std::vector<double> values = car.study.vehicle.ParameterValues();
      for (const std::size_t index : car.study.free) values[index] *= spread(engine);
      const CondensedModel model = CondensedVehicle(car.study.vehicle).At(values);
      for (MeasuredRun run : Sines(car.study).runs) {
        const FrequencyResponse response = ModelledResponses(model, car.study.vehicle.sensors, {run}).front();
        for (MeasuredChannel& channel : run.channels) {
          channel.response = response.channels[channel.sensor].response;
          for (std::complex<double>& value : channel.response)
            value *= 1.0 + std::complex<double>(noise(engine), noise(engine));
        }
        EXPECT_FALSE(PatternDoubt(car.study.vehicle, car.model, run));
      }
    }
  }
}

// Signs cannot be told where the motion of the posts is in doubt.
TEST(PatternLint, LeavesSignsAloneWhereTheMotionIsWrong) {
  LoadedStudy study = ShippedStudy("model1");
  Sines(study).runs[0].excitation.shape = {1, -1};
  Diagnostics diagnostics;
  CheckRecordings(study, Severity::kWarning, diagnostics);
  ASSERT_EQ(diagnostics.items().size(), 1U) << diagnostics.Format();
  EXPECT_EQ(diagnostics.items()[0].place.line, Sines(study).plan.recordings[0].line);
  EXPECT_THAT(diagnostics.items()[0].message,
              AllOf(HasSubstr("recording 'bounce'"), HasSubstr("look like heave (front 1, rear 1)"),
                    Not(HasSubstr("moves against"))));
}

// Where no one asked to fit all the same.
TEST(PatternLint, IsAnErrorWhereAskedFor) {
  LoadedStudy study = ShippedStudy("model1");
  Diagnostics right;
  CheckRecordings(study, Severity::kError, right);
  EXPECT_EQ(right.Format(), "");
  Sines(study).runs[0].excitation.shape = {1, -1};
  Diagnostics wrong;
  CheckRecordings(study, Severity::kError, wrong);
  EXPECT_TRUE(wrong.HasErrors());
}

TEST(PatternLint, SaysNothingWithoutLowFrequencies) {
  const Car car("model1");
  const MeasuredRun high = InBand({Sines(car.study).runs[0]}, 1.1, 12).front();
  EXPECT_EQ(car.Doubt(high, {1, -1}), std::nullopt);
}

}  // namespace
}  // namespace fourpost
