#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Charts over one quantity that a reader zooms together.
struct CurveGroup {
  struct Line {
    std::string label;
    /// NaN where there is nothing.
    std::vector<double> values;
  };
  struct Chart {
    std::string title;
    std::string unit;
    /// What the ordinate spans at least.
    double least = 0;
    std::vector<Line> lines;
    /// An ordinate over decades.
    bool is_logarithmic = false;
    /// The point of the ride whose weighted density the chart shows, which then follows the sliders; -1: none.
    int ride_point = -1;
  };

  /// Names it in the page.
  std::string id;
  /// Of what the charts are, for the names of files that a reader saves.
  std::string title;
  std::string x_name;
  std::string x_unit;
  std::vector<double> x;
  bool x_is_logarithmic = false;
  /// That its ride is on; without a class it is on none.
  std::string road_class;
  double speed = 0;
  std::vector<Chart> charts;
};

/// For the key `curves` of analysis/report/README.md.
nlohmann::ordered_json CurvesJson(const std::vector<CurveGroup>& groups);

/// Where a group is drawn, HTML. `file`: which one has its numbers, text.
std::string CurvesHtml(const CurveGroup& group, const std::string& file);

}  // namespace fourpost
