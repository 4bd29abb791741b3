#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/files/recorded_table.h"
#include "identify/experiments/kinematics/kinematic_column.h"
#include "identify/experiments/kinematics/kinematic_plan.h"
#include "identify/experiments/kinematics/kinematic_sweep.h"
#include "identify/experiments/kinematics/measured_axles.h"

namespace fourpost {

/// What rows of one kind of motion have for their position.
struct PositionKind {
  const char* name;
  Dimension dimension;
  const char* example;
};

PositionKind PositionKindOf(const std::optional<KinematicSweep::Load>& load);

struct PositionColumn {
  KinematicColumn column;
  /// To SI, of numbers.
  double factor = 1;
  /// Whether its fields have their own units.
  bool is_per = false;
};

/// A column that holds a quantity.
struct QuantityColumn {
  KinematicColumn column;
  const KinematicPlan::Noise* noise = nullptr;
  /// As in QuantityName; empty: by the row, or the axle's.
  std::string of;
  /// To SI, sign and scale included.
  double factor = 1;
};

/// Which columns of a table a plan reads, and in which units. Reports every fault at the plan's line of the study.
class RigColumns {
 public:
  /// Holds on to all of them.
  RigColumns(const KinematicPlan& plan, const RecordedTable& table, const MeasuredAxles& axles,
             Diagnostics& diagnostics);

  /// Columns that say what a row is of.
  const std::optional<KinematicColumn>& axle() const { return axle_; }
  const std::optional<KinematicColumn>& motion() const { return motion_; }
  const std::optional<KinematicColumn>& load_case() const { return case_; }
  const std::optional<KinematicColumn>& wheel() const { return wheel_; }
  const std::optional<KinematicColumn>& strut() const { return strut_; }
  /// Of the plan's 'noise'.
  const std::vector<QuantityColumn>& quantities() const { return quantities_; }
  /// Of the rows of a load, or of a travel; null after a fault.
  const PositionColumn* PositionOf(const std::optional<KinematicSweep::Load>& load);
  /// Reports a quantity that nothing measures.
  void LacksColumn(const KinematicPlan::Noise& noise);
  bool is_faulty() const { return is_faulty_; }

 private:
  void FindQuantities();
  void FindMapped();
  void FindNamed();
  void Take(const KinematicColumn& column, const KinematicPlan::Noise& noise, const std::string& of,
            const SourceChannel* source);
  std::optional<PositionColumn> FindPosition(const PositionKind& kind, bool is_load);
  double FactorOf(const KinematicColumn& column, const std::string& unit, const Dimension& dimension,
                  const std::string& example);
  std::optional<KinematicColumn> Named(const std::string& name);
  const KinematicPlan::Noise* NoiseOf(const std::string& quantity) const;
  void Fault(const Finding& kind, const std::vector<std::string>& words);

  const KinematicPlan& plan_;
  const RecordedTable& table_;
  const MeasuredAxles& axles_;
  Diagnostics& diagnostics_;
  std::vector<KinematicColumn> columns_;
  std::optional<KinematicColumn> axle_, motion_, case_, wheel_, strut_;
  /// By the name of their kind; nothing after a fault.
  std::map<std::string, std::optional<PositionColumn>> positions_;
  std::vector<QuantityColumn> quantities_;
  bool is_faulty_ = false;
};

}  // namespace fourpost
