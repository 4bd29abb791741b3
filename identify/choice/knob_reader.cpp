#include "identify/choice/knob_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/text/known_names.h"
#include "analysis/text/number.h"
#include "identify/choice/findings.h"
#include "identify/choice/position_table.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 4> kSources = {"table", "bench", "values", "range"};
constexpr std::size_t kMostPositions = 1000;

std::vector<std::string> ParameterNames(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (const Parameter& parameter : vehicle.parameters) names.push_back(parameter.name);
  return names;
}

std::string TextOf(const YAML::Node& node) { return node.IsScalar() ? node.Scalar() : ""; }

/// first, first + step, ... up to last, which counts where rounding alone keeps it out.
std::vector<double> Steps(double first, double last, double step) {
  const double count = std::floor((last - first) / step * (1 + 1e-12) + 1e-9);
  if (!(step > 0) || !(last > first) || !(count >= 1) || !(count < static_cast<double>(kMostPositions))) return {};
  std::vector<double> steps;
  for (int i = 0; i <= static_cast<int>(count); ++i) steps.push_back(first + i * step);
  return steps;
}

/// Reads one knob.
class KnobReader {
 public:
  KnobReader(std::string name, const StrictMap& map, const Vehicle& vehicle) : map_(map), vehicle_(vehicle) {
    knob_.name = std::move(name);
    knob_.line = map.line();
  }

  Knob Read() {
    ReadTargets();
    std::string given;
    for (const std::string_view source : kSources)
      if (map_.Has(source)) given += (given.empty() ? "'" : " and '") + std::string(source) + "'";
    if (given.empty() || given.find(" and ") != std::string::npos) {
      Fault(map_.Get("sets"), kKnobSource, {given.empty() ? "none" : given});
    } else if (map_.Has("table") || map_.Has("bench")) {
      ReadTable();
    } else {
      RequireEqualDimensions();
      map_.Has("range") ? ReadRange() : ReadValues();
    }
    if (!targets_.empty() && is_sound_ && knob_.positions.size() < 2) Fault(map_.Get("sets"), kKnobFew);
    RequireUniquePositions();
    ReadNow();
    ReadChange();
    if (is_sound_) CheckSigns();
    return std::move(knob_);
  }

 private:
  /// A parameter and what its number is made of: a factor, and of a table its column.
  struct Target {
    std::size_t parameter = 0;
    double factor = 1;
    std::string column;
    YAML::Node node;
  };

  void Fault(const YAML::Node& node, const Finding& finding, std::vector<std::string> words = {}) {
    is_sound_ = false;
    words.insert(words.begin(), knob_.name);
    map_.Fault(node, finding, words);
  }

  const Parameter& ParameterOf(const Target& target) const { return vehicle_.parameters[target.parameter]; }

  void AddTarget(const std::string& name, const std::string& what, const YAML::Node& node) {
    const std::vector<std::string> names = ParameterNames(vehicle_);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return Fault(node, kKnobParameter, {name, KnownNames(name, names)});
    Target target{
        .parameter = static_cast<std::size_t>(found - names.begin()), .factor = 1, .column = "", .node = node};
    const bool has_column = map_.Has("table") || map_.Has("bench");
    const std::size_t star = what.find('*');
    const std::string factor = has_column ? (star == std::string::npos ? "1" : what.substr(0, star)) : what;
    if (has_column) target.column = star == std::string::npos ? what : what.substr(star + 1);
    const std::optional<double> number = ParseNumber(factor);
    if (!number || !(*number > 0)) return Fault(node, kKnobFactor, {factor, name});
    target.factor = *number;
    targets_.push_back(target);
    knob_.parameters.push_back(target.parameter);
  }

  void ReadTargets() {
    const YAML::Node node = map_.Require("sets");
    if (!node.IsDefined()) {
      is_sound_ = false;
      return;
    }
    // Columns of a table are named as the parameters where nothing else is said.
    const bool has_column = map_.Has("table") || map_.Has("bench");
    const auto plain = [&](const YAML::Node& one) {
      if (one.IsScalar()) AddTarget(one.Scalar(), has_column ? one.Scalar() : "1", one);
      else Fault(one, kKnobSetsNothing);
    };
    if (node.IsScalar()) plain(node);
    else if (node.IsSequence())
      for (const YAML::Node& one : node) plain(one);
    else if (node.IsMap())
      for (const auto& entry : node) AddTarget(TextOf(entry.first), TextOf(entry.second), entry.second);
    if (targets_.empty() && is_sound_) Fault(node, kKnobSetsNothing);
  }

  void ReadTable() {
    const std::string key = map_.Has("table") ? "table" : "bench";
    const std::optional<std::string> path = map_.Text(key);
    std::optional<PositionTable> table;
    if (path) {
      const std::filesystem::path file = map_.Resolve(*path);
      table =
          key == "table" ? ReadPositionTable(file, map_.diagnostics()) : PositionTableOfRun(file, map_.diagnostics());
    }
    if (!table) {
      is_sound_ = false;
      return;
    }
    std::vector<std::size_t> columns;
    for (const Target& target : targets_) columns.push_back(ColumnOf(target, *table));
    if (!is_sound_) return;
    Knob::Bench bench{.run = table->file, .columns = columns, .factors = {}, .rows = {}};
    for (const Target& target : targets_) bench.factors.push_back(target.factor);
    for (const std::string& position : PositionsOf(*table)) {
      const std::optional<double> row = table->RowOf(position);
      if (!row) {
        Fault(map_.Get("positions"), kKnobOutside, {position, table->RangeText()});
        continue;
      }
      Knob::Position one{.name = position, .values = {}};
      for (std::size_t i = 0; i < targets_.size(); ++i)
        one.values.push_back(targets_[i].factor * table->At(columns[i], *row));
      knob_.positions.push_back(std::move(one));
      bench.rows.push_back(*row);
    }
    if (key == "bench") knob_.bench = std::move(bench);
  }

  std::size_t ColumnOf(const Target& target, const PositionTable& table) {
    const std::optional<std::size_t> column = table.FindColumn(target.column);
    std::vector<std::string> names;
    for (const PositionTable::Column& one : table.columns) names.push_back(one.name);
    if (!column) Fault(target.node, kKnobColumn, {target.column, KnownNames(target.column, names)});
    else if (table.columns[*column].dimension != ParameterOf(target).dimension)
      FaultOfUnit(target.node, "column '" + target.column + "'", target);
    return column.value_or(0);
  }

  void FaultOfUnit(const YAML::Node& node, const std::string& what, const Target& target) {
    const Dimension& dimension = ParameterOf(target).dimension;
    Fault(node, kKnobUnit, {what, DimensionName(dimension), ParameterOf(target).name, SiUnit(dimension)});
  }

  std::vector<std::string> PositionsOf(const PositionTable& table) {
    const YAML::Node node = map_.Get("positions");
    if (!node.IsDefined()) return table.rows;
    std::vector<std::string> positions;
    if (node.IsMap()) {
      const StrictMap range = map_.Map("positions", {"from", "to", "step"});
      const double step = range.Number("step", 1e-9, 1e9).value_or(1);
      for (const double at : Steps(range.Number("from", -1e9, 1e9).value_or(std::nan("")),
                                   range.Number("to", -1e9, 1e9).value_or(std::nan("")), step))
        positions.push_back(FormatNumber(std::round(at * 1e9) / 1e9));
    } else if (node.IsSequence()) {
      for (const YAML::Node& one : node) positions.push_back(TextOf(one));
    }
    if (positions.empty() || std::find(positions.begin(), positions.end(), "") != positions.end()) {
      Fault(node, kKnobPositions);
      return {};
    }
    return positions;
  }

  /// Without a table all parameters take the same numbers.
  void RequireEqualDimensions() {
    for (const Target& target : targets_)
      if (ParameterOf(target).dimension != ParameterOf(targets_.front()).dimension)
        FaultOfUnit(target.node, "what '" + ParameterOf(targets_.front()).name + "' takes", target);
  }

  void AddPosition(const std::string& name, double number) {
    Knob::Position one{.name = name, .values = {}};
    for (const Target& target : targets_) one.values.push_back(target.factor * number);
    knob_.positions.push_back(std::move(one));
  }

  std::optional<double> NumberOf(const YAML::Node& node) {
    if (targets_.empty()) return std::nullopt;
    const Parameter& parameter = ParameterOf(targets_.front());
    const std::optional<Quantity> quantity = ParseQuantity(TextOf(node));
    if (quantity && quantity->unit.dimension == parameter.dimension) return quantity->si;
    FaultOfUnit(node, "'" + TextOf(node) + "'", targets_.front());
    return std::nullopt;
  }

  void ReadRange() {
    const StrictMap range = map_.Map("range", {"from", "to", "step"});
    std::array<double, 3> numbers = {};
    std::size_t i = 0;
    for (const char* key : {"from", "to", "step"}) {
      const YAML::Node node = range.Require(key);
      numbers[i++] = node.IsDefined() ? NumberOf(node).value_or(std::nan("")) : std::nan("");
    }
    if (!is_sound_) return;
    const std::vector<double> steps = Steps(numbers[0], numbers[1], numbers[2]);
    if (steps.empty()) return Fault(map_.Get("range"), kKnobRange);
    const std::string unit = ParseQuantity(TextOf(range.Get("step")))->unit_text;
    for (const double at : steps) {
      // Without what adding steps rounds.
      const double unit_si = ParseUnit(unit.empty() ? "1" : unit)->si;
      const std::string name = FormatNumber(std::round(at / unit_si * 1e9) / 1e9) + (unit.empty() ? "" : ' ' + unit);
      AddPosition(name, ParseQuantity(name)->si);
    }
  }

  void ReadValues() {
    const YAML::Node node = map_.Get("values");
    if (node.IsSequence()) {
      for (const YAML::Node& one : node)
        if (const std::optional<double> number = NumberOf(one)) AddPosition(TextOf(one), *number);
    } else if (node.IsMap()) {
      for (const auto& entry : node)
        if (const std::optional<double> number = NumberOf(entry.second)) AddPosition(TextOf(entry.first), *number);
    } else {
      Fault(node, kKnobFew);
    }
  }

  void RequireUniquePositions() {
    std::set<std::string> names;
    for (const Knob::Position& position : knob_.positions)
      if (!names.insert(position.name).second) Fault(map_.Get("sets"), kKnobPositionTwice, {position.name});
  }

  void ReadNow() {
    const std::optional<std::string> now = map_.Text("now");
    if (!now || !is_sound_) return;
    std::vector<std::string> names;
    for (const Knob::Position& position : knob_.positions) names.push_back(position.name);
    const auto found = std::find(names.begin(), names.end(), *now);
    if (found == names.end()) return Fault(map_.Get("now"), kKnobNow, {*now, KnownNames(*now, names)});
    knob_.now = static_cast<std::size_t>(found - names.begin());
  }

  void ReadChange() {
    knob_.change = knob_.now ? Knob::Change::kRatio : Knob::Change::kAbsolute;
    const std::optional<std::string> change = map_.Text("change");
    if (!change) return;
    constexpr std::array<std::string_view, 3> kChanges = {"ratio", "difference", "absolute"};
    const auto found = std::find(kChanges.begin(), kChanges.end(), *change);
    if (found == kChanges.end())
      return Fault(map_.Get("change"), kKnobChange, {*change, SuggestLegal(*change, kChanges)});
    knob_.change = static_cast<Knob::Change>(found - kChanges.begin());
    if (knob_.change != Knob::Change::kAbsolute && !map_.Has("now"))
      Fault(map_.Get("change"), kKnobChangeWithoutNow, {*change});
  }

  /// No setting turns a spring into its opposite.
  void CheckSigns() {
    const std::vector<double> fitted = vehicle_.ParameterValues();
    for (std::size_t p = 0; p < knob_.positions.size(); ++p) {
      const std::vector<double> values = ValuesAt({knob_}, {static_cast<int>(p)}, fitted);
      for (const Target& target : targets_) {
        const Parameter& parameter = ParameterOf(target);
        const double value = values[target.parameter];
        if (value * parameter.value > 0 || value == parameter.value) continue;
        Fault(map_.Get("sets"), kKnobSign,
              {knob_.positions[p].name, parameter.name,
               std::isfinite(value) ? FormatQuantity(value, parameter.unit) : "no number",
               FormatQuantity(parameter.value, parameter.unit)});
      }
    }
  }

  const StrictMap& map_;
  const Vehicle& vehicle_;
  Knob knob_;
  std::vector<Target> targets_;
  bool is_sound_ = true;
};

void CheckSetOnce(const std::vector<Knob>& knobs, const Vehicle& vehicle, const StrictMap& top) {
  std::set<std::size_t> set;
  for (const Knob& knob : knobs)
    for (const std::size_t parameter : knob.parameters)
      if (!set.insert(parameter).second)
        top.diagnostics().Report(kKnobParameterTwice, {top.file(), knob.line},
                                 {knob.name, vehicle.parameters[parameter].name});
}

}  // namespace

std::vector<Knob> ReadKnobs(const StrictMap& top, const Vehicle& vehicle) {
  const YAML::Node node = top.Require("knobs");
  std::vector<Knob> knobs;
  if (!node.IsDefined()) return knobs;
  if (!node.IsMap() || node.size() == 0) {
    top.Fault(node, kKnobsNone);
    return knobs;
  }
  std::vector<std::string> names;
  for (const auto& entry : node) names.push_back(TextOf(entry.first));
  const StrictMap map = top.Map("knobs", {names.begin(), names.end()});
  for (const auto& entry : node) {
    const std::string name = TextOf(entry.first);
    const StrictMap one(entry.second, "knob '" + name + "'",
                        {"sets", "table", "bench", "positions", "values", "range", "now", "change"}, top.file(),
                        top.diagnostics());
    if (entry.second.IsMap()) knobs.push_back(KnobReader(name, one, vehicle).Read());
  }
  CheckSetOnce(knobs, vehicle, top);
  return knobs;
}

}  // namespace fourpost
