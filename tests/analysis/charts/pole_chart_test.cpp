#include "analysis/charts/pole_chart.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <tinyxml2.h>

namespace fourpost::pole_chart_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double kTurn = 2 * std::numbers::pi;

PoleChart Example() {
  return {.title = "Poles",
          .first = "1 N/m",
          .last = "2 N/m",
          .marked_value = "1.5 N/m",
          .marked = 1,
          .curves = {{"heave", {{-2, 1 * kTurn}, {-2, 2 * kTurn}, {-2, 3 * kTurn}}},
                     {"still <here>", {{-1, 5 * kTurn}, {-1, 5 * kTurn}, {-1, 5 * kTurn}}},
                     {"far", {{-1, 50 * kTurn}, {-1, 50 * kTurn}, {-1, 50 * kTurn}}}}};
}

int CirclesOf(const std::string& svg, const char* fill) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  int count = 0;
  for (auto* circle = document.RootElement()->FirstChildElement("circle"); circle;
       circle = circle->NextSiblingElement("circle"))
    if (std::string(circle->Attribute("fill")) == fill && circle->DoubleAttribute("cy") > 60) ++count;
  return count;
}

TEST(PoleChart, MarksWhereAPathStartsAndEnds) {
  const std::string svg = PoleSvg(Example());
  EXPECT_EQ(CirclesOf(svg, "#fff"), 1);
  EXPECT_EQ(CirclesOf(svg, "#0072B2"), 1);
  for (const char* text : {">heave<", ">1 N/m<", ">2 N/m<", ">1.5 N/m<", "damping ratio"})
    EXPECT_THAT(svg, HasSubstr(text));
}

TEST(PoleChart, NamesWhatStaysAndLeavesOutWhatIsFar) {
  const std::string svg = PoleSvg(Example());
  EXPECT_THAT(svg, HasSubstr("still &lt;here&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr(">far<")));
}

TEST(PoleChart, InterruptsAPathThatLeavesTheUpperHalf) {
  PoleChart chart = Example();
  const double none = std::numeric_limits<double>::quiet_NaN();
  chart.curves[0].pole[1] = {none, none};
  EXPECT_THAT(PoleSvg(chart), Not(HasSubstr("nan")));
}

TEST(PoleChart, RefusesWhatItCannotDraw) {
  PoleChart chart = Example();
  chart.curves[0].pole.pop_back();
  EXPECT_THROW(PoleSvg(chart), std::invalid_argument);
  EXPECT_THROW(PoleSvg({}), std::invalid_argument);
  chart = Example();
  chart.highest_Hz = 0.1;
  EXPECT_THROW(PoleSvg(chart), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::pole_chart_test
