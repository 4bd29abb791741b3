// Fits laws of dampers to recordings of a real magneto-rheological damper on a shaking table and prints, per test, what
// each of them misses: mr_damper FOLDER > mr_damper.csv. FOLDER holds MAT files with `Tout` [s], `dist` [mm] and `forc`
// [N], as https://github.com/labcontrol-data/mr-damper has them (MIT licence).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/files/mat_file.h"
#include "analysis/files/time_recording.h"
#include "identify/experiments/bench/bench_data.h"
#include "identify/experiments/bench/bench_residuals.h"
#include "identify/experiments/bench/bench_result.h"
#include "identify/fit/fit.h"
#include "identify/residuals/vehicle_objective.h"
#include "vehicles/bench/bench_motion.h"
#include "vehicles/bench/recording_check.h"
#include "vehicles/reader/vehicle_file.h"

namespace {

using namespace fourpost;

const std::vector<double>& Column(const std::vector<MatVector>& vectors, const std::string& name) {
  for (const MatVector& vector : vectors)
    if (vector.name == name) return vector.values;
  throw std::runtime_error("has no " + name);
}

/// Without the first fifth, in which the table starts, and without mean values, which the sensors' zeros decide.
std::vector<double> Used(std::vector<double> values, double si) {
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 5));
  double mean = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (double& value : values) value = si * (value - mean);
  return values;
}

TimeRecording Read(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  const std::optional<std::vector<MatVector>> vectors = ReadMatFile(path, diagnostics);
  if (!vectors) throw FaultyInput(diagnostics);
  const std::vector<double>& times = Column(*vectors, "Tout");
  TimeRecording recording{.step_s = (times.back() - times.front()) / static_cast<double>(times.size() - 1)};
  recording.channels = {Used(Column(*vectors, "dist"), 1e-3), Used(Column(*vectors, "forc"), 1)};
  recording.end_s = recording.step_s * static_cast<double>(recording.samples() - 1);
  return recording;
}

/// A rod in a tube with these elements between.
Vehicle Bench(const std::string& law) {
  const std::string text = R"(<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1"><link name="tube"/>
<link name="rod"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
<limit lower="-1" upper="1" effort="0" velocity="0"/></joint>)" +
                           law + "</robot>";
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicleText(text, "bench.urdf", diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return *std::move(vehicle);
}

std::string Parameter(const std::string& name, const std::string& value, const std::string& upper,
                      const std::string& unit, const std::string& lower = "0") {
  return "<fp:parameter name=\"" + name + "\" value=\"" + value + " " + unit + "\" lower=\"" + lower + " " + unit +
         "\" upper=\"" + upper + " " + unit + "\" precision=\"0.01 " + unit + "\" source=\"validation\"/>\n";
}

const char kEnds[] = R"( parent="tube" child="rod">)";

struct Model {
  const char* name;
  Vehicle vehicle;
};

std::vector<Model> Models() {
  const std::string rates = Parameter("bump", "2000", "100000", "N*s/m") + Parameter("pull", "2000", "100000", "N*s/m");
  const std::string friction = Parameter("friction", "50", "2000", "N") + Parameter("speed", "5", "100", "mm/s", "0.1");
  const std::string bilinear = R"(<bilinear bump="$bump" rebound="$pull"/>)";
  const std::string rubbing = R"(<friction force="$friction" speed="$speed"/>)";
  const std::string damper = std::string("<fp:damper name=\"damper\"") + kEnds;
  return {
      {"linear",
       Bench(Parameter("rate", "2000", "100000", "N*s/m") + damper + R"(<linear rate="$rate"/></fp:damper>)")},
      {"bilinear", Bench(rates + damper + bilinear + "</fp:damper>")},
      {"friction", Bench(rates + friction + damper + bilinear + rubbing + "</fp:damper>")},
      {"friction and stiffness",
       Bench(rates + friction + Parameter("stiffness", "1", "100", "N/mm") + damper + bilinear + rubbing +
             R"(<gas force="0 N" stiffness="$stiffness"/></fp:damper>)")},
  };
}

/// [%]
double Missed(const Vehicle& vehicle, const BenchData& data) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) free.push_back(i);
  const VehicleObjective objective(vehicle, free, {BenchResiduals(vehicle, data, 0.05)});
  FitOptions options;
  options.stop.max_evaluations = 200;
  const FitResult fit = Fit(objective, options);
  if (fit.parameters.empty()) throw std::runtime_error("could not be fitted: " + fit.message);
  return BenchMisfits(ModelledRecordings(BenchDamper(vehicle, 0), data.fitted, fit.values))[0].nmse_percent;
}

void Tell(const std::filesystem::path& path, const std::vector<Model>& models) {
  const TimeRecording recording = Read(path);
  Diagnostics diagnostics;
  const bool good =
      CheckBenchRecording(recording, BenchDamper(models[0].vehicle, 0).length_m(), path.filename(), diagnostics);
  if (!diagnostics.items().empty()) std::fprintf(stderr, "%s\n", diagnostics.Format().c_str());
  if (!good) return;
  BenchData data;
  data.fitted = {{.name = path.stem(),
                  .sample_s = recording.step_s,
                  .motion = MotionThrough(recording.channels[0], recording.step_s),
                  .force = recording.channels[1],
                  .filter = {},
                  .end = recording.samples()}};
  std::printf("%s", path.stem().c_str());
  for (const Model& model : models) std::printf(",%.3g", Missed(model.vehicle, data));
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: mr_damper FOLDER\n", stderr);
    return 2;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
    if (entry.path().extension() == ".mat") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const std::vector<Model> models = Models();
  std::printf("# build/release/mr_damper FOLDER, the recordings of tests/validation/README.md\ntest");
  for (const Model& model : models) std::printf(",%s NMSE [%%]", model.name);
  std::printf("\n");
  for (const std::filesystem::path& file : files) {
    try {
      Tell(file, models);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), error.what());
    }
  }
  return 0;
}
