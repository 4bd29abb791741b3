#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "identify/audit/audit.h"
#include "identify/experiments/experiment.h"
#include "identify/experiments/four_post/four_post_data.h"
#include "identify/experiments/four_post/response_discrepancy.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Stepped sines on the posts: 'recordings', 'channels', 'band' and 'model_error' of a study.
class FourPost : public Experiment {
 public:
  static constexpr std::array<std::string_view, 4> kKeys = {"recordings", "channels", "band", "model_error"};

  FourPost() = default;
  FourPost(FourPostPlan as_planned, std::vector<MeasuredRun> measured)
      : plan(std::move(as_planned)), runs(std::move(measured)) {}

  /// Adds every fault to the study's diagnostics.
  static std::unique_ptr<Experiment> Read(const StrictMap& study);

  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<FourPost>(*this); }
  std::vector<ExperimentFile> Files() const override;
  void LeaveOutValidation() override { plan.validation.clear(); }
  void CheckFiles(Diagnostics& diagnostics) const override;
  void Load(const Subject& subject, Diagnostics& diagnostics) override;
  void AddTo(Sha256& data, Sha256& settings) const override;
  std::optional<ResidualBlock> Residuals(const Subject& subject) const override;
  bool IsOfSteadyMotions() const override { return !runs.empty(); }
  bool MeasuresForce() const override;
  void Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const override;
  void AddRecordings(AuditedVehicle& audited) const override;
  bool IsAudited() const override { return !runs.empty(); }
  void CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const override;
  ExperimentResults Results(const Subject& subject, const FitResult& fit) const override;
  std::optional<ExperimentResults> Respond(const Subject& subject, std::optional<Engine> engine,
                                           const WorkHooks& hooks) const override;
  std::string_view Recordings() const override {
    return "stepped sines, with a column 'frequency_Hz' or one of times, named as in the recordings of the fit";
  }
  bool Reads(const RecordedTable& table) const override;
  std::optional<ExperimentResults> Predict(const Subject& subject, const PredictionRequest& request,
                                           const WorkHooks& hooks) const override;

  /// Of these recordings alone.
  Audit AuditOf(const Subject& subject) const;

  /// The runs at the frequencies of the band.
  std::vector<MeasuredRun> RunsInBand() const;

  /// The force that the fitted vehicle lacks in the measured motion, as `missing_force` and files of its folder.
  void AddMissingForce(const Subject& subject, const std::vector<double>& values, int threads,
                       ExperimentResults& results) const;

  /// Tables, keys and findings of the runs that were fitted; returns how far they are from the model.
  std::vector<OctaveDiscrepancy> AddFitted(const Subject& subject, const FitResult& fit, const CondensedModel& model,
                                           ExperimentResults& results) const;

  FourPostPlan plan;
  /// To fit, after Load().
  std::vector<MeasuredRun> runs;
  /// Kept for validation, after Load().
  std::vector<MeasuredRun> validation;
};

}  // namespace fourpost
