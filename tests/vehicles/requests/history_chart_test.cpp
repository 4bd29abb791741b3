#include "vehicles/requests/history_chart.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <tinyxml2.h>

namespace fourpost::history_chart_test {
namespace {

using testing::HasSubstr;

HistoryChannel Burst(const std::string& name, Eigen::Index count) {
  HistoryChannel channel{.name = name, .unit = "m", .values = Eigen::VectorXd::Zero(count)};
  for (Eigen::Index k = 0; k < count; ++k) channel.values[k] = 0.01 * std::sin(0.1 * static_cast<double>(k));
  channel.values[count / 2] = -0.07;
  return channel;
}

TEST(HistoryChart, ShowsEachChannelWithItsSize) {
  const std::string svg = HistorySvg("quarter_car", "step", 0, 500, {Burst("post", 30000), Burst("s_strut", 30000)});
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_THAT(svg, HasSubstr("post [mm]"));
  EXPECT_THAT(svg, HasSubstr("s_strut [mm]"));
  EXPECT_THAT(svg, HasSubstr("peak 70"));
  // All channels show the second of the bursts, halfway.
  EXPECT_TRUE(svg.find("29.5 to 30.5 s") != std::string::npos);
  // 30000 samples as slices.
  EXPECT_LT(svg.size(), 150000u);
}

TEST(HistoryChart, ShowsWhatRestsAndWhatIsShort) {
  HistoryChannel rest{.name = "rest", .unit = "N", .values = Eigen::VectorXd::Zero(10)};
  EXPECT_THAT(HistorySvg("car", "", 3, 500, {rest}), HasSubstr("rest [kN]"));
}

TEST(HistoryChart, RefusesNothing) {
  EXPECT_THROW(HistorySvg("car", "", 0, 500, {}), std::invalid_argument);
  HistoryChannel one{.name = "one", .unit = "N", .values = Eigen::VectorXd::Zero(1)};
  EXPECT_THROW(HistorySvg("car", "", 0, 500, {one}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::history_chart_test
