#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "analysis/text/units.h"

namespace fourpost {

/// A column of a table by its name without its unit, which stands in the file's own place for it or as the end of the
/// name: "camber_deg", "camber [deg]"; and with the name that is meant by another spelling of it: "Wheel Travel".
struct KinematicColumn {
  std::size_t index = 0;
  std::string name;
  /// As written; empty: none.
  std::string unit;
  /// Whether its first field that is not empty is no number.
  bool is_text = false;
};

std::vector<KinematicColumn> KinematicColumns(const RecordedTable& table);

/// The column of this name; nothing where there is none of this kind.
std::optional<KinematicColumn> FindKinematicColumn(const std::vector<KinematicColumn>& columns, std::string_view name,
                                                   bool is_text);

/// A quantity and whose it is, as in "camber_left"; nothing for other names.
struct QuantityName {
  std::string quantity;
  /// "left", a wheel, a strut; empty: not said.
  std::string of;
};
std::optional<QuantityName> ParseQuantityName(const std::string& name);

/// Whether a table has a column of travel, force or torque by its name, and no times.
bool HasRigPosition(const RecordedTable& table);

/// Whether a table is of a rig: a travel or a load, a quantity over it, and no times.
bool IsKinematicTable(const RecordedTable& table);

}  // namespace fourpost
