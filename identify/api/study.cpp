#include <fourpost/study.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <sstream>

#include "analysis/files/findings.h"
#include "analysis/files/output_folder.h"
#include "analysis/text/number.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/api/inside.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost::api {
namespace {

/// The study of arrays; it marks a folder that may be written again.
constexpr const char* kArraysFile = "arrays.yaml";

/// In double quotes, as YAML and JSON write a name.
std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string FileOf(const std::string& kind, std::size_t index) {
  return kind + "_" + std::to_string(index + 1) + ".csv";
}

void RequireCount(const std::string& what, Eigen::Index count, std::size_t wanted) {
  if (static_cast<std::size_t>(count) != wanted)
    Refuse(kArraysUnequal, {}, {what, std::to_string(count), std::to_string(wanted)});
}

void RequireDeviations(const std::string& what, std::span<const double> values) {
  RequireFinite(what, values);
  if (std::any_of(values.begin(), values.end(), [](double value) { return value < 0; }))
    Refuse(kArrayNegative, {}, {what});
}

/// Throws FaultyInput.
void RequireFiniteIn(const SteppedSineTest& test) {
  const std::string of = " of '" + test.name + "'";
  RequireFinite("frequency_Hz" + of, test.frequency_Hz);
  RequireFinite("amplitude_m" + of, test.amplitude_m);
  for (const auto& [sensor, measured] : test.channels) {
    const std::string what = "channel '" + sensor + "'" + of;
    RequireFinite(what, {reinterpret_cast<const double*>(measured.frf.data()),
                         2 * static_cast<std::size_t>(measured.frf.size())});
    RequireDeviations("the standard deviation of the mean of " + what,
                      {measured.mean_sd.data(), static_cast<std::size_t>(measured.mean_sd.size())});
    RequireFinite("the mean of " + what, {measured.mean.data(), static_cast<std::size_t>(measured.mean.size())});
    const Eigen::VectorXd& sd = measured.relative_sd_at;
    RequireDeviations("the standard deviation of " + what, {sd.data(), static_cast<std::size_t>(sd.size())});
  }
}

std::string UnitOfSensor(const Vehicle& vehicle, const std::string& name) {
  std::vector<std::string> known;
  for (const Sensor& sensor : vehicle.sensors()) {
    if (sensor.name == name) return sensor.unit;
    known.push_back(sensor.name);
  }
  RefuseName("sensor", name, known);
}

std::string SineCsv(const Vehicle& vehicle, const SteppedSineTest& test) {
  RequireFiniteIn(test);
  const std::size_t count = test.frequency_Hz.size();
  if (test.amplitude_m.size() != 1)
    RequireCount("amplitude_m of '" + test.name + "'", static_cast<Eigen::Index>(test.amplitude_m.size()), count);
  const bool has_mean_sd = std::any_of(test.channels.begin(), test.channels.end(),
                                       [](const auto& channel) { return channel.second.mean_sd.size() > 0; });
  std::string text = std::string("frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,") +
                     (has_mean_sd ? "mean_sd," : "") + "unit\n";
  for (const auto& [sensor, measured] : test.channels) {
    RequireCount("channel '" + sensor + "' of '" + test.name + "'", measured.frf.size(), count);
    if (measured.mean.size() > 0)
      RequireCount("the mean of channel '" + sensor + "' of '" + test.name + "'", measured.mean.size(), count);
    if (measured.mean_sd.size() > 0 && measured.mean.size() == 0) Refuse(kMeanSdWithoutMean, {}, {sensor, test.name});
    if (measured.mean_sd.size() > 0)
      RequireCount("the standard deviation of the mean of channel '" + sensor + "' of '" + test.name + "'",
                   measured.mean_sd.size(), count);
    if (measured.relative_sd_at.size() > 0)
      RequireCount("the standard deviation of channel '" + sensor + "' of '" + test.name + "'",
                   measured.relative_sd_at.size(), count);
    const std::string unit = UnitOfSensor(vehicle, sensor);
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const std::complex<double> value = measured.frf[at];
      const double sd = measured.relative_sd_at.size() > 0 ? measured.relative_sd_at[at] : measured.relative_sd;
      const double amplitude = test.amplitude_m.size() == 1 ? test.amplitude_m.front() : test.amplitude_m[i];
      const double degrees = 180 / std::numbers::pi;
      for (const double number : {test.frequency_Hz[i], amplitude}) text += FormatNumber(number) + ',';
      text += sensor;
      for (const double number : {std::abs(value), degrees * std::arg(value), sd * std::abs(value), degrees * sd})
        text += ',' + FormatNumber(number);
      text += ',' + (measured.mean.size() > 0 ? FormatNumber(measured.mean[at]) : "");
      if (has_mean_sd) text += ',' + (measured.mean_sd.size() > 0 ? FormatNumber(measured.mean_sd[at]) : "");
      text += ',' + unit + '\n';
    }
  }
  return text;
}

struct Column {
  std::string name;
  std::string unit;
  const Eigen::VectorXd* values = nullptr;
};

std::string TimeCsv(double rate_Hz, const std::vector<Column>& columns) {
  std::string head = "time";
  std::string units = "s";
  if (!(rate_Hz > 0)) Refuse(kRateNotPositive, {}, {FormatNumber(rate_Hz)});
  const auto count = columns.empty() ? std::size_t{0} : static_cast<std::size_t>(columns.front().values->size());
  for (const Column& column : columns) {
    RequireCount("'" + column.name + "'", column.values->size(), count);
    RequireFinite("'" + column.name + "'", {column.values->data(), count});
    head += ',' + column.name;
    units += ',' + column.unit;
  }
  std::string text = head + '\n' + units + '\n';
  for (std::size_t k = 0; k < count; ++k) {
    text += FormatNumber(static_cast<double>(k) / rate_Hz);
    for (const Column& column : columns) text += ',' + FormatNumber((*column.values)[static_cast<Eigen::Index>(k)]);
    text += '\n';
  }
  return text;
}

/// From the lowest to the highest frequency of all.
std::pair<double, double> RangeOf(const std::vector<SteppedSineTest>& tests) {
  std::pair<double, double> range = {std::numeric_limits<double>::infinity(), 0};
  for (const SteppedSineTest& test : tests)
    for (const double frequency : test.frequency_Hz)
      range = {std::min(range.first, frequency), std::max(range.second, frequency)};
  return range;
}

std::string Use(bool is_validation) { return is_validation ? "    use: validation\n" : ""; }

/// The study's text, and the files that it names.
class Writer {
 public:
  Writer(const Study& study, const Vehicle& vehicle, OutputFolder& folder)
      : study_(study), vehicle_(vehicle), folder_(folder) {}

  void AddSines(const std::vector<SteppedSineTest>& tests) {
    if (tests.empty()) return;
    text_ += "recordings:\n";
    std::vector<std::string> channels;
    for (std::size_t i = 0; i < tests.size(); ++i) {
      const std::string file = FileOf("stepped_sine", i);
      SteppedSineTest test = tests[i];
      if (test.name.empty()) test.name = file;
      folder_.Add(file, SineCsv(vehicle_, test));
      text_ += "  - name: " + Quoted(test.name) + "\n    file: " + file + "\n    posts: " + Posts(tests[i].posts) +
               '\n' + Use(tests[i].is_validation);
      for (const auto& [sensor, measured] : tests[i].channels)
        if (std::find(channels.begin(), channels.end(), sensor) == channels.end()) channels.push_back(sensor);
    }
    text_ += "channels:\n";
    for (const std::string& channel : channels) text_ += "  " + Quoted(channel) + ": " + Quoted(channel) + '\n';
    const std::pair<double, double> band = study_.band_Hz.value_or(RangeOf(tests));
    text_ += "band: [" + FormatNumber(band.first) + " Hz, " + FormatNumber(band.second) + " Hz]\n";
  }

  void AddHistories(const std::vector<TimeHistoryTest>& tests) {
    if (tests.empty()) return;
    text_ += "histories:\n";
    for (std::size_t i = 0; i < tests.size(); ++i) {
      const TimeHistoryTest& test = tests[i];
      const std::string file = FileOf("time_history", i);
      std::string posts;
      std::string channels;
      std::vector<Column> columns;
      for (const auto& [post, values] : test.posts) {
        columns.push_back({"post_" + post, "m", &values});
        posts += "      " + Quoted(post) + ": " + Quoted("post_" + post) + '\n';
      }
      for (const auto& [sensor, values] : test.channels) {
        columns.push_back({sensor, UnitOfSensor(vehicle_, sensor), &values});
        channels += "      " + Quoted(sensor) + ": " + Quoted(sensor) + '\n';
      }
      folder_.Add(file, TimeCsv(test.rate_Hz, columns));
      text_ += "  - name: " + Quoted(test.name.empty() ? file : test.name) + "\n    file: " + file + '\n' +
               Use(test.is_validation) + FilterText(test.filter) + NoiseText(test.noise) + "    posts:\n" + posts +
               "    channels:\n" + channels;
    }
  }

  void AddStaticLoads(const std::map<std::string, StaticLoad>& loads) {
    if (loads.empty()) return;
    std::string table = "quantity,value,sd,unit\n";
    text_ += "static_loads:\n  file: static_loads.csv\n  tyres:\n";
    for (const auto& [tyre, load] : loads) {
      table += tyre + ',' + FormatNumber(load.load_N) + ',' + FormatNumber(load.sd_N) + ",N\n";
      text_ += "    " + Quoted(tyre) + ": " + Quoted(tyre) + '\n';
    }
    folder_.Add("static_loads.csv", table);
  }

  void AddBench(const std::vector<BenchTest>& tests) {
    if (tests.empty()) return;
    std::string fitted;
    std::string kept;
    for (std::size_t i = 0; i < tests.size(); ++i) {
      const std::string file = FileOf("bench", i);
      folder_.Add(file, TimeCsv(tests[i].rate_Hz,
                                {{"displacement", "m", &tests[i].displacement}, {"force", "N", &tests[i].force}}));
      std::string& list = tests[i].is_validation ? kept : fitted;
      list += (list.empty() ? "" : ", ") + file;
    }
    text_ += "bench:\n  model_error: " + FormatNumber(100 * study_.model_error.bench) + " %\n  recordings: [" + fitted +
             "]\n";
    if (!kept.empty()) text_ += "  validation: [" + kept + "]\n";
    is_bench_ = true;
  }

  std::string Text(bool has_sines, bool has_histories) const {
    std::string text = "vehicle: vehicle.urdf\n" + text_;
    if (!is_bench_) {
      const ModelError& error = study_.model_error;
      text += "model_error: {";
      if (has_sines)
        text += "gain_dB: " + FormatNumber(error.gain_dB) + ", phase: " + FormatNumber(error.phase_deg) +
                " deg, floor: " + FormatNumber(error.floor) + ", mean: " + FormatNumber(error.mean_m, 3) + " mm" +
                (has_histories ? ", " : "");
      if (has_histories) text += "history: " + FormatNumber(100 * error.history) + " %";
      text += "}\n";
    }
    std::string free;
    for (const std::string& name : study_.free) free += (free.empty() ? "" : ", ") + name;
    if (!free.empty()) text += "free: [" + free + "]\n";
    return text + "search: {seed: " + std::to_string(study_.seed) +
           ", evaluations: " + std::to_string(study_.evaluations) + ", starts: " + std::to_string(study_.starts) +
           "}\n";
  }

 private:
  static std::string FilterText(const std::optional<LowPass>& filter) {
    if (!filter) return "";
    return "    filter: {order: " + std::to_string(filter->order) + ", cutoff: " + FormatNumber(filter->cutoff_Hz) +
           " Hz}\n";
  }

  std::string NoiseText(const std::map<std::string, double>& noise) const {
    std::string text;
    for (const auto& [sensor, sd] : noise)
      text += "      " + Quoted(sensor) + ": " + FormatNumber(sd) + ' ' + UnitOfSensor(vehicle_, sensor) + '\n';
    return text.empty() ? "" : "    noise:\n" + text;
  }

  /// A pattern, or shares of posts as a map.
  static std::string Posts(const std::string& posts) {
    if (posts.find('=') == std::string::npos) return posts;
    std::string map = "{";
    std::istringstream shares(posts);
    for (std::string share; std::getline(shares, share, ',');) {
      const std::size_t sign = share.find('=');
      map += (map.size() > 1 ? ", " : "") + share.substr(0, sign) + ": " + share.substr(sign + 1);
    }
    return map + "}";
  }

  const Study& study_;
  const Vehicle& vehicle_;
  OutputFolder& folder_;
  std::string text_;
  bool is_bench_ = false;
};

}  // namespace

std::string Study::AddedToFile() const {
  const Study untouched(*file_);
  std::string added;
  const auto name = [&](bool is_set, const char* what) {
    if (is_set) added += (added.empty() ? "" : ", ") + std::string(what);
  };
  name(!sines_.empty() || !histories_.empty() || !benches_.empty(), "experiments");
  name(!static_loads.empty(), "static_loads");
  name(!free.empty(), "free");
  name(band_Hz.has_value(), "band_Hz");
  name(model_error != untouched.model_error, "model_error");
  name(seed != untouched.seed, "seed");
  name(evaluations != untouched.evaluations, "evaluations");
  name(starts != untouched.starts, "starts");
  return added;
}

std::filesystem::path Study::Write(const std::filesystem::path& folder) const {
  return Guarded([&]() -> std::filesystem::path {
    if (file_) {
      if (const std::string added = AddedToFile(); !added.empty()) Refuse(kStudyOfFile, {}, {file_->string(), added});
      return *file_;
    }
    if (sines_.empty() && histories_.empty() && benches_.empty()) Refuse(kStudyEmpty, {});
    OutputFolder output(folder, "", kArraysFile);
    Writer writer(*this, *vehicle_, output);
    writer.AddSines(sines_);
    writer.AddHistories(histories_);
    writer.AddStaticLoads(static_loads);
    writer.AddBench(benches_);
    const fourpost::Vehicle& vehicle = Inside::Of(*vehicle_);
    output.Add("vehicle.urdf", VehicleTextWithValues(vehicle, vehicle.ParameterValues(), folder));
    output.Add(kArraysFile, writer.Text(!sines_.empty(), !histories_.empty()));
    output.Commit();
    return folder / kArraysFile;
  });
}

}  // namespace fourpost::api
