#include "identify/experiments/four_post/misfit_lint.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/modelled_response.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A study whose data are what its vehicle answers at the values of its file.
LoadedStudy Exact() {
  LoadedStudy study = ShippedStudy("model1");
  const CondensedModel model = CondensedVehicle(study.vehicle).At(study.vehicle.ParameterValues());
  const auto responses = ModelledResponses(model, study.vehicle.sensors, Sines(study).runs);
  for (std::size_t r = 0; r < responses.size(); ++r)
    for (MeasuredChannel& channel : Sines(study).runs[r].channels)
      channel.response = responses[r].channels[channel.sensor].response;
  for (MeasuredLoad& load : Rest(study).loads) load.load_N = model.preloads.tyre[load.tyre];
  return study;
}

std::string Lint(const LoadedStudy& study, bool at_bound = false) {
  FitResult fit;
  fit.values = study.vehicle.ParameterValues();
  fit.parameters = {{.name = "m_sprung", .at_bound = at_bound, .dimension = kMass}};
  Diagnostics diagnostics;
  const Subject subject = study.MakeSubject();
  for (const Experiment& experiment : study.study.experiments) experiment.CheckFit(subject, fit, diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors());
  return diagnostics.Format();
}

TEST(MisfitLint, HasNothingToTellOfAFitThatAgrees) {
  LoadedStudy study = Exact();
  EXPECT_EQ(Lint(study), "");
  Rest(study).loads[0].sd_N = 200;
  Rest(study).loads[0].load_N += 3.9 * 200;
  EXPECT_EQ(Lint(study), "");
}

TEST(MisfitLint, TellsOfALoadThatIsFarOff) {
  LoadedStudy study = Exact();
  // 6 % of it: more than 4 deviations, and than what friction leaves.
  Rest(study).loads[0].sd_N = 100;
  Rest(study).loads[0].load_N += 6 * 100;
  EXPECT_THAT(Lint(study), AllOf(HasSubstr("'front_tyre' carries "), HasSubstr(" N (6 standard deviations off)"),
                                 HasSubstr("not tared"), Not(HasSubstr("rear_tyre")), Not(HasSubstr("m_sprung"))));
  EXPECT_THAT(Lint(study, true), HasSubstr("bounds that hold masses (m_sprung)"));
}

TEST(MisfitLint, TellsCausesOnce) {
  LoadedStudy study = Exact();
  for (MeasuredLoad& load : Rest(study).loads) load.load_N *= 1.06;
  for (MeasuredChannel& channel : Sines(study).runs[0].channels)
    if (channel.name == "a_cg" || channel.name == "a_tow_point")
      for (std::complex<double>& value : channel.response) value *= -1;
  const std::string text = Lint(study);
  EXPECT_THAT(text, AllOf(HasSubstr("'front_tyre' carries "), HasSubstr(", 'rear_tyre' carries "),
                          HasSubstr("'a_cg' is off in 'bounce'"), HasSubstr("'a_tow_point' is off in 'bounce'")));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

// But for a_cg in pitch, which is next to a node.
TEST(MisfitLint, CountsChannelsWhereManyAreOff) {
  LoadedStudy study = Exact();
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels)
      for (std::complex<double>& value : channel.response) value *= -1;
  const std::string text = Lint(study);
  EXPECT_THAT(text, AllOf(HasSubstr("11 channels (7 accelerations, 2 displacements, 2 forces; 11 in 'bounce', 10 in "
                                    "'pitch') are far off, the worst: '"),
                          HasSubstr("; the table of channels and the pictures of responses show all")));
  std::size_t named = 0;
  for (std::size_t at = text.find("is off in"); at != std::string::npos; at = text.find("is off in", at + 1)) ++named;
  EXPECT_EQ(named, 3U);
}

void Scale(MeasuredRun& run, const std::string& name, double factor) {
  for (MeasuredChannel& channel : run.channels)
    for (std::complex<double>& value : channel.response)
      if (channel.name == name) value *= factor;
}

TEST(MisfitLint, TellsOfAChannelThatIsFarOff) {
  LoadedStudy study = Exact();
  // Half of what is measured, over the 12 % that 1 dB is, along the phasor alone: 4.1 / sqrt(2) in the mean.
  Scale(Sines(study).runs[0], "a_cg", 2);
  EXPECT_EQ(Lint(study), "");
  // Three halves of it: 8.7, less what the floor takes.
  Scale(Sines(study).runs[0], "a_cg", -1);
  EXPECT_THAT(Lint(study), AllOf(testing::ContainsRegex("'a_cg' is off in 'bounce' by (7.9|8.[0-9]*) times"),
                                 Not(HasSubstr("'pitch'")), Not(HasSubstr("'a_tow_point'"))));
}

TEST(MisfitLint, LooksPastFrequenciesWithoutAnAnswer) {
  LoadedStudy study = Exact();
  Scale(Sines(study).runs[0], "a_cg", -2);
  const std::string all = Lint(study);
  for (MeasuredChannel& channel : Sines(study).runs[0].channels) channel.response[9] = NAN;
  EXPECT_THAT(Lint(study), HasSubstr("'a_cg' is off in 'bounce' by "));
  EXPECT_NE(all, "");
}

}  // namespace
}  // namespace fourpost
