#include "identify/experiments/kinematics/kinematics_rig.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "identify/experiments/kinematics/kinematic_chart.h"
#include "identify/experiments/kinematics/kinematic_column.h"
#include "identify/experiments/kinematics/kinematic_lint.h"
#include "identify/experiments/kinematics/kinematic_residuals.h"
#include "identify/experiments/kinematics/kinematic_result.h"
#include "identify/fit/fit.h"

namespace fourpost {
namespace {

/// Throws FaultyInput where the vehicle cannot do what was measured.
KinematicAnswer Answered(const KinematicModel& model, const std::vector<double>& values, const std::string& study) {
  KinematicAnswer answer = model.At(values);
  if (!answer.refusal) return answer;
  Diagnostics diagnostics;
  ReportRefusal(*answer.refusal, model.sweeps(), study, diagnostics);
  throw FaultyInput(diagnostics);
}

/// Of all that is measured at once.
std::vector<KinematicSweep> Both(const std::vector<KinematicSweep>& a, const std::vector<KinematicSweep>& b) {
  std::vector<KinematicSweep> all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

ExperimentResults ResultsOf(const std::vector<KinematicMisfit>& misfits, const std::string& title) {
  ExperimentResults results;
  results.text = KinematicTable(misfits);
  results.json["kinematics"] = KinematicJson(misfits);
  results.shares = KinematicShares(misfits);
  results.files = {{"kinematics.csv", KinematicCsv(misfits)}, {"kinematics.svg", KinematicSvg(title, misfits)}};
  return results;
}

/// Whether a table has what a plan reads by the names of columns.
bool HasColumnsOf(const RecordedTable& table, const KinematicPlan& plan) {
  const std::vector<KinematicColumn> columns = KinematicColumns(table);
  const auto has = [&](const std::string& name) { return table.FindColumn(name).has_value(); };
  if (plan.position && !has(plan.position->name)) return false;
  if (!plan.position && !HasRigPosition(table)) return false;
  return std::any_of(plan.noise.begin(), plan.noise.end(), [&](const KinematicPlan::Noise& noise) {
    const auto is_of = [&](const std::string& name) {
      const std::optional<QuantityName> parsed = ParseQuantityName(name);
      return parsed && parsed->quantity == noise.quantity->name;
    };
    return std::any_of(columns.begin(), columns.end(), [&](const auto& column) { return is_of(column.name); }) ||
           std::any_of(plan.channels.begin(), plan.channels.end(), [&](const auto& channel) {
             return is_of(channel.first) && !channel.second.channels.empty() &&
                    has(channel.second.channels.front().name);
           });
  });
}

}  // namespace

std::unique_ptr<Experiment> KinematicsRig::Read(const StrictMap& study) {
  if (!study.Has("kinematics")) return nullptr;
  auto rig = std::make_unique<KinematicsRig>();
  rig->file = study.file();
  rig->plans = ReadKinematicPlans(study);
  return rig;
}

std::vector<ExperimentFile> KinematicsRig::Files() const {
  std::vector<ExperimentFile> files;
  for (const KinematicPlan& plan : plans)
    files.push_back({.path = plan.file,
                     .line = plan.line,
                     .use = plan.is_validation ? ExperimentFile::Use::kValidation : ExperimentFile::Use::kFitted});
  return files;
}

void KinematicsRig::LeaveOutValidation() {
  std::erase_if(plans, [](const KinematicPlan& plan) { return plan.is_validation; });
}

void KinematicsRig::Load(const Subject& subject, Diagnostics& diagnostics) {
  fitted.clear();
  validation.clear();
  left_out_.clear();
  const std::vector<double> values = subject.vehicle().ParameterValues();
  for (const KinematicPlan& plan : plans) {
    Diagnostics found;
    std::vector<KinematicSweep> sweeps = LoadKinematicSweeps(plan, subject.vehicle(), found);
    if (!found.HasErrors())
      if (const auto refusal = KinematicModel(subject.vehicle(), sweeps).At(values).refusal)
        ReportRefusal(*refusal, sweeps, file, found);
    if (plan.is_validation) {
      if (const std::optional<LeftOutRecording> out = LeftOutFor(found, plan.name, plan.file, diagnostics)) {
        left_out_.push_back(*out);
        continue;
      }
    } else {
      diagnostics.Add(found);
    }
    std::vector<KinematicSweep>& all = plan.is_validation ? validation : fitted;
    std::move(sweeps.begin(), sweeps.end(), std::back_inserter(all));
  }
}

void KinematicsRig::AddTo(Sha256& data, Sha256& settings) const {
  for (const KinematicSweep& sweep : fitted) {
    data.Add(sweep.axle_name);
    data.Add(sweep.motion);
    data.Add(sweep.positions);
    for (const KinematicCurve& curve : sweep.curves) {
      data.Add(curve.quantity->name);
      data.Add(curve.of_name);
      for (const std::size_t place : curve.places) data.Add(sweep.positions[place]);
      data.Add(curve.measured);
      settings.Add(curve.sd);
      settings.Add(curve.has_free_offset ? 1 : 0);
    }
  }
}

std::optional<ResidualBlock> KinematicsRig::Residuals(const Subject& subject) const {
  if (fitted.empty()) return std::nullopt;
  return KinematicResiduals(std::make_shared<const KinematicModel>(subject.vehicle(), fitted));
}

bool KinematicsRig::MeasuresForce() const {
  return std::any_of(fitted.begin(), fitted.end(), [](const KinematicSweep& sweep) {
    return sweep.load || std::any_of(sweep.curves.begin(), sweep.curves.end(),
                                     [](const KinematicCurve& curve) { return curve.quantity->dimension == kForce; });
  });
}

void KinematicsRig::Check(const Subject& subject, Severity, Diagnostics& diagnostics) const {
  const KinematicAnswer answer = KinematicModel(subject.vehicle(), fitted).At(subject.vehicle().ParameterValues());
  if (!answer.refusal) LintKinematicSigns(KinematicMisfits(fitted, answer), file, diagnostics);
}

void KinematicsRig::CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const {
  const KinematicAnswer answer = KinematicModel(subject.vehicle(), fitted).At(fit.values);
  if (!answer.refusal) LintKinematicOffsets(KinematicMisfits(fitted, answer), file, diagnostics);
}

ExperimentResults KinematicsRig::Results(const Subject& subject, const FitResult& fit) const {
  const KinematicModel model(subject.vehicle(), fitted);
  std::vector<KinematicMisfit> misfits = KinematicMisfits(fitted, Answered(model, fit.values, file));
  std::vector<LeftOutRecording> left_out = left_out_;
  Diagnostics findings;
  const KinematicAnswer kept = KinematicModel(subject.vehicle(), validation).At(fit.values);
  if (kept.refusal) {
    Diagnostics refused;
    ReportRefusal(*kept.refusal, validation, file, refused);
    if (const auto out = LeftOutFor(refused, validation[kept.refusal->sweep].recording, file, findings))
      left_out.push_back(*out);
  } else {
    std::vector<KinematicMisfit> unseen = KinematicMisfits(validation, kept);
    std::move(unseen.begin(), unseen.end(), std::back_inserter(misfits));
  }
  ExperimentResults results = ResultsOf(misfits, subject.vehicle().name + ": kinematics and compliance");
  results.findings = std::move(findings);
  for (const LeftOutRecording& out : left_out) results.json["validation_left_out"].push_back(LeftOutJson(out));
  return results;
}

std::optional<ExperimentResults> KinematicsRig::Respond(const Subject& subject, std::optional<Engine>,
                                                        const WorkHooks&) const {
  const Vehicle& vehicle = subject.vehicle();
  const KinematicModel model(vehicle, Both(fitted, validation));
  const KinematicAnswer answer = Answered(model, vehicle.ParameterValues(), file);
  return ResultsOf(KinematicMisfits(model.sweeps(), answer), vehicle.name + ": kinematics and compliance");
}

bool KinematicsRig::Reads(const RecordedTable& table) const {
  return std::any_of(plans.begin(), plans.end(), [&](const KinematicPlan& plan) { return HasColumnsOf(table, plan); });
}

std::optional<ExperimentResults> KinematicsRig::Predict(const Subject& subject, const PredictionRequest& request,
                                                        const WorkHooks&) const {
  RefuseRelease(request);
  ExperimentResults results;
  const std::optional<RecordedTable> table = ReadRecordedTable(request.recording, results.findings);
  if (!table) throw FaultyInput(results.findings);
  // As the study states this file, or else the first that has such columns.
  const auto is_same = [&](const KinematicPlan& plan) {
    std::error_code is_missing;
    return std::filesystem::equivalent(plan.file, request.recording, is_missing);
  };
  auto found = std::find_if(plans.begin(), plans.end(), is_same);
  if (found == plans.end())
    found =
        std::find_if(plans.begin(), plans.end(), [&](const KinematicPlan& plan) { return HasColumnsOf(*table, plan); });
  KinematicPlan plan = *found;
  plan.file = request.recording;
  plan.name = request.recording.stem().string();
  plan.is_validation = false;
  const std::vector<KinematicSweep> sweeps = LoadKinematicSweeps(plan, subject.vehicle(), results.findings);
  if (results.findings.HasErrors()) throw FaultyInput(results.findings);
  const KinematicModel model(subject.vehicle(), sweeps);
  const KinematicAnswer answer = Answered(model, subject.vehicle().ParameterValues(), file);
  ExperimentResults predicted =
      ResultsOf(KinematicMisfits(sweeps, answer), subject.vehicle().name + ": kinematics and compliance");
  predicted.json["channels"] = nlohmann::ordered_json::array();
  predicted.findings = std::move(results.findings);
  return predicted;
}

}  // namespace fourpost
