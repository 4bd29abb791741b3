#include "identify/fit/profile_chart.h"

#include <algorithm>
#include <cmath>

#include "analysis/charts/svg_chart.h"
#include "analysis/text/units.h"
#include "identify/refine/fit_variables.h"

namespace fourpost {
namespace {

constexpr std::size_t kColumns = 3;

SvgStyle Line(const std::string& label, const std::string& color) {
  return {.label = label, .color = color, .mark = SvgMark::kLine};
}

const SvgStyle kFitted = Line("others fitted anew", "#0072B2");
const SvgStyle kParabola = Line("linear standard deviation", "#999999");
const SvgStyle kLevel = Line("95 %", "#D55E00");

const FittedParameter& Find(const FitResult& fit, const std::string& name) {
  return *std::find_if(fit.parameters.begin(), fit.parameters.end(),
                       [&](const FittedParameter& parameter) { return parameter.name == name; });
}

/// Rise by the linear deviation; of the logarithm where the lower bound is above zero, as in FitVariables.
double ParabolaAt(const FittedParameter& parameter, double value) {
  if (parameter.lower > 0) return std::pow(std::log(value / parameter.value) * parameter.value / parameter.noise_sd, 2);
  return std::pow((value - parameter.value) / parameter.noise_sd, 2);
}

SvgPanel Panel(const Profile& profile, const FittedParameter& parameter) {
  constexpr int kSegments = 60;
  const double si = ParseUnit(parameter.unit).value().si;
  SvgPanel panel;
  panel.title = profile.name + (parameter.unit.empty() ? "" : ", " + parameter.unit);
  SvgSeries fitted{.style = kFitted};
  for (const ProfilePoint& point : profile.points) {
    fitted.x.push_back(point.value / si);
    fitted.y.push_back(point.rise);
  }
  const double first = profile.points.front().value;
  const double last = profile.points.back().value;
  SvgSeries parabola{.style = kParabola};
  for (int k = 0; std::isfinite(parameter.noise_sd) && k <= kSegments; ++k) {
    const double value = first + (last - first) * k / kSegments;
    parabola.x.push_back(value / si);
    parabola.y.push_back(ParabolaAt(parameter, value));
  }
  SvgSeries level{.style = kLevel, .x = {first / si, last / si}, .y = {profile.threshold, profile.threshold}};
  SvgSeries dots = fitted;
  dots.style.mark = SvgMark::kDots;
  panel.series = {parabola, level, fitted, dots};
  panel.x = last > first ? LinearAxis(first / si, last / si, 4) : LinearAxis(first / si - 1, last / si + 1, 4);
  panel.y = LinearAxis(0, 2 * profile.threshold, 4);
  return panel;
}

}  // namespace

std::string ProfileSvg(const FitResult& fit) {
  SvgSheet sheet;
  sheet.title = "Profile likelihood";
  sheet.note =
      "Rise of the cost over the squared inflation of the standard deviations, with the parameter held and all others "
      "fitted";
  sheet.legend = {kFitted, kParabola, kLevel};
  sheet.columns = std::vector<std::string>(std::min(kColumns, fit.profiles.size()), "");
  for (std::size_t i = 0; i < fit.profiles.size(); ++i) {
    if (i % kColumns == 0) sheet.rows.emplace_back();
    sheet.rows.back().panels.push_back(Panel(fit.profiles[i], Find(fit, fit.profiles[i].name)));
  }
  return SvgText(sheet);
}

}  // namespace fourpost
