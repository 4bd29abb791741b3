#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "identify/experiments/experiment.h"
#include "identify/experiments/kinematics/kinematic_sweep.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// Axles on a kinematics and compliance rig: 'kinematics' of a study.
class KinematicsRig : public Experiment {
 public:
  static constexpr std::array<std::string_view, 1> kKeys = {"kinematics"};

  /// Adds every fault to the study's diagnostics.
  static std::unique_ptr<Experiment> Read(const StrictMap& study);

  std::unique_ptr<Experiment> Clone() const override { return std::make_unique<KinematicsRig>(*this); }
  std::vector<ExperimentFile> Files() const override;
  void LeaveOutValidation() override;
  void Load(const Subject& subject, Diagnostics& diagnostics) override;
  void AddTo(Sha256& data, Sha256& settings) const override;
  std::optional<ResidualBlock> Residuals(const Subject& subject) const override;
  /// Wheel loads over travel.
  bool MeasuresForce() const override;
  bool FollowsPoints() const override { return true; }
  void Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const override;
  void CheckFit(const Subject& subject, const FitResult& fit, Diagnostics& diagnostics) const override;
  ExperimentResults Results(const Subject& subject, const FitResult& fit) const override;
  std::optional<ExperimentResults> Respond(const Subject& subject, std::optional<Engine> engine,
                                           const WorkHooks& hooks) const override;
  std::string_view Recordings() const override {
    return "a table of a kinematics and compliance rig, with the study's columns";
  }
  bool Reads(const RecordedTable& table) const override;
  std::optional<ExperimentResults> Predict(const Subject& subject, const PredictionRequest& request,
                                           const WorkHooks& hooks) const override;

  /// The study's.
  std::string file;
  std::vector<KinematicPlan> plans;
  /// After Load(): those that are fitted, and those for validation.
  std::vector<KinematicSweep> fitted;
  std::vector<KinematicSweep> validation;
};

}  // namespace fourpost
