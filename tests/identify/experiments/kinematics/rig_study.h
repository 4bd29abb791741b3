#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "identify/experiments/kinematics/kinematics_rig.h"
#include "identify/study/loaded_study.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/poses/wishbone_on_rubber.h"
#include "vehicles/poses/axle_kinematics.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/kinematics_files.h"

// A double wishbone on a rig: the car as it is, drawn with its true points, and the study of one that is drawn
// otherwise and has shifts as parameters.
namespace fourpost::rig_study {

inline constexpr double kBall_m = 0.003;
inline constexpr double kTie_m = -0.002;
inline constexpr double kBush_Npm = 2.6e6;

inline Vehicle VehicleOf(const std::string& text) {
  Diagnostics findings;
  std::optional<Vehicle> vehicle = ReadVehicleText(text, "axle.urdf", findings);
  EXPECT_EQ(findings.Format(), "");
  return std::move(vehicle).value();
}

inline Vehicle TrueCar() {
  using axle_cars::Vec;
  return VehicleOf(axle_cars::WishboneOnRubber({.upper_ball = axle_cars::kUpper.ball + Vec(0, 0, kBall_m),
                                                .tie_outer = axle_cars::kTrackRod.outer + Vec(0, 0, kTie_m),
                                                .rate = "2.6 kN/mm"}));
}

inline std::string FreeCar() {
  return axle_cars::WishboneOnRubber(
      {.rate = "$k_ball",
       .of_ball = "dz=\"$dz_ball\"",
       .of_tie = "dz=\"$dz_tie\"",
       .tags = "<fp:parameter name=\"dz_ball\" value=\"0 mm\" lower=\"-10 mm\" upper=\"10 mm\" precision=\"0.01 mm\" "
               "source=\"drawing\"/>\n"
               "<fp:parameter name=\"dz_tie\" value=\"0 mm\" lower=\"-10 mm\" upper=\"10 mm\" precision=\"0.01 mm\" "
               "source=\"drawing\"/>\n"
               "<fp:parameter name=\"k_ball\" value=\"2 kN/mm\" lower=\"0.5 kN/mm\" upper=\"8 kN/mm\" "
               "precision=\"1 N/mm\" source=\"estimate\"/>\n"});
}

inline const std::string kStudy = R"(vehicle: car.urdf
kinematics:
  - file: wheels.csv
    motion: heave
    noise: {camber: 0.02 deg, toe: 0.01 deg}
  - file: compliance.csv
    motion: lateral
    noise: {toe: 0.003 deg, centre_y: 0.02 mm}
free: all
)";

/// Heave in steps of 20 mm.
inline std::vector<AxleKinematics> Measured(SuspensionRig& rig, const std::vector<double>& values) {
  return KinematicsOf(rig, values, {-0.06, 0.06, 0.02});
}

/// With the tables of the true car, as `fourpost kinematics -o` writes them.
class RigFolder {
 public:
  RigFolder() {
    const Vehicle car = TrueCar();
    SuspensionRig rig(car, {});
    const std::vector<AxleKinematics> axles = Measured(rig, {});
    folder_.Write("car.urdf", FreeCar());
    folder_.Write("wheels.csv", WheelsCsv(rig.suspension(), axles));
    folder_.Write("compliance.csv", ComplianceCsv(rig.suspension(), axles));
    folder_.Write("ratios.csv", RatiosCsv(rig.suspension(), axles));
  }

  void Write(const std::string& name, const std::string& text) const { folder_.Write(name, text); }

  std::optional<LoadedStudy> Load(const std::string& study, Diagnostics& findings) const {
    return LoadStudy(folder_.Write("study.yaml", study), findings);
  }
  /// Of a study that must read without a finding.
  LoadedStudy Loaded(const std::string& study = kStudy) const {
    Diagnostics findings;
    std::optional<LoadedStudy> loaded = Load(study, findings);
    EXPECT_EQ(findings.Format(), "");
    return std::move(loaded).value();
  }

 private:
  TemporaryFolder folder_;
};

inline KinematicsRig& RigOf(LoadedStudy& study) { return *study.study.experiments.Find<KinematicsRig>(); }

}  // namespace fourpost::rig_study
