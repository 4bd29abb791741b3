#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "identify/experiments/experiment.h"
#include "identify/experiments/static_loads/static_load_data.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Loads under the tyres of a vehicle at rest: 'static_loads' of a study.
class StaticLoadTest : public Experiment {
 public:
  static constexpr std::array<std::string_view, 1> kKeys = {"static_loads"};

  StaticLoadTest() = default;
  StaticLoadTest(StaticLoadPlan as_planned, std::vector<MeasuredLoad> measured)
      : plan(std::move(as_planned)), loads(std::move(measured)) {}

  /// Adds every fault to the study's diagnostics.
  static std::unique_ptr<Experiment> Read(const StrictMap& study);

  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<StaticLoadTest>(*this); }
  std::vector<ExperimentFile> Files() const override;
  void Load(const Subject& subject, Diagnostics& diagnostics) override;
  void AddTo(Sha256& data, Sha256& settings) const override;
  std::optional<ResidualBlock> Residuals(const Subject& subject) const override;
  bool MeasuresForce() const override { return !loads.empty(); }
  void Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const override;
  void AddRecordings(AuditedVehicle& audited) const override;
  void CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const override;
  ExperimentResults Results(const Subject& subject, const FitResult& fit) const override;
  /// Loads are no response.
  std::optional<ExperimentResults> Respond(const Subject&, std::optional<Engine>, const WorkHooks&) const override {
    return ExperimentResults();
  }
  /// Nor is a table of them predicted.
  std::string_view Recordings() const override { return ""; }
  bool Reads(const RecordedTable&) const override { return false; }
  std::optional<ExperimentResults> Predict(const Subject&, const PredictionRequest&, const WorkHooks&) const override {
    return std::nullopt;
  }

  StaticLoadPlan plan;
  /// After Load().
  std::vector<MeasuredLoad> loads;
};

}  // namespace fourpost
