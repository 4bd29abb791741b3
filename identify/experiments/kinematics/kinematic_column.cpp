#include "identify/experiments/kinematics/kinematic_column.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_layout.h"
#include "identify/experiments/kinematics/kinematic_quantity.h"

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

constexpr std::array<std::string_view, 7> kUnitsInNames = {"deg", "rad", "mm", "m", "N", "kN", "Nm"};

/// By the first field that is not empty.
bool IsText(const RecordedTable& table, std::size_t index) {
  for (std::size_t row = 0; row < table.rows(index); ++row) {
    const std::optional<double> number = table.Number(row, index);
    if (!number || !std::isnan(*number)) return !number;
  }
  return false;
}

/// By name or by unit.
bool HasTimes(const RecordedTable& table) {
  if (IsTimeHistory(table)) return true;
  for (std::size_t i = 0; i < table.names().size(); ++i)
    if (const auto unit = ParseRecordedUnit(table.unit(i)); unit && unit->dimension == kTime) return true;
  return false;
}

bool IsTravel(const KinematicColumn& column) { return column.name == "travel" && !column.is_text; }

bool IsLoad(const KinematicColumn& column) {
  return column.name == "per" ? column.is_text : (column.name == "force" || column.name == "torque") && !column.is_text;
}

/// Null where a column holds none.
const KinematicQuantity* QuantityOf(const KinematicColumn& column) {
  const std::optional<QuantityName> name = ParseQuantityName(column.name);
  return name && !column.is_text ? FindKinematicQuantity(name->quantity) : nullptr;
}

KinematicColumn ColumnOf(const RecordedTable& table, std::size_t index) {
  KinematicColumn column{.index = index, .name = table.names()[index], .unit = table.unit(index)};
  const std::size_t mark = column.name.rfind('_');
  if (mark != std::string::npos) {
    const std::string end = column.name.substr(mark + 1);
    if (std::find(kUnitsInNames.begin(), kUnitsInNames.end(), end) != kUnitsInNames.end()) {
      column.name.resize(mark);
      if (column.unit.empty()) column.unit = end == "Nm" ? "N*m" : end;
    }
  }
  column.is_text = IsText(table, index);
  return column;
}

}  // namespace

std::vector<KinematicColumn> KinematicColumns(const RecordedTable& table) {
  std::vector<KinematicColumn> columns;
  for (std::size_t i = 0; i < table.names().size(); ++i) columns.push_back(ColumnOf(table, i));
  return columns;
}

std::optional<KinematicColumn> FindKinematicColumn(const std::vector<KinematicColumn>& columns, std::string_view name,
                                                   bool is_text) {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const KinematicColumn& column) {
    return column.name == name && column.is_text == is_text;
  });
  if (found == columns.end()) return std::nullopt;
  return *found;
}

std::optional<QuantityName> ParseQuantityName(const std::string& name) {
  for (const KinematicQuantity& quantity : KinematicQuantities()) {
    if (name == quantity.name) return QuantityName{name, ""};
    if (const std::string head = std::string(quantity.name) + "_"; name.starts_with(head))
      return QuantityName{std::string(quantity.name), name.substr(head.size())};
  }
  return std::nullopt;
}

bool HasRigPosition(const RecordedTable& table) {
  if (HasTimes(table)) return false;
  const std::vector<KinematicColumn> columns = KinematicColumns(table);
  return std::any_of(columns.begin(), columns.end(), IsTravel) || std::any_of(columns.begin(), columns.end(), IsLoad);
}

bool IsKinematicTable(const RecordedTable& table) {
  if (HasTimes(table)) return false;
  const std::vector<KinematicColumn> columns = KinematicColumns(table);
  const auto is_quantity = [](const KinematicColumn& column) {
    const KinematicQuantity* quantity = QuantityOf(column);
    return quantity && quantity->of != Of::kStrut;
  };
  const auto yields = [](const KinematicColumn& column) {
    const KinematicQuantity* quantity = QuantityOf(column);
    return quantity && quantity->yields;
  };
  const auto is_ratio = [](const KinematicColumn& column) { return column.name.starts_with("motion_ratio"); };
  if (std::any_of(columns.begin(), columns.end(), IsTravel))
    return std::any_of(columns.begin(), columns.end(), is_quantity) ||
           std::any_of(columns.begin(), columns.end(), is_ratio);
  return std::any_of(columns.begin(), columns.end(), IsLoad) && std::any_of(columns.begin(), columns.end(), yields);
}

}  // namespace fourpost
