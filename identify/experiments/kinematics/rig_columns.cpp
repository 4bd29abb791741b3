#include "identify/experiments/kinematics/rig_columns.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/text/nearest.h"
#include "identify/experiments/kinematics/findings.h"

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

std::string JoinedNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

PositionKind PositionKindOf(const std::optional<KinematicSweep::Load>& load) {
  if (!load) return {"travel", kLength, "mm"};
  if (load->kind == WheelLoad::kAligning) return {"torque", kTorque, "N*m"};
  return {"force", kForce, "kN"};
}

RigColumns::RigColumns(const KinematicPlan& plan, const RecordedTable& table, const MeasuredAxles& axles,
                       Diagnostics& diagnostics)
    : plan_(plan), table_(table), axles_(axles), diagnostics_(diagnostics), columns_(KinematicColumns(table)) {
  const auto find = [&](std::initializer_list<const char*> names) -> std::optional<KinematicColumn> {
    for (const char* name : names)
      if (auto column = FindKinematicColumn(columns_, name, true)) return column;
    return std::nullopt;
  };
  axle_ = find({"axle"});
  motion_ = find({"motion", "travel", "load"});
  case_ = find({"case"});
  wheel_ = find({"wheel"});
  strut_ = find({"strut"});
  if (const auto load = LoadNamed(plan_.motion)) PositionOf(KinematicSweep::Load{*load, false});
  else if (!plan_.motion.empty()) PositionOf(std::nullopt);
  FindQuantities();
}

void RigColumns::Fault(const Finding& kind, const std::vector<std::string>& words) {
  diagnostics_.Report(kind, {plan_.study, plan_.line}, words);
  is_faulty_ = true;
}

/// The factor to SI of a column, by the study's unit or its own.
double RigColumns::FactorOf(const KinematicColumn& column, const std::string& unit, const Dimension& dimension,
                            const std::string& example) {
  const std::string text = unit.empty() ? column.unit : unit;
  const std::optional<Unit> known = ParseRecordedUnit(text);
  const bool is_pure = text.empty() && dimension == kDimensionless && example.empty();
  if (is_pure) return 1;
  const std::string written = table_.names()[column.index];
  if (text.empty() || !known || known->dimension != dimension) {
    Fault(kKinematicColumnUnit, {written, text.empty() ? "no unit" : "the unit '" + text + "'",
                                 example.empty() ? "none" : "one such as " + example, written, example});
    return 1;
  }
  return known->si;
}

std::optional<KinematicColumn> RigColumns::Named(const std::string& name) {
  for (const KinematicColumn& column : columns_)
    if (table_.names()[column.index] == name) return column;
  Fault(kKinematicChannelMissing, {plan_.file.filename().string(), name, DidYouMeanOrAll(name, table_.names())});
  return std::nullopt;
}

const PositionColumn* RigColumns::PositionOf(const std::optional<KinematicSweep::Load>& load) {
  const PositionKind kind = PositionKindOf(load);
  const auto [found, is_new] = positions_.try_emplace(kind.name);
  if (is_new) found->second = FindPosition(kind, load.has_value());
  return found->second ? &*found->second : nullptr;
}

std::optional<PositionColumn> RigColumns::FindPosition(const PositionKind& kind, bool is_load) {
  if (const auto& stated = plan_.position) {
    const auto column = Named(stated->name);
    if (!column) return std::nullopt;
    return PositionColumn{*column, stated->factor * FactorOf(*column, stated->unit, kind.dimension, kind.example)};
  }
  if (const auto column = FindKinematicColumn(columns_, kind.name, false))
    return PositionColumn{*column, FactorOf(*column, "", kind.dimension, kind.example)};
  if (const auto column = FindKinematicColumn(columns_, "per", true); column && is_load)
    return PositionColumn{*column, 1, true};
  Fault(kKinematicPositionMissing, {kind.name, kind.name, kind.example});
  return std::nullopt;
}

void RigColumns::Take(const KinematicColumn& column, const KinematicPlan::Noise& noise, const std::string& of,
                      const SourceChannel* source) {
  const KinematicQuantity& quantity = *noise.quantity;
  QuantityColumn read{.column = column, .noise = &noise, .of = of};
  read.factor = (source ? source->factor : 1) *
                FactorOf(column, source ? source->unit : "", quantity.dimension, std::string(quantity.unit));
  const bool is_of_row = quantity.of == Of::kWheel ? wheel_.has_value() : strut_.has_value();
  if (of.empty() && quantity.of != Of::kAxle && !is_of_row && !(quantity.of == Of::kWheel && axles_.HaveOneWheel()))
    Fault(kKinematicWheelOpen, {table_.names()[column.index], quantity.of == Of::kWheel ? "wheel" : "strut",
                                std::string(quantity.name), table_.names()[column.index]});
  quantities_.push_back(std::move(read));
}

const KinematicPlan::Noise* RigColumns::NoiseOf(const std::string& quantity) const {
  const auto found = std::find_if(plan_.noise.begin(), plan_.noise.end(),
                                  [&](const KinematicPlan::Noise& noise) { return noise.quantity->name == quantity; });
  return found == plan_.noise.end() ? nullptr : &*found;
}

void RigColumns::FindMapped() {
  for (const auto& [name, source] : plan_.channels) {
    const std::optional<QuantityName> parsed = ParseQuantityName(name);
    if (!parsed || !axles_.IsKnown(*FindKinematicQuantity(parsed->quantity), parsed->of)) {
      std::vector<std::string> legal;
      for (const KinematicPlan::Noise& noise : plan_.noise) legal.emplace_back(noise.quantity->name);
      diagnostics_.Report(kKinematicQuantityUnknown, {plan_.study, source.line}, {name, DidYouMeanOrAll(name, legal)});
      is_faulty_ = true;
      continue;
    }
    const KinematicPlan::Noise* noise = NoiseOf(parsed->quantity);
    if (!noise || source.channels.empty()) continue;
    if (const auto column = Named(source.channels.front().name))
      Take(*column, *noise, parsed->of, &source.channels.front());
  }
}

void RigColumns::FindNamed() {
  for (const KinematicColumn& column : columns_) {
    const std::optional<QuantityName> parsed = ParseQuantityName(column.name);
    const KinematicPlan::Noise* noise = parsed && !column.is_text ? NoiseOf(parsed->quantity) : nullptr;
    if (!noise || !axles_.IsKnown(*noise->quantity, parsed->of)) continue;
    const bool is_mapped = std::any_of(quantities_.begin(), quantities_.end(), [&](const QuantityColumn& read) {
      return read.noise == noise && (read.of == parsed->of || read.column.index == column.index);
    });
    if (!is_mapped) Take(column, *noise, parsed->of, nullptr);
  }
}

void RigColumns::FindQuantities() {
  FindMapped();
  FindNamed();
  for (const KinematicPlan::Noise& noise : plan_.noise)
    if (std::none_of(quantities_.begin(), quantities_.end(),
                     [&](const QuantityColumn& read) { return read.noise == &noise; }))
      LacksColumn(noise);
}

void RigColumns::LacksColumn(const KinematicPlan::Noise& noise) {
  const std::string name(noise.quantity->name);
  const char* of = noise.quantity->of == Of::kWheel ? "_left" : "";
  Fault(kKinematicQuantityMissing, {name, plan_.file.filename().string(), name + of, JoinedNames(table_.names())});
}

}  // namespace fourpost
