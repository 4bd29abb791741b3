#include "identify/report/methods_page.h"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>

#include "identify/comparison/methods_chart.h"

namespace fourpost::methods_page_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

MethodSummary Method(const std::string& name, std::int64_t successes, double expected, Interval interval) {
  MethodSummary method{.name = name,
                       .successes = successes,
                       .success_share = {0.5, 1},
                       .evaluations_mean = 12,
                       .expected_evaluations = expected,
                       .expected_interval = interval};
  for (int run = 0; run < 4; ++run)
    method.outcomes.push_back({.evaluations = 10 + 10 * run, .solved = run < successes, .cost = 1e-3});
  method.ends[SearchEnd::kEvaluations] = 4;
  return method;
}

Comparison Two() {
  return {.target_cost = 1,
          .parameters = 3,
          .residuals = 100,
          .methods = {Method("slow", 3, 90, {80, 100}), Method("<quick>", 4, 30, {28, 32})}};
}

TEST(MethodsPage, TellsWhichMethodIsCheapest) {
  EXPECT_THAT(
      MethodsPage(Two(), "car", "Solved: cost 1 or less.", false),
      AllOf(HasSubstr("<strong>&lt;quick&gt; solved it in 4 of 4 runs, at 30.0 evaluations per success</strong>; "
                      "next slow solved it in 3 of 4 runs, at 90.0 evaluations per success. Solved: cost 1"),
            HasSubstr("verdict good"), HasSubstr("3 parameters, 100 residuals"), Not(HasSubstr("<quick>")),
            Not(HasSubstr("processor,&nbsp;s"))));
}

TEST(MethodsPage, TellsMethodsApartOnlyWhereIntervalsDo) {
  Comparison comparison = Two();
  comparison.methods[0].expected_interval = {31, 100};
  EXPECT_THAT(MethodsPage(comparison, "car", "", true),
              AllOf(HasSubstr("these runs do not separate the two"), HasSubstr("processor,&nbsp;s")));
}

TEST(MethodsPage, ShowsThatNothingSolvedTheProblem) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  Comparison comparison = Two();
  comparison.methods = {Method("slow", 0, kNever, {kNever, kNever})};
  comparison.interrupted = true;
  EXPECT_THAT(MethodsPage(comparison, "car", "", false),
              AllOf(HasSubstr("verdict poor"), HasSubstr("No run of any method solved it"), Not(HasSubstr("<img")),
                    HasSubstr("Interrupted")));
}

// 1 of 4 runs at 10 evaluations, 3 of 4 at 30; the axis' ends are 20 % off the least and the most, 10 and 40.
TEST(MethodsSvg, StepsUpAtEachSuccess) {
  Comparison comparison = Two();
  comparison.methods.pop_back();
  const std::string svg = MethodsSvg("car", comparison);
  EXPECT_THAT(svg, AllOf(HasSubstr("slow"), HasSubstr("new evaluations")));
  // A line that starts, then goes to each corner of three steps and to the axis' end.
  const std::size_t line = svg.rfind("<path d=\"M");
  ASSERT_NE(line, std::string::npos) << svg;
  const std::string path = svg.substr(line + 9, svg.find('"', line + 9) - line - 9);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 2 * 3 + 1) << path;
}

}  // namespace
}  // namespace fourpost::methods_page_test
