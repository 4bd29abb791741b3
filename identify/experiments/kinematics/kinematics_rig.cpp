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
KinematicAnswer Answered(const Vehicle& vehicle, const std::vector<KinematicSweep>& sweeps,
                         const std::vector<double>& values, const std::string& study) {
  KinematicAnswer answer = AnswerKinematics(vehicle, sweeps, values);
  if (!answer.refusal) return answer;
  Diagnostics diagnostics;
  ReportRefusal(*answer.refusal, sweeps, study, diagnostics);
  throw FaultyInput(diagnostics);
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
  if (!plan.position && !IsKinematicTable(table) && !FindKinematicColumn(columns, "force", false) &&
      !FindKinematicColumn(columns, "torque", false))
    return false;
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
      if (const auto refusal = AnswerKinematics(subject.vehicle(), sweeps, values).refusal)
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
  return KinematicResiduals(subject.vehicle(), fitted);
}

bool KinematicsRig::MeasuresForce() const {
  return std::any_of(fitted.begin(), fitted.end(), [](const KinematicSweep& sweep) {
    return sweep.load || std::any_of(sweep.curves.begin(), sweep.curves.end(), [](const KinematicCurve& curve) {
             return curve.quantity->dimension == kForce;
           });
  });
}

void KinematicsRig::Check(const Subject& subject, Severity, Diagnostics& diagnostics) const {
  const KinematicAnswer answer = AnswerKinematics(subject.vehicle(), fitted, subject.vehicle().ParameterValues());
  if (!answer.refusal) LintKinematicSigns(KinematicMisfits(fitted, answer), file, diagnostics);
}

void KinematicsRig::CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const {
  const KinematicAnswer answer = AnswerKinematics(subject.vehicle(), fitted, fit.values);
  if (!answer.refusal) LintKinematicOffsets(KinematicMisfits(fitted, answer), file, diagnostics);
}

ExperimentResults KinematicsRig::Results(const Subject& subject, const FitResult& fit) const {
  std::vector<KinematicMisfit> misfits =
      KinematicMisfits(fitted, Answered(subject.vehicle(), fitted, fit.values, file));
  Diagnostics refused;
  std::vector<LeftOutRecording> left_out = left_out_;
  const KinematicAnswer kept = AnswerKinematics(subject.vehicle(), validation, fit.values);
  if (kept.refusal) ReportRefusal(*kept.refusal, validation, file, refused);
  Diagnostics findings;
  if (const auto out = LeftOutFor(refused, "kinematics", file, findings)) left_out.push_back(*out);
  if (!kept.refusal) {
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
  const KinematicAnswer answer = Answered(vehicle, fitted, vehicle.ParameterValues(), file);
  return ResultsOf(KinematicMisfits(fitted, answer), vehicle.name + ": kinematics and compliance");
}

bool KinematicsRig::Reads(const RecordedTable& table) const {
  return std::any_of(plans.begin(), plans.end(), [&](const KinematicPlan& plan) { return HasColumnsOf(table, plan); });
}

std::optional<ExperimentResults> KinematicsRig::Predict(const Subject& subject, const PredictionRequest& request,
                                                        const WorkHooks&) const {
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
    found = std::find_if(plans.begin(), plans.end(),
                         [&](const KinematicPlan& plan) { return HasColumnsOf(*table, plan); });
  KinematicPlan plan = *found;
  plan.file = request.recording;
  plan.name = request.recording.stem().string();
  plan.is_validation = false;
  const std::vector<KinematicSweep> sweeps = LoadKinematicSweeps(plan, subject.vehicle(), results.findings);
  if (results.findings.HasErrors()) throw FaultyInput(results.findings);
  const KinematicAnswer answer = Answered(subject.vehicle(), sweeps, subject.vehicle().ParameterValues(), file);
  ExperimentResults predicted =
      ResultsOf(KinematicMisfits(sweeps, answer), subject.vehicle().name + ": kinematics and compliance");
  predicted.findings = std::move(results.findings);
  return predicted;
}

}  // namespace fourpost
