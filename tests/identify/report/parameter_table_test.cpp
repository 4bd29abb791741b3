#include "identify/report/parameter_table.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fourpost::parameter_table_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ReportedParameter Known() {
  return {.name = "m", .value = 100, .start = 90, .lower = 50, .upper = 150, .sd = 1, .lower_95 = 98, .upper_95 = 102};
}

TEST(ParameterTable, ShowsTheIntervalBetweenTheBounds) {
  EXPECT_THAT(ParameterTableHtml({Known()}, ""),
              AllOf(HasSubstr("class=\"interval\" style=\"left:48.00%;width:4.00%\""), HasSubstr("well determined"),
                    Not(HasSubstr("reaches beyond the"))));
}

TEST(ParameterTable, TellsIntervalsThatReachBeyondABound) {
  ReportedParameter wide = Known();
  wide.sd = 40;
  wide.lower_95 = 20;
  wide.upper_95 = 140;
  // As far as the bound, with an arrow.
  EXPECT_THAT(ParameterTableHtml({wide}, ""),
              AllOf(HasSubstr("class=\"interval below\" style=\"left:0.00%;width:90.00%\""),
                    HasSubstr("weakly determined, interval reaches beyond the lower bound")));
  wide.upper_95 = 180;
  EXPECT_THAT(ParameterTableHtml({wide}, ""),
              AllOf(HasSubstr("class=\"interval below above\""), HasSubstr("interval reaches beyond both bounds")));
}

TEST(ParameterTable, MarksEndsThatAreCutAtABound) {
  ReportedParameter cut = Known();
  cut.sd = 40;
  cut.lower_95 = cut.lower;
  cut.upper_95 = 140;
  EXPECT_THAT(ParameterTableHtml({cut}, ""), HasSubstr("weakly determined, interval cut at lower bound"));
  cut.upper_95 = cut.upper;
  EXPECT_THAT(ParameterTableHtml({cut}, ""), HasSubstr("interval cut at both bounds"));
  EXPECT_THAT(ParameterTableHtml({Known()}, ""), Not(HasSubstr("interval cut")));
}

TEST(ParameterTable, WritesTheEndsOfTheIntervalAndWhereABoundCutsThem) {
  EXPECT_THAT(ParameterTableHtml({Known()}, "", "80 to 90 %"),
              AllOf(HasSubstr("interval of 80\u00a0to\u00a090\u00a0%"), HasSubstr(">98.0 \u2026 102.0<")));
  ReportedParameter cut = Known();
  cut.upper_95 = cut.upper;
  EXPECT_THAT(ParameterTableHtml({cut}, ""),
              AllOf(HasSubstr(">98.0 \u2026 150\u202f\u2192<"), HasSubstr("class=\"interval above\"")));
}

TEST(ParameterTable, SaysInWordsWhatLimitsAndWhatToDo) {
  ReportedParameter wide = Known();
  wide.limited_by = "model: 2.4 .. 4.8 Hz";
  EXPECT_THAT(ParameterTableHtml({wide}, ""), AllOf(HasSubstr("limited by the model (2.4 to 4.8 Hz)"),
                                                    HasSubstr("add to the model what they ask for")));
  wide.limited_by = "noise";
  EXPECT_THAT(ParameterTableHtml({wide}, ""), HasSubstr("title=\"Measure longer or more often.\""));
}

TEST(IntervalBasis, SaysWhatWouldNarrowTheIntervals) {
  ReportedParameter m = Known();
  m.limited_by = "held: kt";
  m.noise_factor = 4.9;
  const nlohmann::json result = {
      {"misfit", 2.2},
      {"intervals",
       {{"model_error", true},
        {"ways", {{{"by", "octaves"}}}},
        {"contradictions",
         {{{"parameter", "m"}, {"without", "static loads"}, {"shift", -0.0548}, {"in_sd_of_noise", 15}}}}}}};
  EXPECT_THAT(IntervalBasisHtml({m}, result, OverviewOf(result)),
              AllOf(HasSubstr("Parts of the data (octaves)"), HasSubstr("intervals would be 4.9 times narrower"),
                    HasSubstr("Measure or free these held parameters: kt for <code>m</code>"),
                    HasSubstr("would change by \u22125.3 %")));
  EXPECT_EQ(IntervalBasisHtml({Known()}, nlohmann::json::object(), {}), "");
}

// One remedy is said once, however many parameters and parts of the data it is for.
TEST(IntervalBasis, GroupsParametersByWhatWouldNarrowThem) {
  std::vector<ReportedParameter> parameters(4, Known());
  constexpr const char* kNames[] = {"m", "k", "c", "kt"};
  constexpr const char* kLimits[] = {"model: struts", "noise", "model: struts", "model: 8.0 .. 16 Hz"};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    parameters[i].name = kNames[i];
    parameters[i].limited_by = kLimits[i];
  }
  const std::string html = IntervalBasisHtml(parameters, {{"intervals", {{"model_error", false}}}}, {});
  EXPECT_THAT(html, AllOf(HasSubstr("struts for <code>m</code>, <code>c</code></li>"),
                          HasSubstr("8.0 to 16 Hz for <code>kt</code></li>"),
                          HasSubstr("Measure longer or more often: <code>k</code>")));
  const std::string remedy = "if they are right, add to the model";
  EXPECT_EQ(html.find(remedy), html.rfind(remedy));
}

TEST(ParameterTable, CallsWhatIsAsWideAsItsValueNotDetermined) {
  ReportedParameter wide = Known();
  wide.sd = 120;
  wide.state = ParameterState::kUndetermined;
  EXPECT_THAT(ParameterTableHtml({wide}, ""), AllOf(HasSubstr("not determined"), Not(HasSubstr("weakly"))));
}

TEST(ParameterTable, SaysHowMuchOfADeviationIsThatOfHeldOnes) {
  ReportedParameter wide = Known();
  wide.limited_by = "held: kt";
  wide.held_factor = 4;
  EXPECT_THAT(ParameterTableHtml({wide}, ""),
              HasSubstr("limited by the held kt (4.0 times smaller if that were known)"));
  wide.held_factor = 1.2;
  EXPECT_THAT(ParameterTableHtml({wide}, ""), Not(HasSubstr("if that were known")));
}

TEST(ParameterTable, DoesNotCallDeterminedWhatABoundHolds) {
  ReportedParameter held = Known();
  held.value = 50;
  held.lower_95 = 48;
  held.upper_95 = 52;
  held.at_bound = true;
  EXPECT_THAT(ParameterTableHtml({held}, ""), AllOf(HasSubstr("held by its bound"), Not(HasSubstr("well determined")),
                                                    HasSubstr("class=\"interval below\"")));
  held.sd = HUGE_VAL;
  EXPECT_THAT(ParameterTableHtml({held}, ""), HasSubstr("not determined, at its lower bound"));
}

TEST(ParameterTable, SaysWhyAParameterHasNoDeviation) {
  ReportedParameter held = Known();
  held.value = held.upper;
  held.at_bound = true;
  held.state = ParameterState::kAtBound;
  held.sd = held.lower_95 = held.upper_95 = NAN;
  EXPECT_THAT(ParameterTableHtml({held}, ""),
              AllOf(HasSubstr("held by its upper bound"), HasSubstr(">sd"), Not(HasSubstr("at its upper bound")),
                    Not(HasSubstr("not determined")), Not(HasSubstr("\u00b1"))));
  held.at_bound = false;
  held.state = ParameterState::kNoise;
  EXPECT_THAT(ParameterTableHtml({held}, ""),
              AllOf(HasSubstr("derivative is noise"), Not(HasSubstr("determined")), Not(HasSubstr("\u00b1"))));
}

TEST(ParameterTable, HasNoColumnsOfDeviationsThatNothingTells) {
  ReportedParameter unknown = Known();
  unknown.sd = unknown.lower_95 = unknown.upper_95 = NAN;
  EXPECT_THAT(ParameterTableHtml({unknown}, "Stopped <early>."),
              AllOf(Not(HasSubstr("\u00b1")), Not(HasSubstr(">sd")), HasSubstr("Stopped &lt;early&gt;.")));
  // Of one among others a dash.
  EXPECT_THAT(ParameterTableHtml({Known(), unknown}, ""),
              AllOf(HasSubstr(">sd"), HasSubstr("<td class=\"n pm\">\u2013</td>")));
}

}  // namespace
}  // namespace fourpost::parameter_table_test
