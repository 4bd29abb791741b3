#include "identify/study_context.h"

#include <cctype>
#include <complex>
#include <string>

#include "analysis/sha256.h"
#include "identify/versions.h"

namespace fourpost {
namespace {

/// Without comments, and with one blank for every run of blank space.
std::string Condensed(std::string_view xml) {
  std::string condensed;
  while (!xml.empty()) {
    if (xml.starts_with("<!--")) {
      const std::size_t end = xml.find("-->");
      xml.remove_prefix(end == std::string_view::npos ? xml.size() : end + 3);
      continue;
    }
    const bool is_blank = std::isspace(static_cast<unsigned char>(xml.front())) != 0;
    if (!is_blank || (!condensed.empty() && condensed.back() != ' ')) condensed += is_blank ? ' ' : xml.front();
    xml.remove_prefix(1);
  }
  return condensed;
}

void Add(Sha256& digest, const Scalar& scalar) {
  digest.Add(scalar.value);
  digest.Add(scalar.parameter);
  digest.Add(scalar.factor);
}

std::string DigestOf(const Vehicle& vehicle) {
  Sha256 digest;
  digest.Add(Condensed(vehicle.text));
  for (const Link& link : vehicle.links) {
    Add(digest, link.mass);
    for (const Scalar& component : link.com) Add(digest, component);
    for (const Scalar& component : link.inertia) Add(digest, component);
  }
  return digest.Hex();
}

void Add(Sha256& digest, const MeasuredChannel& channel) {
  digest.Add(static_cast<double>(channel.sensor));
  for (const std::complex<double>& response : channel.response) {
    digest.Add(response.real());
    digest.Add(response.imag());
  }
  digest.Add(channel.radial_sd);
  digest.Add(channel.tangential_sd);
  digest.Add(channel.mean);
  digest.Add(channel.second_harmonic);
}

void Add(Sha256& digest, const Eigen::VectorXd& values) {
  digest.Add(std::vector<double>(values.begin(), values.end()));
}

void Add(Sha256& digest, const MeasuredHistory& history) {
  digest.Add(history.name);
  for (const double number : {history.rate_Hz, history.TimeAt(0), history.filter ? history.filter->cutoff_Hz : 0.0,
                              history.filter ? static_cast<double>(history.filter->order) : 0.0, history.process_sd})
    digest.Add(number);
  std::vector<PostState> posts(history.posts.count);
  for (Eigen::Index k = -history.first; k < history.count; ++k) {
    history.posts.motion(history.TimeAt(k), posts);
    for (const PostState& post : posts) digest.Add(post.height);
  }
  for (const MeasuredSignal& signal : history.signals) {
    digest.Add(static_cast<double>(signal.sensor));
    digest.Add(signal.noise_sd);
    Add(digest, signal.values);
  }
  // An archive of before there were any stays good.
  for (const double value : history.correction.reshaped()) digest.Add(value);
}

void Add(Sha256& digest, const BenchData& bench) {
  digest.Add(static_cast<double>(bench.damper));
  for (const BenchRecording& recording : bench.fitted) {
    digest.Add(recording.name);
    digest.Add(recording.sample_s);
    digest.Add(recording.cutoff_Hz);
    digest.Add(recording.motion.extension);
    digest.Add(recording.force);
  }
}

std::string DataDigest(const LoadedStudy& study) {
  Sha256 digest;
  for (const MeasuredRun& run : InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz)) {
    digest.Add(run.name);
    digest.Add(run.excitation.frequency_Hz);
    digest.Add(run.excitation.amplitude_m);
    digest.Add(run.excitation.shape);
    for (const MeasuredChannel& channel : run.channels) Add(digest, channel);
  }
  for (const MeasuredHistory& history : study.histories) Add(digest, history);
  for (const MeasuredLoad& load : study.data.static_loads) {
    digest.Add(static_cast<double>(load.tyre));
    digest.Add(load.load_N);
    digest.Add(load.sd_N);
  }
  if (study.bench) Add(digest, *study.bench);
  return digest.Hex();
}

std::string SettingsDigest(const LoadedStudy& study) {
  Sha256 digest;
  for (const std::size_t index : study.free) digest.Add(study.vehicle.parameters[index].name);
  const ModelError& error = study.study.model_error;
  for (const double number : {error.gain_dB, error.phase_rad, error.mean_m, error.second_harmonic_m, error.floor})
    digest.Add(number);
  if (!study.histories.empty()) {
    digest.Add(error.history);
    digest.Add(static_cast<double>(study.study.history_cost));
  }
  if (study.study.bench) digest.Add(study.study.bench->model_error);
  digest.Add(study.study.search.deadline_s);
  return digest.Hex();
}

std::string VersionDigest() {
  Sha256 digest;
  for (const auto& [name, version] : Versions()) {
    digest.Add(name);
    digest.Add(version);
  }
  digest.Add(BuildId());
  return digest.Hex();
}

}  // namespace

EvaluationContext ContextOf(const LoadedStudy& study) {
  return {.vehicle = DigestOf(study.vehicle),
          .data = DataDigest(study),
          .settings = SettingsDigest(study),
          .version = VersionDigest()};
}

EvaluationContext ContextOfProblem(std::string_view name, double deadline_s) {
  Sha256 problem;
  problem.Add(name);
  Sha256 settings;
  settings.Add(deadline_s);
  return {.vehicle = problem.Hex(), .data = Sha256().Hex(), .settings = settings.Hex(), .version = VersionDigest()};
}

}  // namespace fourpost
