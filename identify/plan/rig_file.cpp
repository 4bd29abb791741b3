#include "identify/plan/rig_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "analysis/text/known_names.h"
#include "analysis/text/units.h"
#include "identify/plan/findings.h"
#include "identify/study_file/frequency_band.h"
#include "identify/study_file/strict_yaml.h"
#include "identify/study_file/study_yaml.h"
#include "vehicles/requests/amplitude_limits.h"
#include "vehicles/requests/post_shape.h"

namespace fourpost {
namespace {

constexpr double kLowest_Hz = 0.5;
constexpr double kHighest_Hz = 30;
constexpr int kFrequencies = 40;

struct UsualBand {
  const char* name;
  double lower_Hz;
  double upper_Hz;
  int frequencies;
};
/// About the body's modes, between, and about the wheels'. They do not overlap: what the model lacks at a frequency is the
/// same in another run there, and would count as new.
constexpr std::array<UsualBand, 3> kUsualBands = {
    {{" to 4 Hz", kLowest_Hz, 4, 20}, {" 4 to 9 Hz", 4.2, 9, 10}, {" from 9 Hz", 9.5, kHighest_Hz, 15}}};

AmplitudeLaw Scaled(AmplitudeLaw law, double factor) {
  law.displacement_m *= factor;
  law.velocity_mps *= factor;
  law.acceleration_mps2 *= factor;
  return law;
}

std::string ScalarOf(const YAML::Node& node) { return node.IsScalar() ? node.Scalar() : ""; }

std::vector<double> Spread(double lower, double upper, int count) {
  std::vector<double> frequencies;
  for (int i = 0; i < count; ++i)
    frequencies.push_back(lower * std::pow(upper / lower, static_cast<double>(i) / (count - 1)));
  return frequencies;
}

/// What a sensor reads, as `noise` names it.
std::string_view KindOf(Sensor::Type type) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return "acceleration";
    case Sensor::Type::kDisplacement:
    case Sensor::Type::kStrut: return "displacement";
    case Sensor::Type::kLoadCell: return "force";
    case Sensor::Type::kGyro: return "angular_velocity";
  }
  return "";
}

Dimension DimensionOf(std::string_view kind) {
  if (kind == "acceleration") return kAcceleration;
  if (kind == "displacement") return kLength;
  return kind == "force" ? kForce : kFrequency;
}

class RigReader {
 public:
  RigReader(const std::filesystem::path& file, const Vehicle& vehicle, const std::vector<std::size_t>& determined,
            Diagnostics& diagnostics)
      : vehicle_(vehicle), determined_(determined), diagnostics_(diagnostics), rig_(UsualRig(vehicle)) {
    rig_.file = file;
  }

  RigFile Read(const YAML::Node& root) {
    const StrictMap top(
        root, "the rig",
        {"runs", "measurements", "want", "noise", "model_error", "sensors", "cycles", "repeats", "time", "setup"},
        rig_.file.string(), diagnostics_);
    ReadSensors(top);
    if (top.Has("noise")) ReadNoise(top);
    rig_.states_model_error = top.Has("model_error");
    rig_.model_error = ReadModelError(top);
    if (top.Has("runs")) ReadRuns(top);
    if (top.Has("measurements")) ReadMeasurements(top);
    if (top.Has("want")) ReadWanted(top);
    rig_.cycles = static_cast<int>(top.Integer("cycles", 1, 10000).value_or(rig_.cycles));
    rig_.most_repeats = static_cast<int>(top.Integer("repeats", 1, 100).value_or(rig_.most_repeats));
    rig_.time_s = top.Quantity("time", kTime, 1).value_or(rig_.time_s);
    rig_.setup_s = top.Quantity("setup", kTime, 0).value_or(rig_.setup_s);
    return std::move(rig_);
  }

 private:
  void ReadSensors(const StrictMap& top) {
    if (!top.Has("sensors")) return;
    if (!IsList(top, "sensors", "a_body, s_strut")) return;
    rig_.states_sensors = true;
    std::fill(rig_.is_read.begin(), rig_.is_read.end(), false);
    for (const YAML::Node& node : top.Get("sensors")) {
      const std::string name = ScalarOf(node);
      std::vector<std::string> names;
      bool is_known = false;
      for (std::size_t s = 0; s < vehicle_.sensors.size(); ++s) {
        names.push_back(vehicle_.sensors[s].name);
        if (name != names.back()) continue;
        rig_.is_read[s] = is_known = true;
      }
      if (!is_known) top.Fault(node, kRigSensor, {name, KnownNames(name, names)});
    }
  }

  static bool IsList(const StrictMap& top, std::string_view key, const std::string& example) {
    const YAML::Node node = top.Get(key);
    const bool is_list = node.IsSequence() && node.size() > 0;
    if (!is_list) top.FaultOf(key, kRigListNone, {example});
    return is_list;
  }

  void ReadNoise(const StrictMap& top) {
    constexpr std::array<std::string_view, 4> kKinds = {"acceleration", "displacement", "force", "angular_velocity"};
    const StrictMap map = top.Map("noise", {kKinds.begin(), kKinds.end()});
    for (const std::string_view kind : kKinds) {
      const std::optional<double> noise = map.Quantity(kind, DimensionOf(kind), 0);
      if (!noise) continue;
      if (!(*noise > 0)) map.FaultOf(kind, kRigNoiseNone);
      for (std::size_t s = 0; s < vehicle_.sensors.size(); ++s)
        if (KindOf(vehicle_.sensors[s].type) == kind) rig_.noise[s] = *noise;
    }
  }

  void ReadRuns(const StrictMap& top) {
    const YAML::Node node = top.Get("runs");
    if (!node.IsSequence() || node.size() == 0) return top.Fault(node, kRigRunsNone);
    rig_.runs.clear();
    std::set<std::string> names;
    for (const YAML::Node& entry : node) {
      const StrictMap map(entry, "run",
                          {"name", "mode", "band", "frequencies", "amplitude", "velocity", "acceleration"}, top.file(),
                          diagnostics_);
      if (!entry.IsMap()) continue;
      RigRun run = ReadRun(map);
      if (!names.insert(run.name).second) map.Fault(entry, kRigRunTwice, {run.name});
      rig_.runs.push_back(std::move(run));
    }
  }

  RigRun ReadRun(const StrictMap& map) {
    RigRun run;
    const std::string mode = map.Text("mode").value_or("heave");
    Diagnostics faults;
    run.shape = ReadPostShape(mode, vehicle_, faults);
    if (faults.HasErrors()) map.FaultOf("mode", kRigRunMode, {mode, vehicle_.posts.front().name});
    const FrequencyBand usual = {kLowest_Hz, kHighest_Hz};
    const FrequencyBand band = map.Has("band") ? ReadFrequencyBand(map).value_or(usual) : usual;
    run.frequency_Hz = Spread(band.lower_Hz, band.upper_Hz,
                              static_cast<int>(map.Integer("frequencies", 2, 1000).value_or(kFrequencies)));
    const LimitText limits = {.amplitude = map.Text("amplitude").value_or(""),
                              .velocity = map.Text("velocity").value_or(""),
                              .acceleration = map.Text("acceleration").value_or("")};
    // Texts are checked as quantities of the file first, so that faults have a line.
    map.Quantity("amplitude", kLength, 1e-6);
    map.Quantity("velocity", kVelocity, 1e-4);
    map.Quantity("acceleration", kAcceleration, 1e-3);
    run.amplitude = ReadLimits(limits, faults);
    // What a rig's valves can do holds where nothing else is said.
    if (limits.velocity.empty()) run.amplitude.velocity_mps = kUsualAmplitude.velocity_mps;
    if (limits.acceleration.empty()) run.amplitude.acceleration_mps2 = kUsualAmplitude.acceleration_mps2;
    run.name = map.Text("name").value_or(mode + (limits.amplitude.empty() ? "" : ' ' + limits.amplitude) +
                                         (map.Has("band") ? ' ' + BandText(map) : ""));
    return run;
  }

  static std::string BandText(const StrictMap& map) {
    const YAML::Node node = map.Get("band");
    return node.IsSequence() && node.size() == 2 ? ScalarOf(node[0]) + " .. " + ScalarOf(node[1]) : "";
  }

  /// Of a parameter to determine; null, after a fault, for another one.
  const Parameter* ParameterOf(const StrictMap& map, const YAML::Node& node, const std::string& name,
                               const Finding& fault) {
    std::vector<std::string> names;
    for (const std::size_t place : determined_) {
      const Parameter& parameter = vehicle_.parameters[place];
      if (parameter.name == name) return &parameter;
      names.push_back(parameter.name);
    }
    map.Fault(node, fault, {name, KnownNames(name, names)});
    return nullptr;
  }

  /// "2 %" of its value, or a number in its unit; 0 after a fault.
  static double DeviationOf(const StrictMap& map, std::string_view key, const Parameter& parameter) {
    const std::optional<Quantity> quantity = ParseQuantity(ScalarOf(map.Get(key)));
    if (quantity && quantity->si > 0) {
      if (quantity->unit_text == "%") return quantity->si * std::abs(parameter.value);
      if (quantity->unit.dimension == parameter.dimension) return quantity->si;
    }
    map.FaultOf(key, kRigQuantity, {parameter.unit});
    return 0;
  }

  void ReadMeasurements(const StrictMap& top) {
    if (!IsList(top, "measurements", "{parameter: NAME, sd: 1 %, time: 10 min}")) return;
    for (const YAML::Node& entry : top.Get("measurements")) {
      const StrictMap map(entry, "measurement", {"name", "parameter", "sd", "time"}, top.file(), diagnostics_);
      if (!entry.IsMap()) continue;
      DirectMeasurement one{.name = "", .parameter = map.Text("parameter").value_or("")};
      map.Require("sd");
      map.Require("time");
      const Parameter* parameter = ParameterOf(map, entry, one.parameter, kRigMeasurementParameter);
      if (parameter && map.Has("sd")) one.sd = DeviationOf(map, "sd", *parameter);
      one.time_s = map.Quantity("time", kTime, 1).value_or(1);
      one.name = map.Text("name").value_or("measure " + one.parameter);
      rig_.measurements.push_back(std::move(one));
    }
  }

  void ReadWanted(const StrictMap& top) {
    const YAML::Node node = top.Get("want");
    std::vector<std::string> names;
    if (node.IsMap())
      for (const auto& entry : node) names.push_back(ScalarOf(entry.first));
    const StrictMap map = top.Map("want", {names.begin(), names.end()});
    for (const std::string& name : names)
      if (const Parameter* parameter = ParameterOf(map, map.Get(name), name, kRigWanted))
        rig_.wanted.push_back({name, DeviationOf(map, name, *parameter)});
  }

  const Vehicle& vehicle_;
  const std::vector<std::size_t>& determined_;
  Diagnostics& diagnostics_;
  RigFile rig_;
};

}  // namespace

// A car's body settles in a second or two, whatever moves it in some cycles.
double RigFile::SettlingOf(double frequency_Hz) const { return std::max(2 / frequency_Hz, 1.5); }

double RigFile::MeasuringOf(double frequency_Hz) const { return std::max(cycles / frequency_Hz, 2.0); }

double RigFile::TimeOf(const RigRun& run) const {
  double time = setup_s;
  for (const double frequency : run.frequency_Hz) time += SettlingOf(frequency) + MeasuringOf(frequency);
  return time;
}

RigFile UsualRig(const Vehicle& vehicle) {
  RigFile rig;
  rig.noise.assign(vehicle.sensors.size(), std::numeric_limits<double>::quiet_NaN());
  rig.is_read.assign(vehicle.sensors.size(), true);
  if (vehicle.posts.empty()) return rig;
  for (const char* mode : {"heave", "pitch", "roll"}) {
    Diagnostics faults;
    const std::vector<double> shape = ReadPostShape(mode, vehicle, faults);
    if (faults.HasErrors()) continue;
    for (const bool is_large : {true, false})
      for (const UsualBand& band : kUsualBands)
        rig.runs.push_back({.name = std::string(mode) + (is_large ? "" : " small") + band.name,
                            .shape = shape,
                            .frequency_Hz = Spread(band.lower_Hz, band.upper_Hz, band.frequencies),
                            .amplitude = is_large ? kUsualAmplitude : Scaled(kUsualAmplitude, 1.0 / 3),
                            .is_usual = is_large});
  }
  return rig;
}

std::optional<RigFile> ReadRigText(const std::string& text, const std::filesystem::path& file, const Vehicle& vehicle,
                                   const std::vector<std::size_t>& determined, Diagnostics& diagnostics) {
  Diagnostics own;
  const std::optional<YAML::Node> root = ReadYaml(text, file.string(), own);
  std::optional<RigFile> rig;
  if (root) rig = RigReader(file, vehicle, determined, own).Read(*root);
  diagnostics.Add(own);
  if (own.HasErrors()) return std::nullopt;
  return rig;
}

}  // namespace fourpost
