#include "vehicles/reader/law_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/units.h"
#include "vehicles/reader/findings.h"
#include "vehicles/tags/attribute_check.h"

namespace fourpost {
namespace {

Scalar Times(double factor, const Scalar& scalar) {
  return {.value = factor * scalar.value, .parameter = scalar.parameter, .factor = factor * scalar.factor};
}

/// A file that could not be read is reported there, and leaves a table without points.
bool HasFile(const Tag& table) { return AttributeText(*table.element, "file").has_value(); }

}  // namespace

std::optional<Tag> ChildOf(const Tag& tag, std::string_view name) {
  const std::vector<Tag> found = TagsOf(*tag.element, std::string(tag.rule->path) + "/" + std::string(name));
  if (found.empty()) return std::nullopt;
  return found.front();
}

SpringDescription LawReader::ReadSpring(const Tag& law) {
  if (law.rule->Name() == "table") return ReadSpringTable(law);
  SpringDescription description;
  description.stiffness = parameters_.ReadScalar(law, "stiffness");
  if (law.rule->Name() == "cubic") description.cubic = parameters_.ReadScalar(law, "cubic");
  if (law.rule->Name() == "multirate") ReadKnees(law, description);
  return description;
}

void LawReader::ReadKnees(const Tag& multirate, SpringDescription& law) {
  std::array<Scalar, 2> last;
  for (const Tag& tag : TagsOf(*multirate.element, "fp:spring/multirate/knee")) {
    const int errors = faults_.errors();
    const Scalar at = parameters_.ReadScalar(tag, "at");
    const int side = at.value < 0 ? -1 : 1;
    const SpringDescription::Knee knee{.side = side,
                                       .at = Times(side, at),
                                       .rate = parameters_.ReadScalar(tag, "stiffness"),
                                       .cubic = {},
                                       .adds = false};
    Scalar& before = last[side > 0 ? 1 : 0];
    if (faults_.errors() == errors && !parameters_.IsBelow(before, knee.at))
      faults_.Report(kKneeOrder, tag.Line("at"), {Quoted("at", tag)});
    before = knee.at;
    law.knees.push_back(knee);
  }
  if (law.knees.empty()) faults_.Report(kKneeNone, multirate.Line(), {Describe(*multirate.element)});
}

SpringDescription LawReader::ReadSpringTable(const Tag& table) {
  SpringDescription law{.stiffness = {}, .cubic = {}, .knees = {}, .table = {}, .place = {}};
  const int errors = faults_.errors();
  law.place = parameters_.ReadScalar(table, "at");
  law.is_placed = AttributeText(*table.element, "at").has_value();
  const Scalar scale = parameters_.ReadScalar(table, "scale");
  for (const Tag& tag : TagsOf(*table.element, "fp:spring/table/point")) {
    const int before = faults_.errors();
    const SpringDescription::TablePoint point{parameters_.ReadScalar(tag, "extension"), ReadForce(tag, table, scale)};
    if (faults_.errors() > before) continue;
    if (!law.table.empty() && (!parameters_.IsBelow(law.table.back().extension, point.extension) ||
                               !parameters_.IsBelow(law.table.back().force, point.force)))
      faults_.Report(kSpringPointOrder, tag.Line(), {tag.Text("extension"), Describe(*table.element)});
    law.table.push_back(point);
  }
  if (TagsOf(*table.element, "fp:spring/table/point").size() < 2 && !HasFile(table))
    faults_.Report(kSpringTablePoints, table.Line(), {Describe(*table.element)});
  if (faults_.errors() == errors && law.table.size() > 1) CheckPlace(table, law);
  return law;
}

TyreDescription LawReader::ReadTyre(const Tag& tyre) {
  TyreDescription law;
  const int errors = faults_.errors();
  const std::optional<Tag> table = ChildOf(tyre, "table");
  const bool has_stiffness = AttributeText(*tyre.element, "stiffness").has_value();
  if (has_stiffness) law.stiffness = parameters_.ReadScalar(tyre, "stiffness");
  law.progression = parameters_.ReadScalar(tyre, "progression");
  if (table) ReadTyreTable(*table, law);
  if (faults_.errors() > errors) return law;
  // A progression of zero is none.
  const char* other = has_stiffness ? "stiffness" : law.progression.IsZero() ? nullptr : "progression";
  if (table && other) faults_.Report(kTyreRateTwice, tyre.Line(other), {Describe(*tyre.element), Quoted(other, tyre)});
  const bool is_progressive = !table && !law.progression.IsZero();
  if (!table && (!has_stiffness || (is_progressive && !(parameters_.Least(law.stiffness) > 0))))
    faults_.Report(kTyreRateNone, tyre.Line("stiffness"), {Describe(*tyre.element)});
  if (!law.IsLinear() && tyre.Text("liftoff") == "false")
    faults_.Report(kTyreHeld, tyre.Line("liftoff"), {Describe(*tyre.element)});
  return law;
}

void LawReader::ReadTyreTable(const Tag& table, TyreDescription& law) {
  const Scalar scale = parameters_.ReadScalar(table, "scale");
  const std::vector<Tag> points = TagsOf(*table.element, "fp:tyre/table/point");
  for (const Tag& tag : points) {
    const int before = faults_.errors();
    const TyreDescription::TablePoint point{parameters_.ReadScalar(tag, "deflection"), ReadForce(tag, table, scale)};
    if (faults_.errors() > before) continue;
    if (!law.table.empty() && (!parameters_.IsBelow(law.table.back().deflection, point.deflection) ||
                               !parameters_.IsBelow(law.table.back().force, point.force)))
      faults_.Report(kTyrePointOrder, tag.Line(), {tag.Text("deflection"), Describe(*table.element)});
    law.table.push_back(point);
  }
  if (points.size() < 2 && !HasFile(table)) faults_.Report(kTyreTablePoints, table.Line(), {Describe(*table.element)});
}

/// The force of a point times the table's scale. One of them may follow a parameter.
Scalar LawReader::ReadForce(const Tag& point, const Tag& table, const Scalar& scale) {
  const Scalar force = parameters_.ReadScalar(point, "force");
  if (scale.parameter < 0) return scale.value == 1 ? force : Times(scale.value, force);
  if (force.parameter < 0) return Times(force.value, scale);
  faults_.Report(kScaleTwice, point.Line("force"), {Quoted("force", point), Quoted("scale", table)});
  return force;
}

/// Beyond its ends a table is a guess.
void LawReader::CheckPlace(const Tag& table, const SpringDescription& law) {
  // A file may state a free length: PlaceOnCurves() checks then.
  if (HasFile(table) && !AttributeText(*table.element, "at")) return;
  if (parameters_.Least(law.table.front().extension) <= parameters_.Least(law.place) &&
      parameters_.Greatest(law.place) <= parameters_.Greatest(law.table.back().extension))
    return;
  faults_.Report(kSpringTablePlace, table.Line("at"), {Quoted("at", table)});
}

SpringDescription LawReader::ReadStop(const Tag& stop) {
  SpringDescription law;
  for (const auto& [name, side] : {std::pair("bump", -1), std::pair("rebound", 1)})
    if (const std::optional<Tag> tag = ChildOf(stop, name))
      law.knees.push_back({.side = side,
                           .at = parameters_.ReadScalar(*tag, "gap"),
                           .rate = parameters_.ReadScalar(*tag, "stiffness"),
                           .cubic = parameters_.ReadScalar(*tag, "cubic"),
                           .adds = true});
  if (law.knees.empty()) faults_.Report(kStopEmpty, stop.Line(), {Describe(*stop.element)});
  return law;
}

DashpotDescription LawReader::ReadDashpot(const Tag& damper, const Tag& law, const std::optional<Tag>& series) {
  DashpotDescription dashpot;
  const int errors = faults_.errors();
  if (law.rule->Name() == "table") ReadTable(law, dashpot);
  else if (law.rule->Name() == "curve") ReadCurve(law, dashpot);
  else ReadRates(law, dashpot);
  dashpot.friction = ReadFriction(damper, series);
  if (series && faults_.errors() == errors) CheckInvertible(damper, *series, dashpot);
  return dashpot;
}

std::optional<DashpotDescription::Friction> LawReader::ReadFriction(const Tag& damper,
                                                                    const std::optional<Tag>& series) {
  const std::optional<Tag> tag = ChildOf(damper, "friction");
  if (!tag) return std::nullopt;
  DashpotDescription::Friction friction{parameters_.ReadScalar(*tag, "force"), parameters_.ReadScalar(*tag, "speed")};
  if (!AttributeText(*tag->element, "stiffness")) return friction;
  friction.stiffness = parameters_.ReadScalar(*tag, "stiffness");
  if (AttributeText(*tag->element, "speed"))
    faults_.Report(kFrictionSpeedAndStiffness, tag->Line("speed"), {Describe(*damper.element)});
  if (series) faults_.Report(kFrictionStiffnessSeries, tag->Line("stiffness"), {Describe(*damper.element)});
  return friction;
}

void LawReader::ReadRates(const Tag& law, DashpotDescription& dashpot) {
  if (law.rule->Name() == "linear") {
    dashpot.compression = dashpot.rebound = parameters_.ReadScalar(law, "rate");
    return;
  }
  dashpot.compression = parameters_.ReadScalar(law, "bump");
  dashpot.rebound = parameters_.ReadScalar(law, "rebound");
  if (law.rule->Name() == "smooth") {
    dashpot.kind = DashpotDescription::Kind::kSmooth;
    dashpot.transition = parameters_.ReadScalar(law, "speed");
  }
  if (law.rule->Name() == "saturating") {
    dashpot.kind = DashpotDescription::Kind::kSaturating;
    dashpot.compression_knee.speed = parameters_.ReadScalar(law, "bump_speed");
    dashpot.rebound_knee.speed = parameters_.ReadScalar(law, "rebound_speed");
  }
  if (law.rule->Name() == "digressive") {
    dashpot.kind = DashpotDescription::Kind::kDigressive;
    dashpot.compression_knee = {parameters_.ReadScalar(law, "bump_knee"), parameters_.ReadScalar(law, "bump_beyond")};
    dashpot.rebound_knee = {parameters_.ReadScalar(law, "rebound_knee"), parameters_.ReadScalar(law, "rebound_beyond")};
  }
}

void LawReader::ReadTable(const Tag& table, DashpotDescription& dashpot) {
  dashpot.kind = DashpotDescription::Kind::kTable;
  std::vector<Tag> tags;
  const Scalar scale = parameters_.ReadScalar(table, "scale");
  for (const Tag& tag : TagsOf(*table.element, "fp:damper/table/point")) {
    const int errors = faults_.errors();
    const DashpotDescription::TablePoint point{parameters_.ReadScalar(tag, "speed"), ReadForce(tag, table, scale)};
    if (faults_.errors() > errors) continue;
    dashpot.table.push_back(point);
    tags.push_back(tag);
  }
  if (TagsOf(*table.element, "fp:damper/table/point").size() < 2 && !HasFile(table))
    faults_.Report(kTablePoints, table.Line(), {Describe(*table.element)});
  const auto pushes = [this](const DashpotDescription::TablePoint& point) { return !Resists(point); };
  const auto is_at_rest = [this](const DashpotDescription::TablePoint& point) {
    return parameters_.Least(point.speed) == 0 && parameters_.Greatest(point.speed) == 0;
  };
  const auto all = std::count_if(dashpot.table.begin(), dashpot.table.end(), pushes);
  const auto at_rest = std::count_if(dashpot.table.begin(), dashpot.table.end(), is_at_rest);
  if (all > 1 && all + at_rest >= std::ssize(dashpot.table)) {
    faults_.Report(kTableSign, table.Line(), {Describe(*table.element)});
    return;
  }
  for (std::size_t i = 0; i < tags.size(); ++i) CheckPoint(table, tags[i], i, dashpot.table);
}

void LawReader::ReadCurve(const Tag& curve, DashpotDescription& dashpot) {
  dashpot.kind = DashpotDescription::Kind::kCurve;
  bool has_bump = false;
  bool has_rebound = false;
  for (const Tag& tag : TagsOf(*curve.element, "fp:damper/curve/segment")) {
    const int errors = faults_.errors();
    const DashpotDescription::Segment segment{parameters_.ReadScalar(tag, "to"), parameters_.ReadScalar(tag, "rate")};
    if (faults_.errors() > errors) return;
    const bool is_bump = parameters_.Greatest(segment.to) < 0;
    const bool is_rebound = parameters_.Least(segment.to) > 0;
    has_bump = has_bump || is_bump;
    has_rebound = has_rebound || is_rebound;
    if (!is_bump && !is_rebound) faults_.Report(kSegmentAtRest, tag.Line("to"), {Describe(*curve.element)});
    else if (!dashpot.segments.empty() && !parameters_.IsBelow(dashpot.segments.back().to, segment.to))
      faults_.Report(kSegmentOrder, tag.Line("to"), {tag.Text("to"), Describe(*curve.element)});
    dashpot.segments.push_back(segment);
  }
  if (!has_bump || !has_rebound) faults_.Report(kCurveOneSided, curve.Line(), {Describe(*curve.element)});
}

void LawReader::CheckPoint(const Tag& table, const Tag& tag, std::size_t i,
                           const std::vector<DashpotDescription::TablePoint>& points) {
  const auto fault = [&](const Finding& kind) {
    faults_.Report(kind, tag.Line(), {tag.Text("speed"), Describe(*table.element)});
  };
  if (!Resists(points[i])) fault(kPointSign);
  if (i == 0) return;
  if (!parameters_.IsBelow(points[i - 1].speed, points[i].speed) ||
      !parameters_.IsBelow(points[i - 1].force, points[i].force))
    fault(kPointOrder);
}

/// Whether the force never acts with the motion, nor at rest.
bool LawReader::Resists(const DashpotDescription::TablePoint& point) const {
  const double least = parameters_.Least(point.speed);
  const double greatest = parameters_.Greatest(point.speed);
  if (least > 0) return parameters_.Least(point.force) >= 0;
  if (greatest < 0) return parameters_.Greatest(point.force) <= 0;
  const bool is_origin = least == 0 && greatest == 0;
  return is_origin && parameters_.Least(point.force) == 0 && parameters_.Greatest(point.force) == 0;
}

/// Whether the force stays the same over some range of speed.
bool LawReader::CanStick(const DashpotDescription& dashpot) const {
  using Kind = DashpotDescription::Kind;
  const auto is_zero = [&](const Scalar& rate) { return parameters_.Least(rate) <= 0; };
  if (dashpot.kind == Kind::kTable) return false;
  if (dashpot.kind == Kind::kCurve)
    return std::any_of(dashpot.segments.begin(), dashpot.segments.end(),
                       [&](const DashpotDescription::Segment& segment) { return is_zero(segment.rate); });
  if (is_zero(dashpot.compression) || is_zero(dashpot.rebound)) return true;
  return dashpot.kind == Kind::kDigressive &&
         (is_zero(dashpot.compression_knee.rate) || is_zero(dashpot.rebound_knee.rate));
}

/// Least slope of the force over all speeds, wherever the rates' parameters go: it is concave in the rates, hence least
/// at a corner of their bounds.
double LawReader::LeastRate(const DashpotDescription& dashpot) const {
  std::vector<double> values = parameters_.Values();
  double least = dashpot.At(values).LeastRate();
  const auto set = [&](const Scalar& rate, bool to_upper) {
    if (rate.parameter < 0) return;
    const auto i = static_cast<std::size_t>(rate.parameter);
    values[i] = to_upper ? parameters_.parameters()[i].upper : parameters_.parameters()[i].lower;
  };
  for (unsigned corner = 0; corner < 4; ++corner) {
    set(dashpot.compression, (corner & 1U) != 0);
    set(dashpot.rebound, (corner & 2U) != 0);
    least = std::min(least, dashpot.At(values).LeastRate());
  }
  return least;
}

void LawReader::CheckInvertible(const Tag& damper, const Tag& series, const DashpotDescription& dashpot) {
  if (dashpot.kind == DashpotDescription::Kind::kSaturating) {
    faults_.Report(kSeriesSaturates, series.Line(), {Describe(*damper.element)});
    return;
  }
  if (CanStick(dashpot)) {
    faults_.Report(kSeriesWithoutRate, series.Line(), {Describe(*damper.element)});
    return;
  }
  // Through points that rise the curve rises everywhere.
  if (dashpot.kind == DashpotDescription::Kind::kCurve) return;
  try {
    if (LeastRate(dashpot) > 0) return;
  } catch (const std::invalid_argument&) {
    // A number is missing or its parameter is faulty, which is reported there.
    return;
  }
  faults_.Report(kSeriesNotRising, series.Line(), {Describe(*damper.element)});
}

SpringDescription LawReader::ReadSeries(const Tag& series) {
  return {.stiffness = parameters_.ReadScalar(series, "stiffness"),
          .cubic = parameters_.ReadScalar(series, "cubic"),
          .knees = {}};
}

HydraulicDescription LawReader::ReadHydraulic(const Tag& law) {
  const int errors = faults_.errors();
  const auto read = [&](std::string_view name) { return parameters_.ReadScalar(law, name); };
  HydraulicDescription damper{.bleed = read("bleed"),
                              .rebound_valve = read("rebound_valve"),
                              .compression_valve = read("bump_valve"),
                              .bulk_modulus = read("bulk_modulus"),
                              .piston_diameter = read("piston"),
                              .rod_diameter = read("rod"),
                              .rebound_column = read("rebound_column"),
                              .compression_column = read("bump_column"),
                              .gas_pressure = read("gas_pressure"),
                              .gas_volume = read("gas_volume"),
                              .gas_exponent = read("gas_exponent"),
                              .density = read("density"),
                              .cavitation = read("cavitation")};
  if (faults_.errors() > errors) return damper;
  if (!parameters_.IsBelow(damper.rod_diameter, damper.piston_diameter))
    faults_.Report(kRodThickness, law.Line("rod"), {Quoted("rod", law), law.Text("piston")});
  if (!parameters_.IsBelow(damper.cavitation, damper.gas_pressure))
    faults_.Report(kGasPressure, law.Line("gas_pressure"), {Quoted("gas_pressure", law), law.Text("cavitation")});
  return damper;
}

}  // namespace fourpost
