#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "analysis/text/diagnostics.h"
#include "identify/audit/audit.h"
#include "identify/experiments/subject.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/study/fitted_files.h"
#include "identify/study/study.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Which parameters of the vehicle follow the settings that the study's recordings state.
Control ControlOf(const Study& study, const Vehicle& vehicle);

/// A study with everything it names: its vehicle, and its experiments with their recordings.
struct LoadedStudy {
  Study study;
  Vehicle vehicle;
  /// Parameters to fit, as indices into Vehicle::parameters.
  std::vector<std::size_t> free;
  /// Values in place of those of the files, as options have them.
  std::vector<std::string> set = {};
  /// As they were read: a file may change while a fit runs.
  std::vector<FileDigest> fitted_files = {};
  std::vector<FileDigest> validation_files = {};

  /// Refers to this study, which must outlive it.
  Subject MakeSubject() const {
    Subject subject(vehicle, free, study.file, study.search.deadline_s);
    subject.FollowControl(ControlOf(study, vehicle));
    subject.Calibrate(study.calibrations);
    return subject;
  }

  /// Whether the cost weighs by noise, so that a fit has standard deviations.
  bool HasDeviations() const;

  /// What experiments need once before a fit. Throws FaultyInput.
  void Prepare(const WorkHooks& hooks = {});

  /// As a fit that ends with these values of the free parameters: experiments that ask for it add what the full
  /// geometry does there. False where the user stops it. After Prepare().
  bool CorrectAt(const Eigen::VectorXd& fitted, const WorkHooks& hooks);

  /// The misfit over all experiments. Throws FaultyInput when the vehicle cannot be assembled or held.
  VehicleObjective MakeObjective() const { return MakeObjective(MakeSubject()); }
  /// Of a subject of this study.
  VehicleObjective MakeObjective(const Subject& subject) const;

  /// The study, the vehicle, the files of its curves and every file of its experiments.
  std::vector<std::filesystem::path> InputFiles() const;
};

/// Reads a study, its vehicle and its recordings. Adds every fault of all of them to `diagnostics`; nothing when there
/// was an error. Recordings for validation that have a fault are left out, with a warning.
/// `set`: values of parameters, "k_front=40kN/m", in place of those of study and vehicle; faults name --set.
std::optional<LoadedStudy> LoadStudy(const std::filesystem::path& file, Diagnostics& diagnostics,
                                     const std::vector<std::string>& set = {});
/// Throws FaultyInput instead, and drops warnings.
LoadedStudy LoadSoundStudy(const std::filesystem::path& file);

/// The same of a text, the content of `file`.
std::optional<LoadedStudy> LoadStudyText(const std::string& text, const std::filesystem::path& file,
                                         Diagnostics& diagnostics);

/// Implausible recordings, at the values of the vehicle's file, as warnings; posts that certainly move otherwise than
/// stated, and channels that are certainly wired wrongly, as `wrong_posts`. Returns the audit of the rig where there is
/// one, and posts and wheelpans are as stated. Throws FaultyInput when the vehicle cannot be assembled.
std::optional<Audit> CheckRecordings(const LoadedStudy& study, Severity wrong_posts, Diagnostics& diagnostics);

}  // namespace fourpost
