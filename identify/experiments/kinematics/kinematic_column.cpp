#include "identify/experiments/kinematics/kinematic_column.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording_layout.h"
#include "identify/experiments/kinematics/kinematic_quantity.h"

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

constexpr std::array<std::string_view, 7> kUnitsInNames = {"deg", "rad", "mm", "m", "N", "kN", "Nm"};

/// What rigs and other programs write for a name of ours.
struct OtherName {
  std::string_view theirs;
  std::string_view ours;
};
constexpr std::array<OtherName, 8> kOtherNames = {{{"wheel_travel", "travel"},
                                                   {"bump_travel", "travel"},
                                                   {"suspension_travel", "travel"},
                                                   {"vertical_travel", "travel"},
                                                   {"jounce", "travel"},
                                                   {"bump", "travel"},
                                                   {"camber_angle", "camber"},
                                                   {"toe_angle", "toe"}}};

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

/// In small letters, with one bar between words: "wheel_travel" of "Wheel Travel".
std::string Plain(const std::string& name) {
  std::string plain;
  for (const char letter : name) {
    const auto c = static_cast<unsigned char>(letter);
    if (c < 0x80 && std::isalnum(c) == 0) {
      if (!plain.empty() && plain.back() != '_') plain += '_';
    } else {
      plain += static_cast<char>(c < 0x80 ? std::tolower(c) : c);
    }
  }
  if (plain.ends_with('_')) plain.pop_back();
  return plain;
}

/// Ours for a name in small letters; empty for none.
std::string_view OwnName(const std::string& plain) {
  constexpr std::array<std::string_view, 4> kPositions = {"travel", "force", "torque", "per"};
  for (const OtherName& other : kOtherNames)
    if (plain == other.theirs) return other.ours;
  for (const std::string_view name : kPositions)
    if (plain == name) return name;
  const KinematicQuantity* const quantity = FindKinematicQuantity(plain);
  return quantity ? quantity->name : std::string_view();
}

/// The name that is meant, and whose it is as written, but for blanks and for sides; as it is where that is none of
/// ours.
std::string MeantName(const std::string& name) {
  if (ParseQuantityName(name)) return name;
  for (std::size_t length = name.size(); length > 0; --length) {
    const bool is_end = length == name.size() || std::isalnum(static_cast<unsigned char>(name[length])) == 0;
    const std::string_view own = is_end ? OwnName(Plain(name.substr(0, length))) : std::string_view();
    if (own.empty()) continue;
    const std::size_t of = name.find_first_not_of(" _-:.()", length);
    if (of == std::string::npos) return std::string(own);
    std::string whose = name.substr(of);
    std::replace(whose.begin(), whose.end(), ' ', '_');
    if (const std::string side = Plain(whose); side == "left" || side == "right") whose = side;
    return std::string(own) + '_' + whose;
  }
  return name;
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
  column.name = MeantName(column.name);
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
