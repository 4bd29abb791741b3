#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "identify/experiments/experiment.h"
#include "identify/experiments/time_history/full_correction.h"
#include "identify/experiments/time_history/history_data.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "identify/experiments/time_history/history_study.h"
#include "identify/experiments/time_history/kalman_predictor.h"
#include "identify/study_file/model_error.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Recordings over time of a vehicle on moving posts as a study describes them.
struct HistoryPlan {
  /// The study's.
  std::string file;
  std::vector<StudyHistory> histories;
  HistoryCost cost = HistoryCost::kWhitened;
  ModelError model_error;
};

/// Time histories: 'histories', 'cost' and 'model_error' of a study.
class TimeHistories : public Experiment {
 public:
  static constexpr std::array<std::string_view, 3> kKeys = {"histories", "cost", "model_error"};

  TimeHistories() = default;

  /// Adds every fault to the study's diagnostics.
  static std::unique_ptr<Experiment> Read(const StrictMap& study);

  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<TimeHistories>(*this); }
  std::vector<ExperimentFile> Files() const override;
  void LeaveOutValidation() override;
  std::vector<double> Settings() const override;
  void Load(const Subject& subject, Diagnostics& diagnostics) override;
  void AddTo(Sha256& data, Sha256& settings) const override;
  std::optional<ResidualBlock> Residuals(const Subject& subject) const override;
  std::optional<ResidualBlock> UnpreparedResiduals(const Subject& subject) const override;
  bool HasDeviations() const override;
  bool MeasuresForce() const override;
  /// Of a cost by prediction: finds the noise under which the file's values are likeliest, to be held from then on.
  /// Throws FaultyInput where a run of the filter takes longer than the study's deadline.
  void Prepare(const Subject& subject, const WorkHooks& hooks) override;
  void Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const override;
  /// Lines of the spectra of histories that are fitted, eight seconds long and without a release.
  void AddRecordings(AuditedVehicle& audited) const override;
  bool IsAudited() const override;
  Geometry CheckGeometry(const Subject& subject, const std::vector<double>& values, const WorkHooks& hooks) override;
  void Correct() override;
  void CorrectAs(const Experiment& other) override;
  ExperimentResults Results(const Subject& subject, const FitResult& fit) const override;
  std::optional<ExperimentResults> Respond(const Subject& subject, std::optional<Engine> engine,
                                           const WorkHooks& hooks) const override;
  std::string_view Recordings() const override { return "time histories, with a column of times"; }
  bool Reads(const RecordedTable& table) const override;
  std::optional<ExperimentResults> Predict(const Subject& subject, const PredictionRequest& request,
                                           const WorkHooks& hooks) const override;

  HistoryResiduals::Options Options(const Subject& subject) const;

  HistoryPlan plan;
  /// Those to fit, after Load().
  std::vector<MeasuredHistory> fitted;
  /// Those that the fit does not see.
  std::vector<MeasuredHistory> validation;
  /// Of a cost by prediction: one per history, after Prepare().
  std::vector<KalmanNoise> kalman_noise;
  /// Of the integration, one per history, after Prepare(); empty: whoever integrates finds them.
  std::vector<double> steps_s;
  /// What the last CheckGeometry() found of each history to fit.
  std::vector<HistoryCheck> checks;

 private:
  void FindSteps(const Subject& subject);
};

}  // namespace fourpost
