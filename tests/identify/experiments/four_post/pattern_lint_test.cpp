#include "identify/experiments/four_post/pattern_lint.h"

#include <random>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/recording_lint.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost::pattern_lint_test {
namespace {

struct Car {
  explicit Car(const std::string& name)
      : study(ShippedStudy(name)), model(CondensedVehicle(study.vehicle).At(study.vehicle.ParameterValues())) {}

  Diagnostics Doubt(MeasuredRun run, const std::vector<double>& stated) const {
    run.excitation.shape = stated;
    Diagnostics doubt;
    if (const Found found = PatternDoubt(study.vehicle, model, run)) doubt.Report(*found.kind, {}, found.words);
    return doubt;
  }

  bool IsDoubted(const MeasuredRun& run, const std::vector<double>& stated) const {
    return !Doubt(run, stated).items().empty();
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
    EXPECT_FALSE(car.IsDoubted(run, right));
    for (const std::string_view name : kPostPatterns) {
      const auto wrong = car.Pattern(name);
      if (!wrong || *wrong == right) continue;
      const std::string real = run.name == "bounce" ? "heave" : run.name;
      EXPECT_THAT(car.Doubt(run, *wrong),
                  Reports(kPostsMoveOtherwise, 0, {"'" + run.name + "'", "as " + std::string(name), real + " ("}))
          << run.name;
    }
    // Front and rear, or left and right swapped; or the reference inverted.
    EXPECT_THAT(car.Doubt(run, Opposite(right)), Reports(kPostsMoveOtherwise, 0)) << run.name;
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
    EXPECT_FALSE(car.IsDoubted(run, shape));
    EXPECT_EQ(car.IsDoubted(run, {shape[1], shape[0], shape[3], shape[2]}),
              shape[0] != shape[1] || shape[2] != shape[3]);
    EXPECT_EQ(car.IsDoubted(run, {shape[2], shape[3], shape[0], shape[1]}),
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
  const Diagnostics doubt = planar.Doubt(run, run.excitation.shape);
  EXPECT_THAT(doubt, Reports(kPostsMatchNothing, 0));
  EXPECT_FALSE(doubt.HasErrors());
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
  EXPECT_FALSE(diagnostics.HasErrors());
  EXPECT_THAT(diagnostics, Reports(kPostsMoveOtherwise, Sines(study).plan.recordings[0].line,
                                   {"'bounce'", "heave (front 1, rear 1)"}));
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
  EXPECT_FALSE(car.IsDoubted(high, {1, -1}));
}

}  // namespace
}  // namespace fourpost::pattern_lint_test
