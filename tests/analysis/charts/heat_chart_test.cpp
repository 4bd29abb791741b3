#include "analysis/charts/heat_chart.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <tinyxml2.h>

namespace fourpost::heat_chart_test {
namespace {

using testing::HasSubstr;
using testing::Not;

HeatChart Map() {
  HeatChart chart{.title = "front & rear",
                  .note = "",
                  .x_label = "front",
                  .y_label = "rear",
                  .columns = {"1", "2", "3"},
                  .rows = {"a", "b"},
                  .cells = {{{.value = -1}, {.value = 0}, {.value = 4, .is_barred = true}},
                            {{.value = 1}, {.value = std::nan("")}, {.value = 2}}},
                  .value_label = "change, %",
                  .framed_label = "framed",
                  .barred_label = "barred",
                  .ring = HeatChart::Mark{"best", {0, 0}},
                  .cross = HeatChart::Mark{"now", {2, 1}}};
  return chart;
}

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(HeatChart, IsADocumentWithAColourPerCell) {
  const std::string svg = HeatSvg(Map());
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  EXPECT_THAT(svg, HasSubstr("front &amp; rear"));
  // The largest is orange, a quarter of it on the other side half blue; one without a number is none.
  EXPECT_THAT(svg, HasSubstr("width=\"34\" height=\"34\" fill=\"#d55e00\""));
  EXPECT_THAT(svg, HasSubstr("width=\"34\" height=\"34\" fill=\"#80b9d9\""));
  EXPECT_EQ(Count(svg, "width=\"34\" height=\"34\""), 5U);
  for (const char* label : {"best", "now", "framed", "barred", "change, %", "-1.00", "4.00"})
    EXPECT_THAT(svg, HasSubstr(">" + std::string(label) + "<"));
}

// Two neighbours are framed by six edges, not by eight.
TEST(HeatChart, FramesNeighboursTogether) {
  HeatChart chart = Map();
  EXPECT_THAT(HeatSvg(chart), Not(HasSubstr("v-34")));
  chart.cells[0][0].is_framed = true;
  chart.cells[0][1].is_framed = true;
  const std::string svg = HeatSvg(chart);
  EXPECT_EQ(Count(svg, "h34M") + Count(svg, "h34\""), 2U);
  EXPECT_EQ(Count(svg, "h-34"), 2U);
  EXPECT_EQ(Count(svg, "v34"), 1U);
  EXPECT_EQ(Count(svg, "v-34"), 1U);
}

TEST(HeatChart, RefusesWhatIsNoMap) {
  HeatChart chart = Map();
  chart.cells[1].pop_back();
  EXPECT_THROW(HeatSvg(chart), std::invalid_argument);
  chart = Map();
  chart.ring->place = {3, 0};
  EXPECT_THROW(HeatSvg(chart), std::invalid_argument);
  EXPECT_THROW(HeatSvg({}), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::heat_chart_test
