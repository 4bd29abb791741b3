#include "identify/experiments/kinematics/kinematic_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/text/nearest.h"
#include "identify/experiments/kinematics/findings.h"
#include "identify/experiments/kinematics/measured_axles.h"
#include "identify/experiments/kinematics/rig_columns.h"

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

class SweepReader {
 public:
  SweepReader(const KinematicPlan& plan, const RecordedTable& table, const Vehicle& vehicle, Diagnostics& diagnostics)
      : plan_(plan),
        table_(table),
        diagnostics_(diagnostics),
        axles_(vehicle),
        columns_(plan, table, axles_, diagnostics) {}

  std::vector<KinematicSweep> Read() {
    for (std::size_t row = 0; row < table_.rows(0) && !IsFaulty(); ++row) ReadRow(row);
    if (IsFaulty()) return {};
    if (sweeps_.empty()) Fault(kKinematicRowsMissing, {FileName(), plan_.axle, plan_.motion});
    CheckCurves();
    ReportSkipped();
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
  bool IsFaulty() const { return is_faulty_ || columns_.is_faulty(); }
  std::string FileName() const { return plan_.file.filename().string(); }

  std::string TextAt(std::size_t row, const std::optional<KinematicColumn>& column) const {
    return column ? table_.Text(row, column->index) : "";
  }

  void ReadRow(std::size_t row) {
    const std::string axle_text = TextAt(row, columns_.axle());
    const std::string motion_text = TextAt(row, columns_.motion());
    const std::string case_text = TextAt(row, columns_.load_case());
    if (columns_.axle() && !plan_.axle.empty() && axle_text != plan_.axle) return;
    if (columns_.motion() && !plan_.motion.empty() && !IsStated(motion_text, axle_text)) return;
    if (columns_.load_case() && plan_.is_opposed && (case_text == "opposed") != *plan_.is_opposed) return;
    const std::string axle_name = !plan_.axle.empty() ? plan_.axle : axle_text;
    const std::string motion = !plan_.motion.empty() ? plan_.motion : motion_text;
    KinematicSweep* sweep = SweepOf(axle_name, motion, plan_.is_opposed.value_or(case_text == "opposed"));
    if (sweep == nullptr) return;
    const std::optional<double> position = PositionAt(row, *sweep);
    if (!position) return;
    for (const QuantityColumn& read : columns_.quantities()) AddPoint(row, read, *position, *sweep);
  }

  /// Whether a row is of the study's motion; both may name a wheel otherwise.
  bool IsStated(const std::string& motion, const std::string& axle_text) const {
    if (motion == plan_.motion) return true;
    const std::optional<std::size_t> axle = axles_.AxleNamed(plan_.axle.empty() ? axle_text : plan_.axle);
    if (!axle) return false;
    const std::optional<std::size_t> wheel = axles_.WheelNamed(plan_.motion, *axle);
    return wheel && axles_.WheelNamed(motion, *axle) == wheel;
  }

  std::optional<double> PositionAt(std::size_t row, const KinematicSweep& sweep) {
    const PositionColumn* position = columns_.PositionOf(sweep.load);
    if (position == nullptr) return std::nullopt;
    const std::size_t index = position->column.index;
    if (!position->is_per) {
      const std::optional<double> number = NumberAt(row, index, position->factor);
      if (!number && Measures(row)) Skip(row, "no number in '" + table_.names()[index] + "'");
      return number;
    }
    const PositionKind kind = PositionKindOf(sweep.load);
    const std::string text = table_.Text(row, index);
    const std::optional<Quantity> quantity = ParseQuantity(text);
    if (quantity && quantity->unit.dimension == kind.dimension) return quantity->si;
    RowFault(kKinematicPer, row, {text, kind.name, kind.example});
    return std::nullopt;
  }

  bool Measures(std::size_t row) const {
    return std::any_of(columns_.quantities().begin(), columns_.quantities().end(), [&](const QuantityColumn& read) {
      return !std::isnan(table_.Number(row, read.column.index).value_or(0));
    });
  }

  void Skip(std::size_t row, const std::string& reason) { ++skipped_.try_emplace(reason, row, 0).first->second.second; }

  void ReportSkipped() {
    for (const auto& [reason, rows] : skipped_)
      diagnostics_.Report(kKinematicRowsSkipped, {plan_.study, plan_.line},
                          {std::to_string(rows.second), FileName(), table_.RowInWords(rows.first), reason});
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

  void AddPoint(std::size_t row, const QuantityColumn& read, double position, KinematicSweep& sweep) {
    const KinematicQuantity& quantity = *read.noise->quantity;
    if (sweep.load && !quantity.yields) return;
    const std::optional<double> value = NumberAt(row, read.column.index, read.factor);
    if (!value) return;
    KinematicCurve curve{.quantity = &quantity,
                         .of_name = sweep.axle_name,
                         .sd = read.noise->sd,
                         .has_free_offset = read.noise->has_free_offset};
    if (quantity.of == Of::kWheel && !FindWheel(row, read, sweep, curve)) return;
    if (quantity.of == Of::kStrut && !FindStrut(row, read, curve)) return;
    const std::pair<std::size_t, std::size_t> key{static_cast<std::size_t>(&sweep - sweeps_.data()),
                                                  PlaceOf(curve, sweep)};
    // What is the axle's stands in the rows of all its wheels, and what is a wheel's in those of all struts.
    const std::string others = OthersOf(row, read);
    if (first_others_.try_emplace(key, others).first->second != others) return;
    // Places among the positions follow when all are known.
    sweep.curves[key.second].measured.push_back(*value);
    position_of_[key].push_back(position);
  }

  /// False for a column of another axle's wheel, and after a fault.
  bool FindWheel(std::size_t row, const QuantityColumn& read, const KinematicSweep& sweep, KinematicCurve& curve) {
    const std::string wheel = !read.of.empty() ? read.of : TextAt(row, columns_.wheel());
    if (wheel.empty() && columns_.wheel() && !axles_.HaveOneWheel()) {
      RowFault(kKinematicWheelEmpty, row, {table_.names()[read.column.index]});
      return false;
    }
    const std::optional<std::size_t> found =
        wheel.empty() ? std::optional<std::size_t>(0) : axles_.WheelNamed(wheel, sweep.axle);
    if (!found && read.of.empty()) RowFault(kKinematicWheelUnknown, row, {sweep.axle_name, wheel, ""});
    if (!found) return false;
    curve.of = *found;
    curve.of_name = axles_.WheelName(*found, sweep.axle);
    return true;
  }

  bool FindStrut(std::size_t row, const QuantityColumn& read, KinematicCurve& curve) {
    curve.of_name = !read.of.empty() ? read.of : TextAt(row, columns_.strut());
    const AxleStrut* found = axles_.StrutNamed(curve.of_name);
    if (found) curve.strut_kind = found->kind;
    else if (!curve.of_name.empty()) Skip(row, "the vehicle has no strut '" + curve.of_name + "'");
    return found != nullptr;
  }

  /// Wheel and strut of a row, but what a curve takes from there.
  std::string OthersOf(std::size_t row, const QuantityColumn& read) const {
    const Of of = read.noise->quantity->of;
    std::string others;
    if (of != Of::kWheel || !read.of.empty()) others += TextAt(row, columns_.wheel());
    if (of != Of::kStrut || !read.of.empty()) others += '\n' + TextAt(row, columns_.strut());
    return others;
  }

  /// Of a curve among the sweep's, which has it then.
  static std::size_t PlaceOf(const KinematicCurve& curve, KinematicSweep& sweep) {
    const auto found = std::find_if(sweep.curves.begin(), sweep.curves.end(), [&](const KinematicCurve& one) {
      return one.quantity == curve.quantity && one.of_name == curve.of_name;
    });
    const auto place = static_cast<std::size_t>(found - sweep.curves.begin());
    if (found == sweep.curves.end()) sweep.curves.push_back(curve);
    return place;
  }

  void CheckCurves() {
    const auto measures = [](const KinematicPlan::Noise& noise) {
      return [&noise](const KinematicSweep& sweep) {
        return std::any_of(sweep.curves.begin(), sweep.curves.end(),
                           [&](const KinematicCurve& curve) { return curve.quantity == noise.quantity; });
      };
    };
    for (const KinematicPlan::Noise& noise : plan_.noise)
      if (!IsFaulty() && std::none_of(sweeps_.begin(), sweeps_.end(), measures(noise))) columns_.LacksColumn(noise);
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
  RigColumns columns_;
  std::vector<KinematicSweep> sweeps_;
  std::map<std::tuple<std::size_t, std::string, bool>, std::size_t> sweep_of_;
  /// Of each sweep's curves, see OthersOf().
  std::map<std::pair<std::size_t, std::size_t>, std::string> first_others_;
  /// First row and number of those that are not used, by the reason.
  std::map<std::string, std::pair<std::size_t, std::size_t>> skipped_;
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
