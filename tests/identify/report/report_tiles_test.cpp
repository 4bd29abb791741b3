#include "identify/report/report_tiles.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::report_tiles_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

ReportedParameter Known(const std::string& name, double value, double sd) {
  ReportedParameter parameter{.name = name, .unit = "kg", .value = value, .lower = 0, .upper = 10};
  parameter.state = std::isinf(sd) ? ParameterState::kUndetermined : ParameterState::kDetermined;
  parameter.sd = sd;
  return parameter;
}

TEST(ReportTiles, SayFourFiguresAndAWord) {
  const FitOverview overview{.verdict = "fair",
                             .misfit = 2.237,
                             .channels = {{.name = "a", .numbers = "0.1 dB"}, {.name = "<b>", .numbers = "5.3 dB"}},
                             .unseen = {{.name = "a"}, {.name = "b", .follows = Follows::kNot}}};
  // 5 %, 20 % and open.
  const std::vector<ReportedParameter> parameters = {Known("m", 2, 0.1), Known("k", 2, 0.4),
                                                     Known("c", 2, std::numeric_limits<double>::infinity())};
  EXPECT_THAT(TilesHtml(overview, parameters),
              AllOf(HasSubstr("tiles fair"), HasSubstr(">Fair<"), HasSubstr("<b>2.2</b>"),
                    HasSubstr("href=\"#responses\" data-worst=\"&lt;b&gt;\""), HasSubstr("5.3 dB"),
                    HasSubstr("<b>1<small> of 2</small></b>"), HasSubstr("<b>1<small> of 3</small></b>"),
                    HasSubstr("class=\"known\" title=\"m\""), HasSubstr("class=\"open\" title=\"k\"")));
}

TEST(ReportTiles, SayWhereTheWorstChannelIsWorst) {
  const FitOverview overview{.channels = {{.name = "s", .misfit = 5.88, .worst = WorstPlace{"pitch", 0.5, 1, 11.2}}}};
  EXPECT_THAT(TilesHtml(overview, {}),
              HasSubstr("5.9 times noise and stated model error; largest in pitch at 0.5\u20131 Hz"));
}

// A narrow range makes a small deviation, not a known value.
TEST(ReportTiles, CountNoParameterThatOnlyItsBoundsLimit) {
  ReportedParameter held = Known("m", 2, 0.1);
  held.state = ParameterState::kUndetermined;
  EXPECT_THAT(TilesHtml({.verdict = "open", .misfit = 1}, {held}),
              AllOf(HasSubstr("<b>0<small> of 1</small></b>"), HasSubstr(">Not finished<")));
}

TEST(ReportTiles, OfARunThatSaysNothingSayNothing) {
  EXPECT_THAT(TilesHtml({.verdict = "poor", .misfit = std::nan("")}, {}),
              AllOf(HasSubstr(">Poor<"), HasSubstr("no recording was kept"), HasSubstr("no intervals"),
                    HasSubstr("nothing was compared"), Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace fourpost::report_tiles_test
