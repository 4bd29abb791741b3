#include "vehicles/element_list.h"

#include <array>
#include <cmath>
#include <limits>

#include "analysis/units.h"

namespace fourpost {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

constexpr NumberKind kSpringRate{"stiffness", "N/m", 1e3, 1e6};
constexpr NumberKind kAnyRate{"stiffness", "N/m", 0, kAny};
constexpr NumberKind kBump{"compression rate", "N*s/m", 10, 1e5};
constexpr NumberKind kRebound{"rebound rate", "N*s/m", 10, 1e5};
constexpr NumberKind kSeriesRate{"series stiffness", "N/m", 10e3, 100e6};
constexpr NumberKind kTyreRate{"stiffness", "N/m", 20e3, 2e6};
constexpr NumberKind kTyreLateral{"lateral stiffness", "N/m", 0, kAny};
constexpr NumberKind kTyreLongitudinal{"longitudinal stiffness", "N/m", 0, kAny};
constexpr NumberKind kTyreLateralDamping{"lateral damping", "N*s/m", 0, 1e5};
constexpr NumberKind kTyreLongitudinalDamping{"longitudinal damping", "N*s/m", 0, 1e5};
constexpr NumberKind kTyreDamping{"damping", "N*s/m", 0, 1e5};
constexpr NumberKind kTyreRadius{"radius", "m", 0.1, 2};
constexpr NumberKind kBarDamping{"damping", "N*s/m", 0, kAny};
constexpr NumberKind kLinkMass{"mass", "kg", 1e-3, 1e5};
constexpr std::array<NumberKind, 6> kBushing = {{{"stiffness along x", "N/m", 0, 1e9},
                                                 {"stiffness along y", "N/m", 0, 1e9},
                                                 {"stiffness along z", "N/m", 0, 1e9},
                                                 {"stiffness about x", "N*m", 0, 1e9},
                                                 {"stiffness about y", "N*m", 0, 1e9},
                                                 {"stiffness about z", "N*m", 0, 1e9}}};

void AddLine(const std::string& element, int line, const ForceLine& ends, std::vector<ElementPoint>& points) {
  points.push_back({element, "parent's end", line, ends.parent});
  points.push_back({element, "child's end", line, ends.child});
}

template <typename Elements>
void AddEnds(const char* tag, const Elements& elements, std::vector<ElementPoint>& points) {
  for (const auto& element : elements) {
    points.push_back({Called(tag, element.name), "parent's end", element.source_line, element.parent});
    points.push_back({Called(tag, element.name), "child's end", element.source_line, element.child});
  }
}

bool IsCoil(const Spring& spring) { return spring.element.rfind("fp:spring", 0) == 0; }

/// Three digits.
double Rounded(double value) {
  if (value == 0) return 0;
  const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
  return step >= 1 ? std::round(value / step) * step : std::round(value / step) / std::round(1 / step);
}

}  // namespace

std::string Called(const char* tag, const std::string& name) { return std::string(tag) + " '" + name + "'"; }

std::vector<ElementPoint> PointsOf(const Vehicle& vehicle) {
  std::vector<ElementPoint> points;
  const std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    const Link& link = vehicle.links[i];
    if (link.mass.At(values) > 0)
      points.push_back(
          {Called("link", link.name), "centre of mass", link.line, {static_cast<int>(i), link.ComAt(values)}});
  }
  for (const Spring& spring : vehicle.springs) AddLine(spring.element, spring.source_line, spring.line, points);
  for (const Damper& damper : vehicle.dampers)
    AddLine(Called("fp:damper", damper.name), damper.source_line, damper.line, points);
  for (const AntiRollBar& bar : vehicle.antiroll_bars) {
    AddLine("the left line of " + Called("fp:antiroll", bar.name), bar.source_line, bar.left, points);
    AddLine("the right line of " + Called("fp:antiroll", bar.name), bar.source_line, bar.right, points);
  }
  for (const Tyre& tyre : vehicle.tyres)
    points.push_back({Called("fp:tyre", tyre.name), "centre", tyre.source_line, tyre.point});
  AddEnds("fp:bushing", vehicle.bushings, points);
  AddEnds("fp:rod", vehicle.rods, points);
  AddEnds("fp:ball", vehicle.balls, points);
  AddEnds("fp:weld", vehicle.welds, points);
  AddEnds("fp:hinge", vehicle.hinges, points);
  return points;
}

std::vector<ElementPoint> SensorPointsOf(const Vehicle& vehicle) {
  std::vector<ElementPoint> points;
  for (const Sensor& sensor : vehicle.sensors)
    if (sensor.type == Sensor::Type::kAccelerometer || sensor.type == Sensor::Type::kDisplacement)
      points.push_back({Called("fp:sensor", sensor.name), "point", sensor.source_line, sensor.point});
  return points;
}

std::vector<ElementNumber> NumbersOf(const Vehicle& vehicle) {
  std::vector<ElementNumber> numbers;
  for (const Link& link : vehicle.links)
    numbers.push_back({Called("link", link.name), link.line, kLinkMass, link.mass});
  for (const Spring& spring : vehicle.springs)
    numbers.push_back(
        {spring.element, spring.source_line, IsCoil(spring) ? kSpringRate : kAnyRate, spring.law.stiffness});
  for (const Damper& damper : vehicle.dampers) {
    const std::string element = Called("fp:damper", damper.name);
    numbers.push_back({element, damper.source_line, kBump, damper.law.compression});
    numbers.push_back({element, damper.source_line, kRebound, damper.law.rebound});
    if (damper.series) numbers.push_back({element, damper.source_line, kSeriesRate, damper.series->stiffness});
  }
  for (const Bushing& bushing : vehicle.bushings)
    for (std::size_t k = 0; k < kBushing.size(); ++k)
      numbers.push_back({Called("fp:bushing", bushing.name), bushing.source_line, kBushing[k], bushing.stiffness[k]});
  for (const AntiRollBar& bar : vehicle.antiroll_bars) {
    numbers.push_back({Called("fp:antiroll", bar.name), bar.source_line, kAnyRate, bar.stiffness});
    numbers.push_back({Called("fp:antiroll", bar.name), bar.source_line, kBarDamping, bar.damping});
  }
  for (const Tyre& tyre : vehicle.tyres) {
    const std::string element = Called("fp:tyre", tyre.name);
    numbers.push_back({element, tyre.source_line, kTyreRate, tyre.stiffness});
    numbers.push_back({element, tyre.source_line, kTyreDamping, tyre.damping});
    numbers.push_back({element, tyre.source_line, kTyreLateral, tyre.lateral});
    numbers.push_back({element, tyre.source_line, kTyreLongitudinal, tyre.longitudinal});
    numbers.push_back({element, tyre.source_line, kTyreLateralDamping, tyre.lateral_damping});
    numbers.push_back({element, tyre.source_line, kTyreLongitudinalDamping, tyre.longitudinal_damping});
    numbers.push_back({element, tyre.source_line, kTyreRadius, {.value = tyre.radius}});
  }
  return numbers;
}

std::string Readable(double si, const std::string& si_unit, const std::string& unit) {
  if (!unit.empty()) return FormatQuantity(Rounded(si), unit);
  const std::vector<std::string> larger = si_unit == "kg"  ? std::vector<std::string>{"g", "kg", "t"}
                                          : si_unit == "m" ? std::vector<std::string>{"mm", "m"}
                                          : si_unit[0] == 'N'
                                              ? std::vector<std::string>{si_unit, "k" + si_unit, "M" + si_unit}
                                              : std::vector<std::string>{si_unit};
  std::string best = larger.front();
  for (const std::string& candidate : larger)
    if (std::abs(si) >= ParseUnit(candidate)->si) best = candidate;
  return FormatQuantity(Rounded(si), best);
}

}  // namespace fourpost
