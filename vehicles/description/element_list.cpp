#include "vehicles/description/element_list.h"

#include <array>
#include <cmath>
#include <utility>

#include "analysis/text/units.h"

namespace fourpost {
namespace {

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

/// Lists the numbers of one element after the other.
class NumberList {
 public:
  void Begin(std::string element, int line) {
    element_ = std::move(element);
    line_ = line;
  }

  /// The number in an attribute of the tag with this path.
  void Add(const std::string& noun, const char* path, const char* attribute, const Scalar& number,
           bool is_linear = true) {
    numbers_.push_back({element_, noun, line_, path, attribute, number, is_linear});
  }

  /// A number that only bends the law.
  void AddBend(const std::string& noun, const char* path, const char* attribute, const Scalar& number) {
    Add(noun, path, attribute, number, false);
  }

  std::vector<ElementNumber> numbers() && { return std::move(numbers_); }

 private:
  std::string element_;
  int line_ = 0;
  std::vector<ElementNumber> numbers_;
};

void AddSpring(const Spring& spring, NumberList& list) {
  list.Begin(spring.Element(), spring.source_line);
  if (spring.kind == Spring::Kind::kGas) {
    list.Add("force", "fp:damper/gas", "force", *spring.preload);
    list.Add("stiffness", "fp:damper/gas", "stiffness", spring.law.stiffness);
    return;
  }
  if (spring.kind == Spring::Kind::kCoil) {
    if (spring.law.table.empty()) {
      list.Add("stiffness", "fp:spring/linear", "stiffness", spring.law.stiffness);
      list.AddBend("cubic", "fp:spring/cubic", "cubic", spring.law.cubic);
    } else {
      list.Add("place in the table", "fp:spring/table", "at", spring.law.place);
    }
    for (const SpringDescription::TablePoint& point : spring.law.table) {
      list.Add("extension in the table", "fp:spring/table/point", "extension", point.extension);
      list.Add("force in the table", "fp:spring/table/point", "force", point.force);
    }
    if (spring.preload) list.Add("preload", "fp:spring/linear", "preload", *spring.preload);
    if (spring.free_length) list.Add("free_length", "fp:spring/linear", "free_length", *spring.free_length);
  }
  std::array<int, 2> count{};
  for (const SpringDescription::Knee& knee : spring.law.knees) {
    const std::string side = knee.side < 0 ? "bump" : "rebound";
    if (knee.adds) {
      const char* path = knee.side < 0 ? "fp:stop/bump" : "fp:stop/rebound";
      list.AddBend(side + " gap", path, "gap", knee.at);
      list.AddBend(side + " stiffness", path, "stiffness", knee.rate);
      list.AddBend(side + " cubic", path, "cubic", knee.cubic);
    } else {
      const std::string which = side + " knee " + std::to_string(++count[knee.side < 0 ? 0 : 1]);
      list.AddBend("place of " + which, "fp:spring/multirate/knee", "at", knee.at);
      list.AddBend("stiffness beyond " + which, "fp:spring/multirate/knee", "stiffness", knee.rate);
    }
  }
}

void AddHydraulic(const HydraulicDescription& oil, NumberList& list) {
  constexpr const char* kPath = "fp:damper/hydraulic";
  for (const auto& [attribute, number] :
       {std::pair("bleed", oil.bleed), std::pair("rebound_valve", oil.rebound_valve),
        std::pair("bump_valve", oil.compression_valve), std::pair("bulk_modulus", oil.bulk_modulus),
        std::pair("piston", oil.piston_diameter), std::pair("rod", oil.rod_diameter),
        std::pair("rebound_column", oil.rebound_column), std::pair("bump_column", oil.compression_column),
        std::pair("gas_pressure", oil.gas_pressure), std::pair("gas_volume", oil.gas_volume),
        std::pair("gas_exponent", oil.gas_exponent), std::pair("density", oil.density),
        std::pair("cavitation", oil.cavitation)})
    list.AddBend(attribute, kPath, attribute, number);
}

void AddDashpot(const DashpotDescription& law, NumberList& list) {
  using Kind = DashpotDescription::Kind;
  if (law.kind == Kind::kCurve)
    for (const DashpotDescription::Segment& segment : law.segments) {
      list.AddBend("speed of a segment", "fp:damper/curve/segment", "to", segment.to);
      list.AddBend("rate of a segment", "fp:damper/curve/segment", "rate", segment.rate);
    }
  else if (law.kind == Kind::kTable)
    for (const DashpotDescription::TablePoint& point : law.table) {
      list.AddBend("speed in the table", "fp:damper/table/point", "speed", point.speed);
      list.AddBend("force in the table", "fp:damper/table/point", "force", point.force);
    }
  else {
    list.Add("bump rate", "fp:damper/bilinear", "bump", law.compression);
    list.Add("rebound rate", "fp:damper/bilinear", "rebound", law.rebound);
  }
  if (law.kind == Kind::kSmooth) list.AddBend("speed of transition", "fp:damper/smooth", "speed", law.transition);
  if (law.kind == Kind::kSaturating) {
    list.AddBend("bump speed", "fp:damper/saturating", "bump_speed", law.compression_knee.speed);
    list.AddBend("rebound speed", "fp:damper/saturating", "rebound_speed", law.rebound_knee.speed);
  }
  if (law.kind == Kind::kDigressive) {
    constexpr const char* kPath = "fp:damper/digressive";
    list.AddBend("bump knee", kPath, "bump_knee", law.compression_knee.speed);
    list.AddBend("rebound knee", kPath, "rebound_knee", law.rebound_knee.speed);
    list.AddBend("bump rate beyond the knee", kPath, "bump_beyond", law.compression_knee.rate);
    list.AddBend("rebound rate beyond the knee", kPath, "rebound_beyond", law.rebound_knee.rate);
  }
}

void AddDamper(const Damper& damper, NumberList& list) {
  list.Begin(Called("fp:damper", damper.name), damper.source_line);
  if (damper.hydraulic) AddHydraulic(*damper.hydraulic, list);
  else AddDashpot(damper.law, list);
  if (damper.law.friction) {
    list.AddBend("friction", "fp:damper/friction", "force", damper.law.friction->force);
    if (damper.law.Sticks())
      list.AddBend("friction stiffness", "fp:damper/friction", "stiffness", *damper.law.friction->stiffness);
    else list.AddBend("friction speed", "fp:damper/friction", "speed", damper.law.friction->speed);
  }
  if (damper.series) {
    list.Add("series stiffness", "fp:damper/series", "stiffness", damper.series->stiffness);
    list.AddBend("series cubic", "fp:damper/series", "cubic", damper.series->cubic);
  }
}

void AddBushing(const Bushing& bushing, NumberList& list) {
  list.Begin(Called("fp:bushing", bushing.name), bushing.source_line);
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis = kAxes[k];
    list.Add("stiffness along " + axis, "fp:bushing/translation", kAxes[k], bushing.stiffness[k]);
    list.Add("stiffness about " + axis, "fp:bushing/rotation", kAxes[k], bushing.stiffness[k + 3]);
    list.Add("damping along " + axis, "fp:bushing/translation_damping", kAxes[k], bushing.damping[k]);
    list.Add("damping about " + axis, "fp:bushing/rotation_damping", kAxes[k], bushing.damping[k + 3]);
  }
  list.Add("loss factor", "fp:bushing/loss", "factor", bushing.loss_factor);
}

void AddTyre(const Tyre& tyre, NumberList& list) {
  list.Begin(Called("fp:tyre", tyre.name), tyre.source_line);
  const auto add = [&](const char* noun, const char* attribute, const Scalar& number) {
    list.Add(noun, "fp:tyre", attribute, number);
  };
  if (tyre.law.table.empty()) {
    add("stiffness", "stiffness", tyre.law.stiffness);
    add("progression", "progression", tyre.law.progression);
  }
  for (const TyreDescription::TablePoint& point : tyre.law.table) {
    list.Add("deflection in the table", "fp:tyre/table/point", "deflection", point.deflection);
    list.Add("force in the table", "fp:tyre/table/point", "force", point.force);
  }
  add("damping", "damping", tyre.damping);
  add("lateral stiffness", "lateral", tyre.lateral);
  add("longitudinal stiffness", "longitudinal", tyre.longitudinal);
  add("lateral damping", "lateral_damping", tyre.lateral_damping);
  add("longitudinal damping", "longitudinal_damping", tyre.longitudinal_damping);
  add("radius", "radius", {.value = tyre.radius});
  if (tyre.preload) add("preload", "preload", *tyre.preload);
}

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
  for (const Spring& spring : vehicle.springs) AddLine(spring.Element(), spring.source_line, spring.line, points);
  for (const Damper& damper : vehicle.dampers)
    AddLine(Called("fp:damper", damper.name), damper.source_line, damper.line, points);
  for (const Actuator& actuator : vehicle.actuators)
    AddLine(Called("fp:actuator", actuator.name), actuator.source_line, actuator.line, points);
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
  NumberList list;
  for (const Link& link : vehicle.links) {
    list.Begin(Called("link", link.name), link.line);
    list.Add("mass", "link/inertial/mass", "value", link.mass);
  }
  for (const Spring& spring : vehicle.springs) AddSpring(spring, list);
  for (const Damper& damper : vehicle.dampers) AddDamper(damper, list);
  for (const Bushing& bushing : vehicle.bushings) AddBushing(bushing, list);
  for (const AntiRollBar& bar : vehicle.antiroll_bars) {
    list.Begin(Called("fp:antiroll", bar.name), bar.source_line);
    list.Add("stiffness", "fp:antiroll", "stiffness", bar.stiffness);
    list.Add("damping", "fp:antiroll", "damping", bar.damping);
  }
  for (const Tyre& tyre : vehicle.tyres) AddTyre(tyre, list);
  for (const Post& post : vehicle.posts) {
    list.Begin(Called("fp:post", post.name), post.source_line);
    if (post.stroke) list.Add("stroke", "fp:post", "stroke", {.value = *post.stroke});
  }
  for (const Sensor& sensor : vehicle.sensors) {
    list.Begin(Called("fp:sensor", sensor.name), sensor.source_line);
    if (sensor.type == Sensor::Type::kLoadCell) list.Add("wheelpan", "fp:sensor", "wheelpan", sensor.wheelpan);
  }
  return std::move(list).numbers();
}

std::vector<bool> AreInCurvedLaws(const Vehicle& vehicle) {
  std::vector<bool> are(vehicle.parameters.size());
  for (const ElementNumber& item : NumbersOf(vehicle))
    if (!item.is_linear && item.number.parameter >= 0) are[static_cast<std::size_t>(item.number.parameter)] = true;
  return are;
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
