#include "identify/experiments/static_loads/static_loads.h"

#include <string>

#include "analysis/text/text_table.h"
#include "identify/experiments/audited_vehicle.h"
#include "identify/experiments/static_loads/load_lint.h"
#include "identify/fit/fit.h"
#include "identify/study_file/channel_source_reader.h"

namespace fourpost {

std::unique_ptr<Experiment> StaticLoadTest::Read(const StrictMap& study) {
  if (!study.Has("static_loads")) return nullptr;
  const StrictMap map = study.Map("static_loads", {"file", "tyres"});
  StaticLoadPlan plan = {.file = study.file(), .line = LineOf(study.Get("static_loads"))};
  map.Require("file");
  if (const auto file = map.Text("file")) plan.table = study.Resolve(*file);
  if (const YAML::Node tyres = map.Require("tyres"); tyres.IsDefined())
    plan.tyres = ReadChannelSources(tyres, "'tyres'", "tyres", ChannelKind::kLoad, plan.file, study.diagnostics());
  return std::make_unique<StaticLoadTest>(std::move(plan), std::vector<MeasuredLoad>());
}

std::vector<ExperimentFile> StaticLoadTest::Files() const {
  return {{.path = plan.table, .line = plan.line, .use = ExperimentFile::Use::kOther}};
}

void StaticLoadTest::Load(const Subject& subject, Diagnostics& diagnostics) {
  loads = LoadStaticLoads(plan, subject.vehicle(), diagnostics);
}

void StaticLoadTest::AddTo(Sha256& data, Sha256&) const {
  for (const MeasuredLoad& load : loads) {
    data.Add(static_cast<double>(load.tyre));
    data.Add(load.load_N);
    data.Add(load.sd_N);
  }
}

std::optional<ResidualBlock> StaticLoadTest::Residuals(const Subject& subject) const {
  if (loads.empty()) return std::nullopt;
  return StaticLoadResiduals(subject.Condensed(), loads, subject.calibrations());
}

void StaticLoadTest::Check(const Subject& subject, Severity, Diagnostics& diagnostics) const {
  LintWeights(*this, subject, diagnostics);
}

void StaticLoadTest::AddRecordings(AuditedVehicle& audited) const {
  for (const MeasuredLoad& load : loads) audited.AddLoad(load.load_N, load.sd_N);
}

void StaticLoadTest::CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const {
  LintLoads(*this, subject, fit, diagnostics);
}

ExperimentResults StaticLoadTest::Results(const Subject& subject, const FitResult& fit) const {
  const std::vector<double> modelled = subject.Condensed()->At(fit.values).preloads.tyre;
  ExperimentResults results;
  TextTable table({"static load", "measured, N", "sd", "modelled, N"});
  for (const MeasuredLoad& load : loads) {
    const std::string& name = subject.vehicle().tyres[load.tyre].name;
    table.Add({name, Rounded(load.load_N, 5), Rounded(load.sd_N, 3), Rounded(modelled[load.tyre], 5)});
    results.json["static_loads"].push_back(
        {{"tyre", name}, {"measured_N", load.load_N}, {"sd_N", load.sd_N}, {"modelled_N", modelled[load.tyre]}});
  }
  results.text = table.Format() + '\n';
  return results;
}

}  // namespace fourpost
