#include "identify/experiments/bench/bench_data.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "identify/experiments/bench/bench_cycle.h"
#include "identify/experiments/bench/bench_residuals.h"
#include "identify/experiments/bench/bench_result.h"
#include "identify/experiments/bench/findings.h"
#include "identify/fit/fit.h"
#include "identify/run/study_fit.h"
#include "identify/study/loaded_study.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"
#include "tests/temporary_folder.h"
#include "vehicles/bench/findings.h"

namespace fourpost::bench_data_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kBump = 800;
constexpr double kRebound = 2000;

/// Rod in tube with a bilinear damper.
constexpr const char* kVehicle = R"(<?xml version="1.0"?>
<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1">
  <link name="tube"/>
  <link name="rod"><inertial><mass value="1"/>
    <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/>
    <origin xyz="0.4 0 0"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
  <fp:parameter name="bump" value="800 N*s/m" lower="100 N*s/m" upper="5 kN*s/m" precision="1 N*s/m" source="test"/>
  <fp:parameter name="rebound" value="2 kN*s/m" lower="100 N*s/m" upper="5 kN*s/m" precision="1 N*s/m" source="test"/>
  <fp:damper name="strut" parent="tube" child="rod"><bilinear bump="$bump" rebound="$rebound"/></fp:damper>
</robot>
)";

constexpr const char* kStudy =
    "vehicle: damper.urdf\nbench:\n  rig_filter: {order: 4, cutoff: 30 Hz}\n  recordings: [sine.csv]\n"
    "  validation: [fast.csv]\n";

/// Where nothing is kept for validation, whose faults end no fit.
constexpr const char* kBothFitted =
    "vehicle: damper.urdf\nbench:\n  rig_filter: {order: 4, cutoff: 30 Hz}\n  recordings: [sine.csv, fast.csv]\n";

/// The bench of kVehicle, 2 s, through the rig's filter. `force_of`: the amplitude that the force is of, in place of
/// the one recorded.
std::string Recording(double frequency_Hz, double amplitude_m, double force_of = 0, int order = 4) {
  const double w = 2 * std::numbers::pi * frequency_Hz;
  std::vector<double> x;
  std::vector<double> force;
  for (int k = 0; k < 1000; ++k) {
    const double t = 0.002 * k;
    const double rise = 0.5 - 0.5 * std::cos(std::numbers::pi * std::min(1.0, 2 * t));
    const double slope = t < 0.5 ? std::numbers::pi * std::sin(2 * std::numbers::pi * t) : 0;
    const double v = amplitude_m * (rise * w * std::cos(w * t) + slope * std::sin(w * t));
    x.push_back(amplitude_m * rise * std::sin(w * t));
    force.push_back((force_of > 0 ? force_of / amplitude_m : 1) * (v > 0 ? kRebound : kBump) * v);
  }
  const LowPass filter(order, 30, 500);
  filter.Apply(x);
  filter.Apply(force);
  std::ostringstream text;
  text.precision(12);
  text << "time,displacement,force\ns,m,N\n";
  for (std::size_t k = 0; k < x.size(); ++k)
    text << 0.002 * static_cast<double>(k) << ',' << x[k] << ',' << force[k] << '\n';
  return text.str();
}

/// The force of a recording cut off at 60 N.
std::string Clipped(const std::string& recording) {
  std::istringstream lines(recording);
  std::string text;
  std::string line;
  for (int row = 0; std::getline(lines, line); ++row) {
    const std::size_t comma = line.rfind(',');
    if (row >= 2)
      line = line.substr(0, comma + 1) + std::to_string(std::clamp(std::stod(line.substr(comma + 1)), -60.0, 60.0));
    text += line + '\n';
  }
  return text;
}

class BenchDataTest : public testing::Test {
 protected:
  BenchDataTest() {
    folder_.Write("damper.urdf", kVehicle);
    folder_.Write("sine.csv", Recording(2, 0.01));
    folder_.Write("fast.csv", Recording(20, 0.001));
  }
  std::optional<LoadedStudy> Load(const std::string& study = kStudy) {
    return LoadStudy(folder_.Write("study.yaml", study), diagnostics_);
  }
  Diagnostics Faults(const std::string& study = kStudy) {
    diagnostics_ = {};
    EXPECT_FALSE(Load(study));
    return diagnostics_;
  }
  /// Of finding `item`: the file's name.
  std::string FileOf(const Diagnostics& found, std::size_t item) const {
    return std::filesystem::path(found.items().at(item).place.file).filename().string();
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

// Measured and modelled forces have passed the same filter, and the displacement none: what is left is the spline's
// rate and the kink at rest between two samples.
TEST_F(BenchDataTest, TheModelThatMadeARecordingMissesNothingOfIt) {
  const std::optional<LoadedStudy> study = Load();
  ASSERT_TRUE(study) << diagnostics_.Format();
  const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
  for (const auto* recordings : {&Bench(*study).data.fitted, &Bench(*study).data.validation}) {
    const auto modelled = ModelledRecordings(damper, *recordings, study->vehicle.ParameterValues());
    EXPECT_LT(BenchMisfits(modelled)[0].nmse_percent, 1e-4) << recordings->front().name;
    EXPECT_GT(BenchMisfits(modelled)[0].vaf_percent, 99.9999);
  }
}

/// `row_of`: of every row of a recording behind names and units, its number and what stands in it.
template <typename RowOf>
std::string EveryRow(const std::string& recording, const RowOf& row_of) {
  std::istringstream lines(recording);
  std::string text;
  std::string line;
  for (int row = -2; std::getline(lines, line); ++row) text += (row < 0 ? line : row_of(row, line)) + '\n';
  return text;
}

// What is wrong before the window is cut off unseen, and the sign of one recording is not that of the others.
TEST_F(BenchDataTest, ARecordingIsCutAndTakesItsOwnSign) {
  folder_.Write("sine.csv", EveryRow(Recording(2, 0.01), [](int row, const std::string& line) {
                  const std::size_t comma = line.rfind(',');
                  const double force = row < 300 ? 1e4 : -std::stod(line.substr(comma + 1));
                  return line.substr(0, comma + 1) + std::to_string(force);
                }));
  const std::optional<LoadedStudy> study = Load(Replace(
      kStudy, "[sine.csv]", "\n    - {file: sine.csv, start: 0.7 s, end: 1.9 s, force: {channel: force, sign: -1}}"));
  ASSERT_TRUE(study) << diagnostics_.Format();
  const BenchRecording& cut = Bench(*study).data.fitted.at(0);
  EXPECT_NEAR(cut.start_s, 0.7, 1e-12);
  EXPECT_EQ(cut.force.size(), 601);
  EXPECT_THAT(cut.preparations, testing::ElementsAre("cut to 0.7 .. 1.9 s"));
  const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
  const auto modelled = ModelledRecordings(damper, Bench(*study).data.fitted, study->vehicle.ParameterValues());
  // Of the filter, which has not seen the time before, a thousandth of the force is left.
  EXPECT_LT(BenchMisfits(modelled)[0].nmse_percent, 100 * 1e-6);
  EXPECT_THAT(Faults(Replace(kBothFitted, "[sine.csv,", "[{file: sine.csv, start: 1.99 s},")),
              Reports(kBenchWindowOutside, 0, {"16", "0", "1.998"}));
}

// Forces that are bridged do not count, whatever the interpolation makes of them.
TEST_F(BenchDataTest, SamplesInAGapHaveNoWeight) {
  folder_.Write("sine.csv", EveryRow(Recording(2, 0.01), [](int row, const std::string& line) {
                  return row > 600 && row < 700 ? line.substr(0, line.rfind(',') + 1) : line;
                }));
  EXPECT_FALSE(Load());
  diagnostics_ = {};
  const std::optional<LoadedStudy> study =
      Load(Replace(kStudy, "[sine.csv]", "\n    - {file: sine.csv, bridge: 250 ms}"));
  ASSERT_TRUE(study) << diagnostics_.Format();
  const ResidualBlock block = BenchResiduals(study->vehicle, Bench(*study).data, 0.05);
  const Evaluation evaluation = block.evaluate(study->vehicle.ParameterValues(), Deadline());
  // As TheModelThatMadeARecordingMissesNothingOfIt, in shares of the model error.
  EXPECT_LT(evaluation.residuals.cwiseAbs().maxCoeff(), 1e-2 / 0.05);
  EXPECT_EQ(std::count(Bench(*study).data.fitted.at(0).is_unknown.begin(),
                       Bench(*study).data.fitted.at(0).is_unknown.end(), 1),
            99);
  // Nor do they count as data: of every eighth sample, those from row 600 on.
  const auto zeros = (evaluation.residuals.array() == 0).count();
  EXPECT_GT(zeros, 0);
  EXPECT_EQ(block.structure.series.at(0).unmeasured, zeros);
  const VehicleObjective objective = study->MakeObjective();
  EXPECT_EQ(objective.unmeasured_count(), zeros);
  FitOptions options = FitOptionsOf(study->study, objective);
  options.stop.max_evaluations = 1;
  EXPECT_EQ(Fit(objective, options).residual_count, evaluation.residuals.size() - zeros);
}

// Nor in the error that is reported: that is as of the samples that were measured, over all.
TEST_F(BenchDataTest, SamplesInAGapAreNoError) {
  folder_.Write("sine.csv", EveryRow(Recording(2, 0.01), [](int row, const std::string& line) {
                  return row > 600 && row < 700 ? line.substr(0, line.rfind(',') + 1) : line;
                }));
  const std::optional<LoadedStudy> study =
      Load(Replace(kStudy, "[sine.csv]", "\n    - {file: sine.csv, bridge: 250 ms}"));
  ASSERT_TRUE(study) << diagnostics_.Format();
  const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
  const auto modelled = ModelledRecordings(damper, Bench(*study).data.fitted, study->vehicle.ParameterValues());
  // As TheModelThatMadeARecordingMissesNothingOfIt; what an interpolation makes up is off by far more.
  EXPECT_LT(BenchMisfits(modelled)[0].nmse_percent, 1e-4);
}

// From a start twice off. What is left of the force, see above, moves a rate by its share: a root of 1e-6.
TEST_F(BenchDataTest, ATwinIsRecoveredThroughAFilterOfAnyOrder) {
  folder_.Write("damper.urdf", Replace(Replace(kVehicle, "800 N*s/m", "1.6 kN*s/m"), "2 kN*s/m", "1 kN*s/m"));
  for (const int order : {1, 2, 3, 5, 7}) {
    folder_.Write("sine.csv", Recording(2, 0.01, 0, order));
    folder_.Write("fast.csv", Recording(20, 0.001, 0, order));
    const std::optional<LoadedStudy> study = Load(Replace(kStudy, "order: 4", "order: " + std::to_string(order)));
    ASSERT_TRUE(study) << diagnostics_.Format();
    const VehicleObjective objective = study->MakeObjective();
    const FitResult fit = Fit(objective, FitOptionsOf(study->study, objective));
    EXPECT_EQ(fit.end, FitEnd::kConverged) << order;
    EXPECT_NEAR(fit.values[0], kBump, 1e-3 * kBump) << order;
    EXPECT_NEAR(fit.values[1], kRebound, 1e-3 * kRebound) << order;
    const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
    EXPECT_LT(BenchMisfits(ModelledRecordings(damper, Bench(*study).data.validation, fit.values))[0].nmse_percent, 1e-4)
        << order;
  }
}

// Without restoring what the filter took, 20 Hz would be another speed and another phase.
TEST_F(BenchDataTest, TheRigsFilterMatters) {
  const std::optional<LoadedStudy> study = Load(Replace(kStudy, "  rig_filter: {order: 4, cutoff: 30 Hz}\n", ""));
  ASSERT_TRUE(study) << diagnostics_.Format();
  const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
  const auto modelled = ModelledRecordings(damper, Bench(*study).data.validation, study->vehicle.ParameterValues());
  EXPECT_GT(BenchMisfits(modelled)[0].nmse_percent, 1);
}

TEST_F(BenchDataTest, ResidualsSumToTheNormalisedError) {
  const std::optional<LoadedStudy> study = Load();
  ASSERT_TRUE(study) << diagnostics_.Format();
  std::vector<double> values = study->vehicle.ParameterValues();
  values[0] = 700;
  const ResidualBlock block = BenchResiduals(study->vehicle, Bench(*study).data, 0.05);
  const Evaluation evaluation = block.evaluate(values, {});
  ASSERT_TRUE(evaluation.ok());
  ASSERT_EQ(evaluation.residuals.size(), block.count);
  const auto modelled =
      ModelledRecordings(BenchDamper(study->vehicle, Bench(*study).data.damper), Bench(*study).data.fitted, values);
  const double per_residual = BenchMisfits(modelled)[0].nmse_percent / 100 / (0.05 * 0.05);
  // A residual for every eighth sample.
  EXPECT_EQ(ResidualStride(Bench(*study).data.fitted[0]), 8);
  EXPECT_NEAR(evaluation.cost() / static_cast<double>(block.count), per_residual, 0.02 * per_residual);
}

TEST_F(BenchDataTest, TellsFaultsOfAllRecordings) {
  folder_.Write("sine.csv", Replace(Recording(2, 0.01), "force", "push"));
  folder_.Write("fast.csv", Replace(Recording(20, 0.001), "s,m,N", "s,N,N"));
  const Diagnostics faults = Faults(kBothFitted);
  EXPECT_THAT(faults, Reports(kChannelColumnMissing, 1, {"'force'"}));
  EXPECT_EQ(FileOf(faults, 0), "sine.csv");
  EXPECT_THAT(faults, Reports(kUnitOfOtherDimension, 2, {"'displacement'", "'N'"}));
  EXPECT_EQ(FileOf(faults, 1), "fast.csv");
}

// 1 mm at 20 Hz told as m spans some 2 m, more than the damper's length; 0.1 mm spans 0.2 m.
TEST_F(BenchDataTest, TellsMillimetresForMetresAtSmallStroke) {
  const auto wrong = [](double amplitude_m) { return Recording(20, 1e3 * amplitude_m, amplitude_m); };
  folder_.Write("fast.csv", wrong(1e-3));
  EXPECT_THAT(Faults(kBothFitted), Reports(kStrokeTooLong, 0, {"1.96 m", "0.4 m"}));
  EXPECT_EQ(FileOf(diagnostics_, 0), "fast.csv");
  folder_.Write("fast.csv", wrong(1e-4));
  EXPECT_THAT(Faults(kBothFitted), Reports(kBenchUnitsTooLarge, 0));
  EXPECT_EQ(FileOf(diagnostics_, 0), "fast.csv");
}

TEST_F(BenchDataTest, TellsMetresForMillimetres) {
  folder_.Write("fast.csv", Replace(Recording(20, 0.001), "s,m,N", "s,mm,N"));
  EXPECT_THAT(Faults(kBothFitted), Reports(kBenchUnitsTooSmall, 0));
  EXPECT_EQ(FileOf(diagnostics_, 0), "fast.csv");
}

// A damper fifty times softer than the file's is another one, not a wrong unit.
TEST_F(BenchDataTest, LeavesDampersThatAreFarFromTheFiles) {
  folder_.Write("fast.csv", Recording(20, 0.001, 2e-5));
  EXPECT_TRUE(Load()) << diagnostics_.Format();
}

TEST_F(BenchDataTest, TellsFilesThatAreMissing) {
  EXPECT_THAT(Faults(Replace(kBothFitted, "fast.csv", "slow.csv")), Reports(kFileNotThere, 4, {"slow.csv"}));
}

// What prepares a recording does not hide that it is clipped.
TEST_F(BenchDataTest, TellsOfClippingInPreparedRecordings) {
  folder_.Write("sine.csv", Clipped(Recording(2, 0.01)));
  for (const char* prepared : {"bridge: 20 ms", "resample: 700 Hz"})
    EXPECT_THAT(Faults(Replace(kStudy, "[sine.csv]", std::string("[{file: sine.csv, ") + prepared + "}]")),
                Reports(kClipped, 0, {"force"}))
        << prepared;
}

TEST_F(BenchDataTest, ALeftOutValidationRecordingEndsNoFit) {
  const auto left_out = [&] {
    diagnostics_ = {};
    const std::optional<LoadedStudy> study = Load();
    EXPECT_TRUE(study) << diagnostics_.Format();
    EXPECT_FALSE(diagnostics_.HasErrors());
    EXPECT_THAT(Bench(*study).data.validation, testing::IsEmpty());
    EXPECT_THAT(study->validation_files, testing::IsEmpty());
    EXPECT_EQ(Bench(*study).left_out().at(0).name, "fast");
    EXPECT_THAT(Bench(*study).left_out().at(0).reason, HasSubstr(diagnostics_.items().at(1).message));
    return diagnostics_;
  };
  folder_.Write("fast.csv", Replace(Recording(20, 0.001), "s,m,N", "s,N,N"));
  EXPECT_THAT(left_out(), AllOf(Reports(kValidationLeftOut, 2, {"'fast'"}),
                                Reports(kUnitOfOtherDimension, 2, {"'displacement'", "'N'"})));
  EXPECT_EQ(FileOf(diagnostics_, 0), "fast.csv");
  folder_.Write("fast.csv", Clipped(Recording(20, 0.001)));
  EXPECT_THAT(left_out(), AllOf(Reports(kValidationLeftOut, 0, {"'fast'"}), Reports(kClipped, 0)));
  std::filesystem::remove(folder_.path() / "fast.csv");
  EXPECT_THAT(left_out(), AllOf(Reports(kValidationLeftOut, 5, {"'fast'"}), Reports(kFileNotThere, 5, {"fast.csv"})));
  // The same of what is fitted ends it.
  EXPECT_THAT(Faults(kBothFitted), Reports(kFileNotThere, 4, {"fast.csv"}));
}

TEST_F(BenchDataTest, TellsDampersThatAreMissing) {
  EXPECT_THAT(Faults(Replace(kStudy, "bench:\n", "bench:\n  damper: strud\n")),
              Reports(kBenchDamperUnknown, 3, {"'strud'", "'strut'"}));
}

TEST_F(BenchDataTest, TellsCutoffsBeyondTheSamplingRate) {
  EXPECT_THAT(Faults(Replace(kStudy, "30 Hz", "300 Hz")),
              Reports(kSampledTooSlowly, 0, {"sine.csv", "500 Hz", "300 Hz", "1200 Hz"}));
  // The remedy helps: four samples a period are taken.
  diagnostics_ = {};
  EXPECT_TRUE(Load(Replace(kStudy, "30 Hz", "125 Hz"))) << diagnostics_.Format();
}

// A linear dashpot is its own equivalent; a bilinear one has the mean of its rates at every frequency.
TEST_F(BenchDataTest, CyclesTellEquivalentDamping) {
  const std::optional<LoadedStudy> study = Load();
  ASSERT_TRUE(study) << diagnostics_.Format();
  const BenchDamper damper(study->vehicle, Bench(*study).data.damper);
  const auto modelled = ModelledRecordings(damper, Bench(*study).data.validation, study->vehicle.ParameterValues());
  const std::vector<LinearEquivalent> cycles = LinearEquivalents(modelled[0]);
  ASSERT_GT(cycles.size(), 30);
  // In the middle, the sine has grown up; 25 samples a cycle err by less than 1 %.
  const LinearEquivalent& cycle = cycles[25];
  EXPECT_NEAR(cycle.frequency_Hz, 20, 0.02);
  EXPECT_NEAR(cycle.Damping(cycle.modelled), 0.5 * (kBump + kRebound), 0.01 * kRebound);
  EXPECT_NEAR(cycle.Damping(cycle.measured), cycle.Damping(cycle.modelled), 2);
}

/// Recording(2, 0.01) with these added.
std::string Offset(double displacement_m, double force_N) {
  std::istringstream lines(Recording(2, 0.01));
  std::ostringstream text;
  text.precision(12);
  std::string line;
  for (int row = 0; std::getline(lines, line); ++row) {
    double t = 0;
    double x = 0;
    double force = 0;
    if (row < 2 || std::sscanf(line.c_str(), "%lf,%lf,%lf", &t, &x, &force) != 3) text << line << '\n';
    else text << t << ',' << x + displacement_m << ',' << force + force_N << '\n';
  }
  return text.str();
}

TEST_F(BenchDataTest, TellsAnOffsetOfTheForceThatNoGasExplains) {
  folder_.Write("sine.csv", Offset(0, 200));
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_, Reports(kForcePulls, 0, {"force is 2"}));
  diagnostics_ = {};
  folder_.Write("sine.csv", Offset(0, -200));
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_, Reports(kForcePushes, 0));
  diagnostics_ = {};
  folder_.Write("sine.csv", Offset(0, 200));
  // Legitimate of gas, whose force a fit finds.
  const std::string law = "rebound=\"$rebound\"/>";
  std::string vehicle = kVehicle;
  vehicle.replace(vehicle.find(law), law.size(), law + "<gas force=\"1 N\" stiffness=\"1 N/m\"/>");
  folder_.Write("damper.urdf", vehicle);
  ASSERT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
}

// The window is of no whole cycles. Where a damper is does not matter to its laws of speed, but to a spring beside it.
TEST_F(BenchDataTest, TellsAnOffsetOfTheDisplacementWhereItMatters) {
  folder_.Write("sine.csv", Offset(0.05, 0));
  ASSERT_TRUE(Load());
  EXPECT_EQ(diagnostics_.Format(), "");
  const std::string law = "rebound=\"$rebound\"/>";
  std::string vehicle = kVehicle;
  vehicle.replace(vehicle.find(law), law.size(), law + "<gas force=\"1 N\" stiffness=\"2 N/mm\"/>");
  folder_.Write("damper.urdf", vehicle);
  ASSERT_TRUE(Load());
  EXPECT_THAT(diagnostics_, Reports(kDisplacementOffset, 0, {"0.049"}));
}

}  // namespace
}  // namespace fourpost::bench_data_test
