#include "identify/experiments/four_post/misfit_lint.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/static_loads/findings.h"
#include "identify/fit/fit.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::misfit_lint_test {
namespace {

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

Diagnostics Lint(const LoadedStudy& study, bool at_bound = false) {
  FitResult fit;
  fit.values = study.vehicle.ParameterValues();
  fit.parameters = {{.name = "m_sprung", .at_bound = at_bound, .dimension = kMass}};
  Diagnostics diagnostics;
  const Subject subject = study.MakeSubject();
  for (const Experiment& experiment : study.study.experiments) experiment.CheckFit(subject, fit, diagnostics);
  EXPECT_FALSE(diagnostics.HasErrors());
  return diagnostics;
}

/// Of the study's entry of the tyre or channel.
template <typename Entries>
int LineOf(const Entries& entries, const std::string& name) {
  for (const auto& [known, source] : entries)
    if (known == name) return source.line;
  return 0;
}

int LineOfChannel(const LoadedStudy& study, const std::string& name) {
  return LineOf(Sines(study).plan.channels, name);
}

int LineOfTyre(const LoadedStudy& study, const std::string& name) { return LineOf(Rest(study).plan.tyres, name); }

TEST(MisfitLint, HasNothingToTellOfAFitThatAgrees) {
  LoadedStudy study = Exact();
  EXPECT_EQ(Lint(study).Format(), "");
  Rest(study).loads[0].sd_N = 200;
  Rest(study).loads[0].load_N += 2.9 * 200;
  EXPECT_EQ(Lint(study).Format(), "");
}

TEST(MisfitLint, TellsOfLoadsBeyondThreeDeviationsOnce) {
  LoadedStudy study = Exact();
  Rest(study).loads[0].sd_N = Rest(study).loads[1].sd_N = 100;
  Rest(study).loads[0].load_N += 350;
  Rest(study).loads[1].load_N -= 340;
  const Diagnostics found = Lint(study);
  EXPECT_THAT(found, ReportsOnly(kStaticLoadsDiffer, 0, {"'front_tyre' 350 N more (3.5 sd)", "340 N less (3.4 sd)"}));
}

TEST(MisfitLint, TellsOfALoadThatIsFarOff) {
  LoadedStudy study = Exact();
  // 6 % of it: more than 4 deviations, and than what friction leaves.
  Rest(study).loads[0].sd_N = 100;
  Rest(study).loads[0].load_N += 6 * 100;
  const int line = LineOfTyre(study, "front_tyre");
  const Diagnostics found = Lint(study);
  EXPECT_THAT(found, Reports(kStaticLoadFarOff, line, {"'front_tyre'", " N (6 standard deviations"}));
  EXPECT_THAT(found, Not(Reports(kStaticLoadFarOff, line, {"rear_tyre"})));
  // The model lacks nothing, so that the loads are to blame.
  EXPECT_THAT(found.Format(), Not(testing::HasSubstr("first add what the model lacks")));
  EXPECT_THAT(found, Not(Reports(kStaticLoadFarOff, line, {"m_sprung"})));
  EXPECT_THAT(Lint(study, true), Reports(kStaticLoadFarOff, line, {"m_sprung"}));
}

TEST(MisfitLint, TellsCausesOnce) {
  LoadedStudy study = Exact();
  for (MeasuredLoad& load : Rest(study).loads) load.load_N *= 1.06;
  for (MeasuredChannel& channel : Sines(study).runs[0].channels)
    if (channel.name == "a_cg" || channel.name == "a_tow_point")
      for (std::complex<double>& value : channel.response) value *= -1;
  const Diagnostics found = Lint(study);
  EXPECT_THAT(found, Reports(kStaticLoadFarOff, LineOfTyre(study, "front_tyre"), {"'front_tyre'", "'rear_tyre'"}));
  // At the line of their section, above the first of them.
  const int section = Sines(study).plan.channels_line;
  EXPECT_EQ(section + 1, Sines(study).plan.channels.front().second.line);
  EXPECT_THAT(found, Reports(kSinesFarOff, section, {"'a_cg' in 'bounce'", "'a_tow_point' in 'bounce'"}));
  EXPECT_EQ(found.items().size(), 2u) << found.Format();
}

// But for a_cg in pitch, which is next to a node.
TEST(MisfitLint, CountsChannelsWhereManyAreOff) {
  LoadedStudy study = Exact();
  for (MeasuredRun& run : Sines(study).runs)
    for (MeasuredChannel& channel : run.channels)
      for (std::complex<double>& value : channel.response) value *= -1;
  const Diagnostics found = Lint(study);
  ASSERT_EQ(found.items().size(), 1u) << found.Format();
  EXPECT_THAT(
      found, Reports(kManySinesFarOff, Sines(study).plan.channels_line,
                     {"11 channels", "7 accelerations, 2 displacements, 2 forces", "11 in 'bounce'", "10 in 'pitch'"}));
  const std::string& text = found.items()[0].message;
  std::size_t named = 0;
  for (std::size_t at = text.find(" times"); at != std::string::npos; at = text.find(" times", at + 1)) ++named;
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
  EXPECT_EQ(Lint(study).Format(), "");
  // Three halves of it: 8.7, less what the floor takes.
  Scale(Sines(study).runs[0], "a_cg", -1);
  const Diagnostics found = Lint(study);
  const int line = LineOfChannel(study, "a_cg");
  EXPECT_THAT(found, Reports(kSinesFarOff, line, {"'a_cg' in 'bounce'"}));
  EXPECT_THAT(found.Format(), testing::ContainsRegex("'bounce' (7.9|8.[0-9]*) times"));
  EXPECT_THAT(found, Not(Reports(kSinesFarOff, line, {"'pitch'"})));
  EXPECT_THAT(found, Not(Reports(kSinesFarOff, line, {"'a_tow_point'"})));
}

TEST(MisfitLint, LooksPastFrequenciesWithoutAnAnswer) {
  LoadedStudy study = Exact();
  Scale(Sines(study).runs[0], "a_cg", -2);
  EXPECT_NE(Lint(study).Format(), "");
  for (MeasuredChannel& channel : Sines(study).runs[0].channels) channel.response[9] = NAN;
  EXPECT_THAT(Lint(study), Reports(kSinesFarOff, LineOfChannel(study, "a_cg"), {"'a_cg' in 'bounce'"}));
}

}  // namespace
}  // namespace fourpost::misfit_lint_test
