#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "identify/study_file/calibration.h"
#include "identify/study_file/control.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

class KnownAnswers;

/// The vehicle that is tested, and what its study says of it. The vehicle and the list must outlive it. To be used by
/// one thread.
class Subject {
 public:
  /// `free`: parameters to fit, as indices into Vehicle::parameters.
  Subject(const Vehicle& vehicle, const std::vector<std::size_t>& free, std::filesystem::path study_file,
          double deadline_s = std::numeric_limits<double>::infinity())
      : vehicle_(vehicle), free_(free), study_file_(std::move(study_file)), deadline_s_(deadline_s) {}

  const Vehicle& vehicle() const { return vehicle_; }
  const std::vector<std::size_t>& free() const { return free_; }
  /// For findings.
  const std::filesystem::path& study_file() const { return study_file_; }
  /// Which parameters follow a recording's setting.
  const Control& control() const { return control_; }
  void FollowControl(Control control) { control_ = std::move(control); }
  /// What is not exactly known of the instruments.
  const std::vector<Calibration>& calibrations() const { return calibrations_; }
  void Calibrate(std::vector<Calibration> calibrations) { calibrations_ = std::move(calibrations); }
  /// What one evaluation may take.
  double deadline_s() const { return deadline_s_; }
  /// Whether a steady motion that no balance finds is found by time integration, for a hundred times as much.
  bool integrates() const { return integrates_; }
  void LeaveOutIntegration() { integrates_ = false; }

  /// Of the vehicle at one set of values; null: nothing is remembered.
  const std::shared_ptr<KnownAnswers>& known_answers() const { return known_answers_; }
  void Remember(std::shared_ptr<KnownAnswers> answers) { known_answers_ = std::move(answers); }

  /// The equations in independent coordinates, made when first asked for. Throws FaultyInput when the vehicle cannot be
  /// assembled or held.
  const std::shared_ptr<const CondensedVehicle>& Condensed() const {
    if (!condensed_) condensed_ = std::make_shared<const CondensedVehicle>(vehicle_);
    return condensed_;
  }

 private:
  const Vehicle& vehicle_;
  const std::vector<std::size_t>& free_;
  std::filesystem::path study_file_;
  double deadline_s_;
  bool integrates_ = true;
  Control control_;
  std::vector<Calibration> calibrations_;
  std::shared_ptr<KnownAnswers> known_answers_;
  mutable std::shared_ptr<const CondensedVehicle> condensed_;
};

}  // namespace fourpost
