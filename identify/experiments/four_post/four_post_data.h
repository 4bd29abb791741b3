#pragma once

#include <complex>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/measured_response/measured_response.h"
#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"
#include "identify/study_file/channel_source.h"
#include "identify/study_file/left_out_recording.h"
#include "identify/study_file/model_error.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// A recording and the motion of the posts that made it.
struct StudyRecording {
  std::string name;
  std::filesystem::path file;
  /// Post of the vehicle, and how far it moves relative to the reference: -1 for opposite phase. Empty with a pattern.
  std::vector<std::pair<std::string, double>> posts;
  /// One of kPostPatterns, in place of `posts`.
  std::optional<std::string> pattern;
  /// Of which the table holds the mean and the standard deviation of one; 1: deviations are those of the mean.
  int repeats = 1;
  /// Of the reference post, where the file does not have it.
  std::optional<double> amplitude_m = std::nullopt;
  /// Of a time history: channels of the posts' displacements, by name where there are none; and the rig's filter.
  std::vector<PostChannel> post_channels = {};
  /// What is done to these, post by post.
  std::vector<SourceChannel> post_sources = {};
  std::optional<AcquisitionFilter> filter = {};
  TimePreparation preparation = {};
  std::optional<SourceChannel> time = {};
  std::optional<double> start_s = {};
  std::optional<double> end_s = {};
  int line = 0;

  /// Whether it states what only time histories have.
  bool IsOfHistory() const {
    return !post_channels.empty() || filter || preparation.IsGridded() || !preparation.others.empty() || time ||
           start_s || end_s;
  }
};

/// What was measured for one sensor of the vehicle in one recording; one entry per frequency.
struct MeasuredChannel {
  std::size_t sensor = 0;
  std::string name;
  std::string unit;
  std::vector<std::complex<double>> response;
  /// Standard deviations of the repeats along and across the response's phasor, pooled over neighbouring frequencies;
  /// zero where there were no repeats.
  std::vector<double> radial_sd;
  std::vector<double> tangential_sd;
  /// Mean offset [unit]; empty where not measured. Its standard deviation; empty where not known.
  std::vector<double> mean;
  std::vector<double> mean_sd;
  /// Amplitude of the second harmonic [unit]; empty where not measured.
  std::vector<double> second_harmonic;
  /// The sensors that it is the mean or sum of move against each other, which is warned of.
  bool has_opposed_members = false;
};

struct MeasuredRun {
  std::string name;
  Excitation excitation;
  std::vector<MeasuredChannel> channels;
  /// Of a time history: what was done to it, a sentence each.
  std::vector<std::string> preparations = {};
  bool is_validation = false;
};

/// Stepped sines as a study describes them; paths are resolved.
struct FourPostPlan {
  /// The study's.
  std::string file;
  std::vector<StudyRecording> recordings;
  /// Kept from the fit, for validation.
  std::vector<StudyRecording> validation = {};
  /// Sensor of the vehicle, and what was measured for it.
  std::vector<std::pair<std::string, ChannelSource>> channels;
  int channels_line = 0;
  /// Whether sensors that all recordings have channels of the same name for are measured as well.
  bool takes_others_by_name = false;
  double band_lower_Hz = 0;
  double band_upper_Hz = 0;
  int band_line = 0;
  ModelError model_error;

  /// Recordings that a vehicle is fitted to; of a plan without any, those kept for validation.
  const std::vector<StudyRecording>& Stated() const { return recordings.empty() ? validation : recordings; }
};

/// Adds the sensors to `channels` that are measured by name. Faults of files are left to LoadRuns().
void AddChannelsByName(const Vehicle& vehicle, FourPostPlan& plan);

/// Reads the recordings and maps their channels to the vehicle's sensors. Adds every fault to `diagnostics`; recordings
/// that cannot be read are left out.
std::vector<MeasuredRun> LoadRuns(const FourPostPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics);

/// The same of recordings that are kept for validation: those that cannot be used, or have no frequency in the band,
/// are left out with a warning.
std::vector<MeasuredRun> LoadValidationRuns(const FourPostPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics,
                                            std::vector<LeftOutRecording>& left_out);

/// Whether a study's band holds a frequency: from its lower to its upper end, which hold those within 0.1 % of them.
bool IsInBand(double frequency_Hz, double lower_Hz, double upper_Hz);

/// The run with only those of its frequencies that are to keep.
MeasuredRun AtFrequencies(const MeasuredRun& run, const std::vector<bool>& keep);

/// The runs with only the frequencies of the band.
std::vector<MeasuredRun> InBand(const std::vector<MeasuredRun>& runs, double lower_Hz, double upper_Hz);
/// The same of what a model answers.
std::vector<FrequencyResponse> InBand(const std::vector<FrequencyResponse>& modelled, double lower_Hz, double upper_Hz);

}  // namespace fourpost
