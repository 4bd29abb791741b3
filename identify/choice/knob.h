#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Something of a car that can be set to one of several positions, such as the clicks of a damper or a spring of a
/// catalogue, and the parameters that follow it.
struct Knob {
  /// What a position makes of a parameter whose fitted value is v, its own number p and that of the present position q.
  enum class Change {
    /// v p / q: a fit at the present position keeps its doubt at all others.
    kRatio,
    /// v + p - q.
    kDifference,
    /// p: its own number is all that counts.
    kAbsolute,
  };
  struct Position {
    /// "12", "soft", "44 kN/m".
    std::string name;
    /// SI, one per parameter.
    std::vector<double> values;
    /// In place of `values`, possible cars x parameters; empty: all cars have `values`.
    Eigen::MatrixXd drawn = {};
  };
  /// The fit of a bench that `values` of positions come from: its folder, the column and factor of each parameter, and
  /// the row of each position in the table of that run.
  struct Bench {
    std::filesystem::path run;
    std::vector<std::size_t> columns;
    std::vector<double> factors;
    std::vector<double> rows;
  };

  std::string name;
  int line = 0;
  /// Indices in Vehicle::parameters.
  std::vector<std::size_t> parameters;
  std::vector<Position> positions;
  /// The position of the car that was fitted; empty: the fitted car is at none of them.
  std::optional<std::size_t> now;
  Change change = Change::kAbsolute;
  std::optional<Bench> bench = {};
};

/// A position of each knob; kAsFitted leaves its parameters as they are.
using Setting = std::vector<int>;
inline constexpr int kAsFitted = -1;

/// The car as it is.
Setting PresentSetting(const std::vector<Knob>& knobs);

/// Parameter values (SI, order of Vehicle::parameters) of a car with the fitted values `fitted` at a setting; `draw`:
/// the possible car whose drawn positions count.
std::vector<double> ValuesAt(const std::vector<Knob>& knobs, const Setting& setting, std::span<const double> fitted,
                             std::optional<Eigen::Index> draw = std::nullopt);

/// Number of settings on the lattice of all positions; a large number where it is beyond 2^62.
std::int64_t SettingCount(const std::vector<Knob>& knobs);

/// All of them, the last knob changing fastest; and the present one behind them where it is none of these.
std::vector<Setting> AllSettings(const std::vector<Knob>& knobs);

/// Settings that differ from this one by one step of one knob.
std::vector<Setting> NeighboursOf(const std::vector<Knob>& knobs, const Setting& setting);

/// "front 12, rear 9".
std::string SettingText(const std::vector<Knob>& knobs, const Setting& setting);
/// The name of a position; "as fitted".
std::string PositionText(const Knob& knob, int position);

}  // namespace fourpost
