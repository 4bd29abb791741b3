#pragma once

#include <optional>

#include "vehicles/description/element_laws.h"
#include "vehicles/reader/parameter_reader.h"
#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"

namespace fourpost {

/// Reads the laws of springs, stops and dampers, and reports their errors.
class LawReader {
 public:
  LawReader(ParameterReader& parameters, FileFaults& faults) : parameters_(parameters), faults_(faults) {}

  /// Of a spring's law: `<linear>`, `<cubic>`, `<multirate>` or `<table>`.
  SpringDescription ReadSpring(const Tag& law);
  /// Of the `<bump>` and `<rebound>` of an `<fp:stop>`.
  SpringDescription ReadStop(const Tag& stop);
  /// Law of a damper, `<hydraulic>` excepted, with its friction; `series`: the spring in series with it, if any.
  DashpotDescription ReadDashpot(const Tag& damper, const Tag& law, const std::optional<Tag>& series);
  /// `series`: the spring in series with the damper, unless it is hydraulic.
  std::optional<DashpotDescription::Friction> ReadFriction(const Tag& damper, const std::optional<Tag>& series);
  SpringDescription ReadSeries(const Tag& series);
  /// Of a tyre in the vertical: its attributes, or its `<table>`.
  TyreDescription ReadTyre(const Tag& tyre);
  HydraulicDescription ReadHydraulic(const Tag& law);

 private:
  void ReadKnees(const Tag& multirate, SpringDescription& law);
  SpringDescription ReadSpringTable(const Tag& table);
  void ReadTyreTable(const Tag& table, TyreDescription& law);
  Scalar ReadForce(const Tag& point, const Tag& table, const Scalar& scale);
  void CheckPlace(const Tag& table, const SpringDescription& law);
  void ReadRates(const Tag& law, DashpotDescription& dashpot);
  void ReadTable(const Tag& table, DashpotDescription& dashpot);
  void ReadCurve(const Tag& curve, DashpotDescription& dashpot);
  void CheckPoint(const Tag& table, const Tag& tag, std::size_t i,
                  const std::vector<DashpotDescription::TablePoint>& points);
  void CheckInvertible(const Tag& damper, const Tag& series, const DashpotDescription& dashpot);
  bool Resists(const DashpotDescription::TablePoint& point) const;
  double LeastRate(const DashpotDescription& dashpot) const;
  bool CanStick(const DashpotDescription& dashpot) const;

  ParameterReader& parameters_;
  FileFaults& faults_;
};

/// The first child of this name; empty if there is none.
std::optional<Tag> ChildOf(const Tag& tag, std::string_view name);

}  // namespace fourpost
