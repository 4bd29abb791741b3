#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vehicles/description/scalar.h"
#include "vehicles/laws/dahl_friction.h"
#include "vehicles/laws/dashpot_law.h"
#include "vehicles/laws/hydraulic_damper.h"
#include "vehicles/laws/spring_law.h"
#include "vehicles/laws/tyre_law.h"

namespace fourpost {

// Laws of a vehicle's elements as its file gives them: numbers that may follow parameters. At() takes the values (SI,
// in the order of Vehicle::parameters) and returns the law that all engines use.

/// Law of a spring, a stop or a series spring: tension = stiffness x + cubic x^3 + sum of the knees, or a table.
struct SpringDescription {
  /// Beyond x = side * at the rate is `rate`; with `adds` it is added, as for a stop, otherwise it replaces the rate
  /// before it, as in a multirate spring. Knees of a side are in the order in which they are met.
  struct Knee {
    int side = 1;
    Scalar at;  // m, >= 0
    Scalar rate;
    Scalar cubic;
    bool adds = false;
  };
  /// Extension counts from the table's own zero.
  struct TablePoint {
    Scalar extension;  // m
    Scalar force;      // N
  };
  Scalar stiffness;
  Scalar cubic;
  std::vector<Knee> knees;
  /// By rising extension.
  std::vector<TablePoint> table = {};
  /// Extension in the table at which the design pose stands [m].
  Scalar place = {};
  /// Whether the file states that, or a free length that gives it.
  bool is_placed = false;

  SpringLaw At(std::span<const double> parameters) const;
  bool IsLinear() const { return cubic.IsZero() && knees.empty() && table.empty(); }
  /// In the design pose [N/m].
  double RateAt(std::span<const double> parameters) const;
};

/// Law of a tyre in the vertical, damping excepted: stiffness and progression, or a table instead.
struct TyreDescription {
  struct TablePoint {
    Scalar deflection;  // m
    Scalar force;       // N
  };
  Scalar stiffness = {};
  Scalar progression = {};
  /// By rising deflection.
  std::vector<TablePoint> table = {};

  TyreLaw At(std::span<const double> parameters) const;
  /// Whether its rate is the same under any load, whatever the parameters are.
  bool IsLinear() const { return progression.IsZero() && table.empty(); }
  /// Under a load [N/m].
  double RateAt(std::span<const double> parameters, double load) const;
};

/// Law of a damper, hydraulic ones excepted, with the friction of its seals.
struct DashpotDescription {
  enum class Kind { kBilinear, kSmooth, kDigressive, kSaturating, kTable, kCurve };
  struct Knee {
    Scalar speed;
    Scalar rate;
  };
  struct TablePoint {
    Scalar speed;
    Scalar force;
  };
  /// Mean slope of a curve from the segment before it, or from rest, to this speed.
  struct Segment {
    Scalar to;
    Scalar rate;
  };
  /// Of DashpotLaw::WithFriction(), or with `stiffness` DahlFriction, which then acts beside the damper and its mount.
  struct Friction {
    Scalar force;
    Scalar speed;
    std::optional<Scalar> stiffness = {};
  };
  Kind kind = Kind::kBilinear;
  Scalar compression;
  Scalar rebound;
  /// Smooth: velocity of the transition.
  Scalar transition;
  /// Digressive; of a saturating law the speeds.
  Knee compression_knee;
  Knee rebound_knee;
  /// Table: by rising velocity.
  std::vector<TablePoint> table;
  /// Curve: by rising velocity.
  std::vector<Segment> segments = {};
  std::optional<Friction> friction;

  /// With its friction, unless that sticks.
  DashpotLaw At(std::span<const double> parameters) const;
  bool Sticks() const { return friction && friction->stiffness; }
  /// Friction that sticks, if it has any. Throws as DahlFriction::Validate() does.
  std::optional<DahlFriction> StickingAt(std::span<const double> parameters) const;
};

/// Hydraulic damper without its friction: the fields of HydraulicDamper that a file may set.
struct HydraulicDescription {
  /// Effective area Cd A of the bleed, both directions [m^2].
  Scalar bleed;
  /// Resistance of the rebound and the bump valve to mass flow [Pa s/kg].
  Scalar rebound_valve;
  Scalar compression_valve;
  /// Stiffness of the oil [Pa].
  Scalar bulk_modulus;
  Scalar piston_diameter;
  Scalar rod_diameter;
  /// Lengths of the oil columns of both chambers in the design pose [m].
  Scalar rebound_column;
  Scalar compression_column;
  Scalar gas_pressure;
  Scalar gas_volume;
  Scalar gas_exponent;
  /// Of the oil [kg/m^3].
  Scalar density;
  /// Lower limit of the pressure in each chamber [Pa].
  Scalar cavitation;

  HydraulicDamper At(std::span<const double> parameters) const;
};

}  // namespace fourpost
