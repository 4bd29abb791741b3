#include "analysis/charts/svg_chart.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "tests/rounding.h"

namespace fourpost::svg_chart_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A panel is 188 px wide and 116 px high; here 10 and 4 units.
SvgPanel Panel(SvgMark mark, std::vector<double> x, std::vector<double> y) {
  SvgPanel panel{.x = {.lower = 0, .upper = 10, .ticks = {0, 5, 10}}, .y = {.lower = 0, .upper = 4, .ticks = {0, 4}}};
  panel.series = {{.style = {.label = "s", .color = "#123456", .mark = mark}, .x = std::move(x), .y = std::move(y)}};
  return panel;
}

SvgSheet Sheet(const SvgPanel& panel) {
  return {.title = "Sheet", .columns = {"column"}, .rows = {{.title = "row", .panels = {panel}}}};
}

std::string Text(const SvgPanel& panel) { return SvgText(Sheet(panel)); }

TEST(SvgChart, DrawsDotsWhereTheyBelong) {
  // Half of 188 px from the left, three quarters of 116 px from the top; then the upper right corner.
  EXPECT_THAT(Text(Panel(SvgMark::kDots, {5, 10}, {1, 4})), HasSubstr("d=\"M94 87h0M188 0h0\""));
}

TEST(SvgChart, RoundsToATenthOfAPixel) {
  EXPECT_THAT(Text(Panel(SvgMark::kLine, {0, 1, 1.0 / 3}, {0, 4, 3.1})), HasSubstr("d=\"M0 116L18.8 0L6.3 26.1\""));
}

TEST(SvgChart, PlacesByTheLogarithmOnALogarithmicAxis) {
  SvgPanel panel = Panel(SvgMark::kLine, {1, 10, 0, 100}, {0, 0, 0, 4});
  panel.x = {.lower = 1, .upper = 100, .logarithmic = true};
  EXPECT_THAT(Text(panel), HasSubstr("d=\"M0 116L94 116M188 0\""));
}

TEST(SvgChart, InterruptsTheLineAtWhatIsNotFinite) {
  const std::string text = Text(Panel(SvgMark::kLine, {0, 5, 5, 5, 10, kNan, 10}, {0, 0, kNan, 0, 4, 4, -kInfinity}));
  EXPECT_THAT(text, HasSubstr("d=\"M0 116L94 116M94 116L188 0\""));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(SvgChart, DrawsTheGridThroughTheTicksAndLabelsThem) {
  const std::string text = Text(Panel(SvgMark::kDots, {}, {}));
  EXPECT_THAT(text, HasSubstr("d=\"M0 0V116M94 0V116M188 0V116M0 116H188M0 0H188\""));
  for (const char* label : {">0</text>", ">5</text>", ">10</text>", ">4</text>"}) EXPECT_THAT(text, HasSubstr(label));
}

TEST(SvgChart, ShadesBothSidesOfTheClearBand) {
  SvgPanel panel = Panel(SvgMark::kDots, {}, {});
  EXPECT_THAT(Text(panel), Not(HasSubstr("#ececec")));
  panel.clear_lower = 2.5;
  panel.clear_upper = 7.5;
  EXPECT_THAT(Text(panel), HasSubstr("<rect x=\"0\" y=\"0\" width=\"47\" height=\"116\" fill=\"#ececec\"/>"));
  EXPECT_THAT(Text(panel), HasSubstr("<rect x=\"141\" y=\"0\" width=\"47\" height=\"116\" fill=\"#ececec\"/>"));
}

TEST(SvgChart, IsWellFormedWhateverItsTexts) {
  const std::string odd = "a & b < c > d \"e\" 'f'";
  SvgSheet sheet = Sheet(Panel(SvgMark::kLine, {0, 1}, {0, 1}));
  sheet.title = sheet.note = sheet.x_label = odd + '\x01';
  sheet.columns = {odd};
  sheet.legend = {{.label = odd, .color = "#000", .mark = SvgMark::kDots}};
  sheet.rows[0].title = sheet.rows[0].note = odd;
  const std::string text = SvgText(sheet);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  EXPECT_STREQ(document.RootElement()->FirstChildElement("title")->GetText(), (odd + ' ').c_str());
  EXPECT_THAT(text, HasSubstr("a &amp; b &lt; c &gt; d "));
}

TEST(SvgChart, HasAWhiteGroundOfTheSizeOfTheSheet) {
  SvgSheet sheet = Sheet(Panel(SvgMark::kLine, {}, {}));
  tinyxml2::XMLDocument one;
  one.Parse(SvgText(sheet).c_str());
  const tinyxml2::XMLElement* ground = one.RootElement()->FirstChildElement("rect");
  EXPECT_STREQ(ground->Attribute("fill"), "#fff");
  EXPECT_STREQ(ground->Attribute("height"), one.RootElement()->Attribute("height"));

  sheet.rows.push_back(sheet.rows[0]);
  tinyxml2::XMLDocument two;
  two.Parse(SvgText(sheet).c_str());
  EXPECT_GT(two.RootElement()->DoubleAttribute("height"), one.RootElement()->DoubleAttribute("height") + 116);
}

double WidthOf(const SvgSheet& sheet) {
  tinyxml2::XMLDocument document;
  document.Parse(SvgText(sheet).c_str());
  return document.RootElement()->DoubleAttribute("width");
}

TEST(SvgChart, HasRoomForItsNoteItsLegendAndItsLabels) {
  SvgSheet sheet = Sheet(Panel(SvgMark::kLine, {}, {}));
  // Left, panel, and half of the last label at least.
  EXPECT_EQ(WidthOf(sheet), 38 + 188 + 16);
  sheet.note = std::string(100, 'x');
  EXPECT_EQ(WidthOf(sheet), 38 + 700);
  sheet.note = "";
  sheet.legend.assign(4, {.label = "one", .color = "#000"});
  EXPECT_EQ(WidthOf(sheet), 38 + 480);
  sheet.legend.clear();
  // Six letters at the right edge reach 21 px over it, and take 42 px left of a panel.
  sheet.rows[0].panels[0].x = {.lower = 0, .upper = 200000, .ticks = {0, 200000}};
  EXPECT_EQ(WidthOf(sheet), 38 + 188 + 23);
  sheet.rows[0].panels[0].y = {.lower = 0, .upper = 200000, .ticks = {0, 200000}};
  EXPECT_EQ(WidthOf(sheet), 52 + 188 + 23);
}

TEST(SvgChart, DrawsPanelsAndDotsOfAnySize) {
  SvgSheet sheet = Sheet(Panel(SvgMark::kDots, {5}, {1}));
  sheet.panel_width = 400;
  sheet.panel_height = 200;
  sheet.rows[0].panels[0].series[0].style.width = 5;
  EXPECT_THAT(SvgText(sheet), AllOf(HasSubstr("d=\"M200 150h0\""), HasSubstr("stroke-width=\"5\"")));
}

TEST(SvgChart, RefusesALogarithmicAxisThatIsNotPositive) {
  SvgPanel panel = Panel(SvgMark::kLine, {}, {});
  panel.x = {.lower = 0, .upper = 1, .logarithmic = true};
  EXPECT_THROW(Text(panel), std::invalid_argument);
}

TEST(SvgChart, RefusesAnAxisThatDoesNotIncrease) {
  SvgPanel panel = Panel(SvgMark::kLine, {}, {});
  panel.y = {.lower = 1, .upper = 1};
  EXPECT_THROW(Text(panel), std::invalid_argument);
}

TEST(SvgChart, RefusesASeriesOfUnlikeLengths) {
  EXPECT_THROW(Text(Panel(SvgMark::kLine, {1, 2}, {1})), std::invalid_argument);
}

TEST(SvgChart, RefusesARowThatDoesNotFitTheColumns) {
  SvgSheet sheet = Sheet(Panel(SvgMark::kLine, {}, {}));
  sheet.rows[0].panels.push_back(sheet.rows[0].panels[0]);
  EXPECT_THROW(SvgText(sheet), std::invalid_argument);
  EXPECT_THROW(SvgText({}), std::invalid_argument);
}

TEST(SvgChart, TitlesPanelsAndLetsTheLastRowEndEarly) {
  SvgPanel panel = Panel(SvgMark::kLine, {0, 1}, {0, 1});
  panel.title = "one";
  SvgPanel other = panel;
  other.title = "two";
  SvgSheet sheet{.title = "Sheet", .columns = {"a", "b"}, .rows = {{.panels = {panel, other}}, {.panels = {panel}}}};
  const std::string text = SvgText(sheet);
  EXPECT_THAT(text, HasSubstr(">one<"));
  // Over the second column.
  EXPECT_THAT(text, HasSubstr("<text x=\"264\" y=\"89\" fill=\"#222\"><tspan font-weight=\"bold\">two<"));
  // The note takes a line.
  sheet.note = "said";
  EXPECT_THAT(SvgText(sheet), HasSubstr("<text x=\"264\" y=\"109\" fill=\"#222\"><tspan font-weight=\"bold\">two<"));
  sheet.rows[1].panels = {panel, panel, panel};
  EXPECT_THROW(SvgText(sheet), std::invalid_argument);
}

}  // namespace
}  // namespace fourpost::svg_chart_test
