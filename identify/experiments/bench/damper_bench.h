#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "identify/experiments/bench/bench_data.h"
#include "identify/experiments/bench/bench_study.h"
#include "identify/experiments/experiment.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// A damper on its bench: 'bench' of a study.
class DamperBench : public Experiment {
 public:
  static constexpr std::array<std::string_view, 1> kKeys = {"bench"};

  DamperBench() = default;

  /// Adds every fault to the study's diagnostics.
  static std::unique_ptr<Experiment> Read(const StrictMap& study);

  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<DamperBench>(*this); }
  std::vector<ExperimentFile> Files() const override;
  void LeaveOutValidation() override { plan.validation.clear(); }
  std::vector<double> Settings() const override;
  void Load(const Subject& subject, Diagnostics& diagnostics) override;
  void AddTo(Sha256& data, Sha256& settings) const override;
  std::optional<ResidualBlock> Residuals(const Subject& subject) const override;
  bool MeasuresForce() const override { return true; }
  ExperimentResults Results(const Subject& subject, const FitResult& fit) const override;
  std::optional<ExperimentResults> Respond(const Subject& subject, std::optional<Engine> engine,
                                           const WorkHooks& hooks) const override;
  std::string_view Recordings() const override {
    return "a damper on its bench, with columns of its displacement and force";
  }
  bool Reads(const RecordedTable& table) const override;
  std::optional<ExperimentResults> Predict(const Subject& subject, const PredictionRequest& request,
                                           const WorkHooks& hooks) const override;

  /// The study's.
  std::string file;
  BenchStudy plan;
  /// After Load().
  BenchData data;
};

}  // namespace fourpost
