#include "identify/report/curves_json.h"

#include "analysis/report/html.h"
#include "analysis/report/packed_values.h"
#include "analysis/report/picture_number.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Few at six digits, many packed.
OrderedJson ValuesJson(const std::vector<double>& values) {
  constexpr std::size_t kFew = 400;
  return values.size() > kFew ? PackedValues(values) : OrderedJson{{"values", PictureNumbers(values)}};
}

}  // namespace

OrderedJson CurvesJson(const std::vector<CurveGroup>& groups) {
  OrderedJson all = OrderedJson::object();
  for (const CurveGroup& group : groups) {
    OrderedJson charts = OrderedJson::array();
    for (const CurveGroup::Chart& chart : group.charts) {
      OrderedJson lines = OrderedJson::array();
      for (const CurveGroup::Line& line : chart.lines) {
        OrderedJson one = {{"label", line.label}};
        one.update(ValuesJson(line.values));
        lines.push_back(std::move(one));
      }
      charts.push_back(
          {{"title", chart.title}, {"unit", chart.unit}, {"least", chart.least}, {"lines", std::move(lines)}});
      if (chart.is_logarithmic) charts.back()["logarithmic"] = true;
      if (chart.ride_point >= 0) charts.back()["ride_point"] = chart.ride_point;
    }
    OrderedJson x = {{"name", group.x_name}, {"unit", group.x_unit}};
    if (group.x_is_logarithmic) x["logarithmic"] = true;
    x.update(ValuesJson(group.x));
    all[group.id] = {{"title", group.title}, {"x", std::move(x)}, {"charts", std::move(charts)}};
    if (!group.road_class.empty()) all[group.id].update({{"road", group.road_class}, {"speed", group.speed}});
  }
  return all;
}

std::string CurvesHtml(const CurveGroup& group, const std::string& file) {
  return html::Drawn("curves:" + html::Escaped(group.id),
                     "The charts need JavaScript; " + html::Escaped(file) + " has their numbers.");
}

}  // namespace fourpost
