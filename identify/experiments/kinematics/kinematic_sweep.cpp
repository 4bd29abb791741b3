#include "identify/experiments/kinematics/kinematic_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/files/recorded_unit.h"
#include "analysis/text/nearest.h"
#include "identify/experiments/kinematics/findings.h"
#include "identify/experiments/kinematics/kinematic_column.h"
#include "identify/experiments/kinematics/measured_axles.h"

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// A column that holds a quantity.
struct ReadColumn {
  KinematicColumn column;
  const KinematicPlan::Noise* noise = nullptr;
  /// As in QuantityName; empty: by the row, or the axle's.
  std::string of;
  /// To SI, sign and scale included.
  double factor = 1;
};

class SweepReader {
 public:
  SweepReader(const KinematicPlan& plan, const RecordedTable& table, const Vehicle& vehicle, Diagnostics& diagnostics)
      : plan_(plan), table_(table), diagnostics_(diagnostics), axles_(vehicle), columns_(KinematicColumns(table)) {}

  std::vector<KinematicSweep> Read() {
    FindRowColumns();
    FindPosition();
    FindQuantities();
    if (is_faulty_) return {};
    for (std::size_t row = 0; row < table_.rows(0) && !is_faulty_; ++row) ReadRow(row);
    if (is_faulty_) return {};
    if (sweeps_.empty()) Fault(kKinematicRowsMissing, {FileName(), plan_.axle, plan_.motion});
    CheckCurves();
    return std::move(sweeps_);
  }

 private:
  void Fault(const Finding& kind, const std::vector<std::string>& words) {
    diagnostics_.Report(kind, {plan_.study, plan_.line}, words);
    is_faulty_ = true;
  }
  void RowFault(const Finding& kind, std::size_t row, const std::vector<std::string>& words) {
    table_.Report(kind, row, words, diagnostics_);
    is_faulty_ = true;
  }
  std::string FileName() const { return plan_.file.filename().string(); }

  /// Columns that say what a row is of.
  void FindRowColumns() {
    const auto find = [&](std::initializer_list<const char*> names) -> std::optional<KinematicColumn> {
      for (const char* name : names)
        if (auto column = FindKinematicColumn(columns_, name, true)) return column;
      return std::nullopt;
    };
    axle_column_ = find({"axle"});
    motion_column_ = find({"motion", "travel", "load"});
    case_column_ = find({"case"});
    wheel_column_ = find({"wheel"});
    strut_column_ = find({"strut"});
  }

  /// The factor to SI of a column, by the study's unit or its own.
  double FactorOf(const KinematicColumn& column, const std::string& unit, const Dimension& dimension,
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

  std::optional<KinematicColumn> Named(const std::string& name) {
    for (const KinematicColumn& column : columns_)
      if (table_.names()[column.index] == name) return column;
    Fault(kKinematicChannelMissing, {FileName(), name, DidYouMeanOrAll(name, table_.names())});
    return std::nullopt;
  }

  /// Of the table, whose rows are of one kind.
  std::optional<WheelLoad> LoadOfTable() const {
    if (!plan_.motion.empty()) return LoadNamed(plan_.motion);
    return motion_column_ && table_.rows(0) > 0 ? LoadNamed(table_.Text(0, motion_column_->index)) : std::nullopt;
  }

  void FindPosition() {
    const std::optional<WheelLoad> load = LoadOfTable();
    const bool is_torque = load == WheelLoad::kAligning;
    const Dimension dimension = !load ? kLength : is_torque ? kTorque : kForce;
    const char* example = !load ? "mm" : is_torque ? "N*m" : "kN";
    if (plan_.position) {
      if (const auto column = Named(plan_.position->name)) {
        position_ = column;
        position_factor_ = plan_.position->factor * FactorOf(*column, plan_.position->unit, dimension, example);
      }
      return;
    }
    const char* name = !load ? "travel" : is_torque ? "torque" : "force";
    position_ = FindKinematicColumn(columns_, name, false);
    if (position_) position_factor_ = FactorOf(*position_, "", dimension, example);
    else if (load) per_column_ = FindKinematicColumn(columns_, "per", true);
    if (!position_ && !per_column_) Fault(kKinematicPositionMissing, {name, load ? "force" : "travel", example});
  }

  void Take(const KinematicColumn& column, const KinematicPlan::Noise& noise, const std::string& of,
            const SourceChannel* source) {
    const KinematicQuantity& quantity = *noise.quantity;
    ReadColumn read{.column = column, .noise = &noise, .of = of};
    read.factor = (source ? source->factor : 1) *
                  FactorOf(column, source ? source->unit : "", quantity.dimension, std::string(quantity.unit));
    const bool is_of_row = quantity.of == Of::kWheel ? wheel_column_.has_value() : strut_column_.has_value();
    if (of.empty() && quantity.of != Of::kAxle && !is_of_row && !(quantity.of == Of::kWheel && axles_.HaveOneWheel()))
      Fault(kKinematicWheelOpen, {table_.names()[column.index], quantity.of == Of::kWheel ? "wheel" : "strut",
                                  std::string(quantity.name), table_.names()[column.index]});
    read_.push_back(std::move(read));
  }

  const KinematicPlan::Noise* NoiseOf(const std::string& quantity) const {
    const auto found = std::find_if(plan_.noise.begin(), plan_.noise.end(), [&](const KinematicPlan::Noise& noise) {
      return noise.quantity->name == quantity;
    });
    return found == plan_.noise.end() ? nullptr : &*found;
  }

  void FindQuantities() {
    for (const auto& [name, source] : plan_.channels) {
      const std::optional<QuantityName> parsed = ParseQuantityName(name);
      if (!parsed || !axles_.IsKnown(*FindKinematicQuantity(parsed->quantity), parsed->of)) {
        std::vector<std::string> legal;
        for (const KinematicPlan::Noise& noise : plan_.noise) legal.emplace_back(noise.quantity->name);
        diagnostics_.Report(kKinematicQuantityUnknown, {plan_.study, source.line},
                            {name, DidYouMeanOrAll(name, legal)});
        is_faulty_ = true;
        continue;
      }
      const KinematicPlan::Noise* noise = NoiseOf(parsed->quantity);
      if (!noise || source.channels.empty()) continue;
      if (const auto column = Named(source.channels.front().name))
        Take(*column, *noise, parsed->of, &source.channels.front());
    }
    for (const KinematicColumn& column : columns_) {
      const std::optional<QuantityName> parsed = ParseQuantityName(column.name);
      const KinematicPlan::Noise* noise = parsed && !column.is_text ? NoiseOf(parsed->quantity) : nullptr;
      if (!noise || !axles_.IsKnown(*noise->quantity, parsed->of)) continue;
      const bool is_mapped = std::any_of(read_.begin(), read_.end(), [&](const ReadColumn& read) {
        return read.noise == noise && (read.of == parsed->of || read.column.index == column.index);
      });
      if (!is_mapped) Take(column, *noise, parsed->of, nullptr);
    }
    for (const KinematicPlan::Noise& noise : plan_.noise)
      if (std::none_of(read_.begin(), read_.end(), [&](const ReadColumn& read) { return read.noise == &noise; }))
        LacksColumn(noise);
  }

  void LacksColumn(const KinematicPlan::Noise& noise) {
    const std::string name(noise.quantity->name);
    const char* of = noise.quantity->of == Of::kWheel ? "_left" : "";
    Fault(kKinematicQuantityMissing, {name, FileName(), name + of, Joined(table_.names())});
  }

  // Rows.

  std::string TextAt(std::size_t row, const std::optional<KinematicColumn>& column) const {
    return column ? table_.Text(row, column->index) : "";
  }

  void ReadRow(std::size_t row) {
    const std::string axle_text = TextAt(row, axle_column_);
    const std::string motion_text = TextAt(row, motion_column_);
    const std::string case_text = TextAt(row, case_column_);
    if (axle_column_ && !plan_.axle.empty() && axle_text != plan_.axle) return;
    if (motion_column_ && !plan_.motion.empty() && !IsStated(motion_text, axle_text)) return;
    if (case_column_ && plan_.is_opposed && (case_text == "opposed") != *plan_.is_opposed) return;
    const std::string axle_name = !plan_.axle.empty() ? plan_.axle : axle_text;
    const std::string motion = !plan_.motion.empty() ? plan_.motion : motion_text;
    KinematicSweep* sweep = SweepOf(axle_name, motion, plan_.is_opposed.value_or(case_text == "opposed"));
    if (sweep == nullptr) return;
    const std::optional<double> position = PositionAt(row);
    if (!position) return;
    for (const ReadColumn& read : read_) AddPoint(row, read, *position, *sweep);
  }

  /// Whether a row is of the study's motion; both may name a wheel otherwise.
  bool IsStated(const std::string& motion, const std::string& axle_text) const {
    if (motion == plan_.motion) return true;
    const std::optional<std::size_t> axle = axles_.AxleNamed(plan_.axle.empty() ? axle_text : plan_.axle);
    if (!axle) return false;
    const std::optional<std::size_t> wheel = axles_.WheelNamed(plan_.motion, *axle);
    return wheel && axles_.WheelNamed(motion, *axle) == wheel;
  }

  std::optional<double> PositionAt(std::size_t row) {
    if (per_column_) {
      const std::string text = table_.Text(row, per_column_->index);
      const std::optional<Quantity> quantity = ParseQuantity(text);
      if (!quantity) RowFault(kKinematicNumber, row, {"per", text});
      return quantity ? std::optional<double>(quantity->si) : std::nullopt;
    }
    return NumberAt(row, position_->index, position_factor_);
  }

  /// Nothing for an empty field.
  std::optional<double> NumberAt(std::size_t row, std::size_t column, double factor) {
    const std::optional<double> number = table_.Number(row, column);
    if (!number) RowFault(kKinematicNumber, row, {table_.names()[column], table_.Text(row, column)});
    if (!number || std::isnan(*number)) return std::nullopt;
    return factor * *number;
  }

  KinematicSweep* SweepOf(const std::string& axle, const std::string& motion, bool is_opposed) {
    const std::optional<std::size_t> index = AxleNamed(axle);
    if (!index) return nullptr;
    const auto [found, is_new] = sweep_of_.try_emplace({*index, motion, is_opposed}, sweeps_.size());
    if (!is_new) return &sweeps_[found->second];
    KinematicSweep sweep{.recording = plan_.name,
                         .is_validation = plan_.is_validation,
                         .line = plan_.line,
                         .axle = *index,
                         .axle_name = axles_.names()[*index]};
    if (motion.empty()) {
      Fault(kKinematicMotionOpen, {});
      return nullptr;
    }
    if (!axles_.SetMotion(motion, is_opposed, sweep)) {
      Fault(kKinematicMotionUnknown, {sweep.axle_name, motion, DidYouMean(motion, axles_.MotionsOf(*index))});
      return nullptr;
    }
    sweeps_.push_back(std::move(sweep));
    return &sweeps_.back();
  }

  std::optional<std::size_t> AxleNamed(const std::string& name) {
    const std::vector<std::string>& names = axles_.names();
    if (name.empty() && names.size() == 1) return 0;
    const std::optional<std::size_t> axle = axles_.AxleNamed(name);
    if (name.empty()) Fault(kKinematicAxleOpen, {Joined(names)});
    else if (!axle) Fault(kKinematicAxleUnknown, {name, DidYouMeanOrAll(name, names)});
    return axle;
  }

  void AddPoint(std::size_t row, const ReadColumn& read, double position, KinematicSweep& sweep) {
    const KinematicQuantity& quantity = *read.noise->quantity;
    if (sweep.load && !quantity.yields) return;
    const std::optional<double> value = NumberAt(row, read.column.index, read.factor);
    if (!value) return;
    std::size_t of = 0;
    std::string name = sweep.axle_name;
    if (quantity.of == Of::kWheel) {
      const std::string wheel = !read.of.empty() ? read.of : TextAt(row, wheel_column_);
      const std::optional<std::size_t> found =
          wheel.empty() ? std::optional<std::size_t>(0) : axles_.WheelNamed(wheel, sweep.axle);
      // A column of another axle's wheel.
      if (!found && !read.of.empty()) return;
      if (!found) return RowFault(kKinematicWheelUnknown, row, {sweep.axle_name, wheel, ""});
      of = *found;
      name = axles_.WheelName(of, sweep.axle);
    } else if (quantity.of == Of::kStrut) {
      name = !read.of.empty() ? read.of : TextAt(row, strut_column_);
      const std::optional<std::size_t> found = axles_.StrutNamed(name);
      if (!found) return;
      of = *found;
    } else if (wheel_column_) {
      // What is the axle's stands in the rows of all its wheels.
      const std::string wheel = TextAt(row, wheel_column_);
      if (first_wheel_.try_emplace(sweep.axle, wheel).first->second != wheel) return;
    }
    KinematicCurve& curve = CurveOf(read, of, name, sweep);
    // Places among the positions follow when all are known.
    curve.measured.push_back(*value);
    position_of_[{static_cast<std::size_t>(&sweep - sweeps_.data()),
                  static_cast<std::size_t>(&curve - sweep.curves.data())}]
        .push_back(position);
  }

  static KinematicCurve& CurveOf(const ReadColumn& read, std::size_t of, const std::string& name,
                                 KinematicSweep& sweep) {
    const auto found = std::find_if(sweep.curves.begin(), sweep.curves.end(), [&](const KinematicCurve& curve) {
      return curve.quantity == read.noise->quantity && curve.of == of;
    });
    if (found != sweep.curves.end()) return *found;
    sweep.curves.push_back({.quantity = read.noise->quantity,
                            .of = of,
                            .of_name = name,
                            .places = {},
                            .measured = {},
                            .sd = read.noise->sd,
                            .has_free_offset = read.noise->has_free_offset});
    return sweep.curves.back();
  }

  void CheckCurves() {
    const auto measures = [](const KinematicPlan::Noise& noise) {
      return [&noise](const KinematicSweep& sweep) {
        return std::any_of(sweep.curves.begin(), sweep.curves.end(),
                           [&](const KinematicCurve& curve) { return curve.quantity == noise.quantity; });
      };
    };
    for (const KinematicPlan::Noise& noise : plan_.noise)
      if (!is_faulty_ && std::none_of(sweeps_.begin(), sweeps_.end(), measures(noise))) LacksColumn(noise);
    for (std::size_t s = 0; s < sweeps_.size(); ++s) PlacePoints(s);
    std::erase_if(sweeps_, [](const KinematicSweep& sweep) { return sweep.curves.empty(); });
  }

  void PlacePoints(std::size_t s) {
    KinematicSweep& sweep = sweeps_[s];
    std::vector<double>& all = sweep.positions;
    for (std::size_t c = 0; c < sweep.curves.size(); ++c) {
      const std::vector<double>& at = position_of_[{s, c}];
      all.insert(all.end(), at.begin(), at.end());
      if (sweep.curves[c].degrees() == 0)
        Fault(kKinematicOnePoint, {std::string(sweep.curves[c].quantity->name), sweep.curves[c].of_name});
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::size_t c = 0; c < sweep.curves.size(); ++c)
      for (const double position : position_of_[{s, c}])
        sweep.curves[c].places.push_back(
            static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), position) - all.begin()));
  }

  const KinematicPlan& plan_;
  const RecordedTable& table_;
  Diagnostics& diagnostics_;
  MeasuredAxles axles_;
  std::vector<KinematicColumn> columns_;
  std::optional<KinematicColumn> axle_column_, motion_column_, case_column_, wheel_column_, strut_column_;
  std::optional<KinematicColumn> position_, per_column_;
  double position_factor_ = 1;
  std::vector<ReadColumn> read_;
  std::vector<KinematicSweep> sweeps_;
  std::map<std::tuple<std::size_t, std::string, bool>, std::size_t> sweep_of_;
  /// Of each axle.
  std::map<std::size_t, std::string> first_wheel_;
  /// Of the points of each sweep's curves.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> position_of_;
  bool is_faulty_ = false;
};

}  // namespace

std::vector<KinematicSweep> LoadKinematicSweeps(const KinematicPlan& plan, const Vehicle& vehicle,
                                                Diagnostics& diagnostics) {
  const std::optional<RecordedTable> table = ReadRecordedTable(plan.file, diagnostics);
  if (!table) return {};
  return SweepReader(plan, *table, vehicle, diagnostics).Read();
}

}  // namespace fourpost
