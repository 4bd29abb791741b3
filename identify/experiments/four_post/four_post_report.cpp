#include "identify/experiments/four_post/four_post_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/picture_number.h"
#include "analysis/report/shown_number.h"
#include "identify/experiments/four_post/missing_force_section.h"
#include "identify/experiments/four_post/response_remarks.h"
#include "identify/experiments/four_post/response_table.h"
#include "identify/experiments/preparations_html.h"
#include "identify/experiments/shared_curves.h"
#include "identify/study_file/model_error.h"
#include "identify/study_file/result_reader.h"
#include "identify/study_file/study_yaml.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kResponses = "response.csv";
constexpr const char* kMissingForce = "missing_force.svg";

std::vector<ComparedChannel> ChannelsOf(const RunFolder& run) {
  const std::string* text = run.Find(kResponses);
  return text == nullptr ? std::vector<ComparedChannel>() : ReadResponseTable(*text, run.FileNamed(kResponses));
}

/// Something of the wiring would have been seen, and the channels agree.
bool IsWiringCleared(const nlohmann::json& audit) {
  // Beyond it, channels contradict each other for a reason that is no known fault.
  constexpr double kAgree = 2;
  const std::vector<nlohmann::json> resolutions = ListAt(audit, "resolutions");
  return ListAt(audit, "suspicions").empty() && NumberAt(audit, "misfit") <= kAgree &&
         std::any_of(resolutions.begin(), resolutions.end(),
                     [](const nlohmann::json& one) { return std::isfinite(NumberAt(one, "seen_from")); });
}

bool HasNumbers(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

Json ChannelJson(const ComparedChannel& channel) {
  Json json = {{"recording", channel.recording},
               {"name", channel.name},
               {"unit", channel.unit},
               {"frequency_Hz", PictureNumbers(channel.frequency_Hz)},
               {"in_band", channel.in_band},
               {"gain_measured", PictureNumbers(channel.gain_measured)},
               {"gain_modelled", PictureNumbers(channel.gain_modelled)},
               {"gain_start", PictureNumbers(channel.gain_start)},
               {"gain_sd", PictureNumbers(channel.gain_sd)},
               {"phase_measured", PictureNumbers(channel.phase_measured_deg)},
               {"phase_modelled", PictureNumbers(channel.phase_modelled_deg)},
               {"phase_start", PictureNumbers(channel.phase_start_deg)},
               {"phase_sd", PictureNumbers(channel.phase_sd_deg)}};
  if (HasNumbers(channel.gain_band)) {
    json["gain_bands"] = {PictureNumbers(channel.gain_band_measured), PictureNumbers(channel.gain_band)};
    json["phase_bands"] = {PictureNumbers(channel.phase_band_measured_deg), PictureNumbers(channel.phase_band_deg)};
  }
  if (HasNumbers(channel.mean_measured)) {
    json["mean_measured"] = PictureNumbers(channel.mean_measured);
    json["mean_modelled"] = PictureNumbers(channel.mean_modelled);
  }
  return json;
}

/// What residuals are weighed by beside the scatter of the repeats, for a page that computes them anew.
Json ModelErrorJson(const RunFolder& run) {
  const std::string* study = run.Find("study.yaml");
  const ModelError error = study ? ModelErrorOf(*study) : ModelError();
  return {{"gain_dB", error.gain_dB}, {"phase_rad", error.phase_rad}, {"mean_m", error.mean_m}, {"floor", error.floor}};
}

/// "0.5 to 12 Hz"
std::string BandText(const nlohmann::json& result) {
  const std::vector<nlohmann::json> band = ListAt(result, "band_Hz");
  if (band.size() != 2 || !band[0].is_number() || !band[1].is_number()) return "";
  return ShownShort(band[0].get<double>(), 4) + " to " + ShownShort(band[1].get<double>(), 4) + " Hz";
}

std::complex<double> Phasor(double gain, double phase_deg) {
  const double phase = phase_deg * std::numbers::pi / 180;
  return {gain * std::cos(phase), gain * std::sin(phase)};
}

/// Of the channels of a recording that are sensors of the vehicle.
std::vector<ReadingDifference> DifferencesOf(const std::string& recording, const Vehicle& vehicle,
                                             const std::vector<ComparedChannel>& channels) {
  std::vector<ReadingDifference> differences;
  for (const ComparedChannel& channel : channels) {
    const auto sensor = std::find_if(vehicle.sensors.begin(), vehicle.sensors.end(),
                                     [&](const Sensor& candidate) { return candidate.name == channel.name; });
    if (channel.recording != recording || sensor == vehicle.sensors.end() || channel.phase_measured_deg.empty())
      continue;
    ReadingDifference one{static_cast<std::size_t>(sensor - vehicle.sensors.begin()), {}};
    for (std::size_t i = 0; i < channel.frequency_Hz.size(); ++i)
      one.difference.push_back(Phasor(channel.gain_measured[i], channel.phase_measured_deg[i]) -
                               Phasor(channel.gain_modelled[i], channel.phase_modelled_deg[i]));
    differences.push_back(std::move(one));
  }
  return differences;
}

class ResponseData : public ExperimentData {
 public:
  explicit ResponseData(const RunFolder& run)
      : result_(run.result),
        channels_(ChannelsOf(run)),
        missing_force_(run.Find(kMissingForce)),
        model_error_(ModelErrorJson(run)) {}

  bool empty() const override { return channels_.empty(); }

  Json Drawn() const override {
    Json list = Json::array();
    for (const ComparedChannel& channel : channels_) list.push_back(ChannelJson(channel));
    return {{"responses", std::move(list)}, {"model_error", model_error_}};
  }

  std::vector<ReportSection> Sections() const override {
    std::vector<ReportSection> sections = {
        {"responses", "Frequency responses",
         PreparationsHtml(ListAt(result_, "recordings"), "name") +
             html::Drawn("responses", "The charts need JavaScript; response.svg beside this file shows them."),
         true},
        {"residuals", "Residuals by band",
         html::Drawn("residuals", "The table needs JavaScript; response.csv beside this file has its numbers.")}};
    if (std::string missing = MissingForceHtml(result_, missing_force_); !missing.empty())
      sections.push_back({"missing-force", "What force is missing", std::move(missing)});
    return sections;
  }

  ReportRemarks Remarks() const override {
    const nlohmann::json audit = result_.value("audit", nlohmann::json());
    ReportRemarks remarks = ResponseRemarks(channels_);
    remarks.is_wiring_cleared = IsWiringCleared(audit);
    remarks.modelled = ListAt(result_, "responses");
    remarks.missing_force = MissingForceRemark(result_);
    return remarks;
  }

  /// Of recordings whose posts' motion is known.
  void AddMotions(const Vehicle& vehicle, RecordedMotions& motions) const override {
    for (const nlohmann::json& recording : ListAt(result_, "recordings")) {
      const std::string name = TextAt(recording, "name");
      const auto channel = std::find_if(channels_.begin(), channels_.end(),
                                        [&](const ComparedChannel& candidate) { return candidate.recording == name; });
      if (channel == channels_.end()) continue;
      const nlohmann::json posts = recording.value("posts", nlohmann::json());
      RecordedMotion motion{.name = name, .excitation = {channel->frequency_Hz, channel->post_amplitude_m, {}}};
      for (const Post& post : vehicle.posts) {
        const double share = NumberAt(posts, post.name);
        motion.excitation.shape.push_back(std::isfinite(share) ? share : 0);
      }
      motion.differences = DifferencesOf(name, vehicle, channels_);
      motions.steady.push_back(std::move(motion));
    }
  }

 private:
  const nlohmann::json& result_;
  std::vector<ComparedChannel> channels_;
  /// A picture; null where there is none.
  const std::string* missing_force_;
  Json model_error_;
};

Json SharedResponses(std::span<const RunFolder> runs) {
  std::vector<std::vector<ComparedChannel>> of_runs;
  for (const RunFolder& run : runs) of_runs.push_back(ChannelsOf(run));
  const auto is_same = [](const ComparedChannel& a, const ComparedChannel& b) {
    return a.recording == b.recording && a.name == b.name && AreAlike(a.frequency_Hz, b.frequency_Hz) &&
           AreAlike(a.gain_measured, b.gain_measured) && AreAlike(a.phase_measured_deg, b.phase_measured_deg);
  };
  Json list = Json::array();
  for (const Shared<ComparedChannel>& shared : SharedOf(of_runs, is_same)) {
    const ComparedChannel& first = *shared.front().item;
    const bool has_mean = HasNumbers(first.mean_measured);
    Json lines = Json::array();
    for (const auto& [run, channel] : shared) {
      lines.push_back({{"run", run},
                       {"gain", PictureNumbers(channel->gain_modelled)},
                       {"phase", PictureNumbers(channel->phase_modelled_deg)}});
      if (has_mean) lines.back()["mean"] = PictureNumbers(channel->mean_modelled);
    }
    list.push_back({{"recording", first.recording},
                    {"name", first.name},
                    {"unit", first.unit},
                    {"frequency_Hz", PictureNumbers(first.frequency_Hz)},
                    {"gain_measured", PictureNumbers(first.gain_measured)},
                    {"gain_sd", PictureNumbers(first.gain_sd)},
                    {"phase_measured", PictureNumbers(first.phase_measured_deg)},
                    {"phase_sd", PictureNumbers(first.phase_sd_deg)},
                    {"runs", std::move(lines)}});
    if (has_mean) list.back()["mean_measured"] = PictureNumbers(first.mean_measured);
  }
  return list;
}

class SteadyReport : public ExperimentReport {
 public:
  std::string_view Name() const override { return "stepped sines"; }
  std::vector<std::string> Files() const override { return {kResponses, kMissingForce}; }
  bool IsIn(const RunFolder& run) const override { return run.Find(kResponses) != nullptr; }
  std::unique_ptr<ExperimentData> Read(const RunFolder& run) const override {
    return std::make_unique<ResponseData>(run);
  }
  bool JoinsRecordings() const override { return true; }

  std::map<ChannelGroup, double> RecordingErrors(const nlohmann::json& result) const override {
    std::map<ChannelGroup, double> errors;
    for (const nlohmann::json& recording : ListAt(result, "recordings"))
      if (const double error = NumberAt(recording, "nmse_percent"); std::isfinite(error))
        errors[{TextAt(recording, "name"), BandText(result)}] = error;
    return errors;
  }

  /// The band. Fits of time histories alone once stated one from 0 to 0 Hz.
  nlohmann::json FittedData(const nlohmann::json& result) const override {
    return ListAt(result, "recordings").empty() ? nlohmann::json() : result.value("band_Hz", nlohmann::json());
  }

  void EraseUnseen(nlohmann::json& study) const override {
    if (study.contains("recordings")) study["recordings"] = FittedEntries(study["recordings"]);
  }

  std::vector<ComparedCurves> Compare(std::span<const RunFolder> runs) const override {
    return {{"responses", "Frequency responses", SharedResponses(runs)}};
  }
};

}  // namespace

const ExperimentReport& FourPostReport() {
  static const SteadyReport report;
  return report;
}

}  // namespace fourpost
