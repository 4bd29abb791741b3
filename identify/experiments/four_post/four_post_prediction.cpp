// What a vehicle that is given makes of another stepped sine.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/frequency_response_file.h"
#include "analysis/text/named.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/four_post/covered_sines.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/four_post/misfit_table.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/experiments/four_post/recording_lint.h"
#include "identify/experiments/four_post/response_bands.h"
#include "identify/experiments/four_post/response_chart.h"
#include "identify/experiments/four_post/response_misfit_json.h"
#include "identify/experiments/four_post/study_recording.h"
#include "identify/experiments/four_post/tyre_pull_lint.h"
#include "identify/study_file/measured_channels.h"
#include "identify/study_file/named_channels.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/post_shape.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/requests/sweep_files.h"

namespace fourpost {
namespace {

std::vector<std::string> ChannelsIn(const std::filesystem::path& recording) {
  Diagnostics diagnostics;
  // Names do not depend on the amplitude.
  const std::optional<FrequencyResponse> measured = ReadFrequencyResponse(recording, diagnostics, 1.0);
  if (!measured) throw FaultyInput(diagnostics);
  std::vector<std::string> names;
  for (const ChannelResponse& channel : measured->channels) names.push_back(channel.name);
  return names;
}

/// Its faults are reported by the one who reads it in earnest.
std::optional<SourceChannel> TimesOf(const std::filesystem::path& recording, const FourPostPlan& plan) {
  Diagnostics unheard;
  const std::optional<RecordedTable> table = ReadRecordedTable(recording, unheard);
  return table ? TimesAsIn(plan.Stated(), *table) : std::nullopt;
}

/// Sum over the channels, each at most 1: a strut that friction holds at low frequencies says nothing of the pattern.
double SquaredMisfit(const MeasuredRun& run, const FrequencyResponse& modelled) {
  double square = 0;
  for (const MeasuredChannel& channel : run.channels) {
    double error = 0;
    double measured = 0;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      error += std::norm(modelled.channels[channel.sensor].response[i] - channel.response[i]);
      measured += std::norm(channel.response[i]);
    }
    square += measured > 0 ? std::min(1.0, error / measured) : 0;
  }
  return square;
}

/// Frequencies of the band in the place of those of the whole recording.
void PutInBand(const FrequencyResponse& band, FrequencyResponse& whole) {
  const auto first = std::find(whole.frequency_Hz.begin(), whole.frequency_Hz.end(), band.frequency_Hz.front());
  const std::ptrdiff_t at = first - whole.frequency_Hz.begin();
  for (std::size_t c = 0; c < whole.channels.size(); ++c) {
    const ChannelResponse& from = band.channels[c];
    ChannelResponse& to = whole.channels[c];
    std::copy(from.response.begin(), from.response.end(), to.response.begin() + at);
    std::copy(from.mean.begin(), from.mean.end(), to.mean.begin() + at);
    std::copy(from.second_harmonic.begin(), from.second_harmonic.end(), to.second_harmonic.begin() + at);
  }
}

/// "FL=1,FR=-1", as `--mode` has it.
std::string SharesText(const Vehicle& vehicle, const Excitation& excitation) {
  std::string text;
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
    text += (text.empty() ? "" : ",") + vehicle.posts[p].name + "=" + FormatNumber(excitation.shape[p]);
  return text;
}

/// One recording and what is asked of it.
class SinePrediction {
 public:
  SinePrediction(const FourPostPlan& plan, const Subject& subject, const PredictionRequest& request,
                 const WorkHooks& hooks)
      : plan_(plan),
        subject_(subject),
        request_(request),
        hooks_(hooks),
        times_(TimesOf(request.recording, plan)),
        is_history_(IsOverTime({.name = {}, .file = request.recording, .posts = {}, .pattern = {}, .time = times_})),
        model_(subject.Condensed()->At(subject.vehicle().ParameterValues())) {}

  std::optional<ExperimentResults> Run() const {
    const double lower = plan_.band_lower_Hz;
    const double upper = plan_.band_upper_Hz;
    ExperimentResults results;
    MeasuredRun whole = Load(results.findings);
    if (InBand({whole}, lower, upper).front().excitation.frequency_Hz.empty())
      Refuse(kSineOutsideBand, {request_.recording.string()});
    const std::string posts = SetPosts(whole);
    const std::vector<MeasuredRun> in_band = InBand({whole}, lower, upper);
    LintRuns({plan_, subject_.vehicle(), model_}, {whole}, results.findings);
    LintTyrePulls(subject_.vehicle(), subject_.vehicle().ParameterValues(), in_band, results.findings);
    WarnOfLeaving(ReadCovered(request_.run / "result.json"),
                  CoveredBySines(subject_.vehicle(), subject_.vehicle().ParameterValues(), in_band),
                  {request_.recording.string()}, results.findings);
    hooks_.Find(results.findings);
    const std::optional<SteadyResponse> answer = Answer(in_band.front());
    if (!answer) return std::nullopt;
    const std::vector<ChannelMisfit> misfits = ResponseMisfits(in_band, {answer->response});
    results.json = {{"posts", posts},
                    {"band_Hz", {lower, upper}},
                    {"engine", EngineName(answer->engine)},
                    {"linear_kinematics_error", KinematicsJson(answer->kinematics_error, answer->not_estimated)},
                    {"channels", ResponseMisfitsJson(misfits)}};
    results.text = MisfitTable(misfits, {}) + EngineText(whole.name, *answer);
    AddBands(in_band.front(), answer->response, results);
    if (hooks_.IsStopped()) return std::nullopt;
    if (!request_.has_files) return results;
    std::vector<FrequencyResponse> modelled = {Respond(whole)};
    PutInBand(answer->response, modelled.front());
    results.files = {{"response.csv", ResponseCsv({whole}, modelled, lower, upper, {}, BandsOfWhole(whole, modelled))},
                     {"response.svg", ResponseSvg({whole}, modelled, misfits, lower, upper)}};
    return results;
  }

 private:
  ResponseBands Bands(const MeasuredRun& run, const FrequencyResponse& modelled) const {
    if (!request_.spread) return {};
    hooks_.Show(run.name + ": bands");
    return BandsOfResponse(subject_, run, modelled, *request_.spread, ReadDiscrepancies(request_.run / "result.json"));
  }

  /// Empty where there are none.
  std::vector<ResponseBands> BandsOfWhole(const MeasuredRun& run,
                                          const std::vector<FrequencyResponse>& modelled) const {
    const ResponseBands bands = Bands(run, modelled.front());
    if (bands.counts.empty()) return {};
    return {bands};
  }

  void AddBands(const MeasuredRun& run, const FrequencyResponse& modelled, ExperimentResults& results) const {
    const ResponseBands bands = Bands(run, modelled);
    if (bands.counts.empty()) return;
    results.text += '\n' + BandCountsText(bands.counts, bands.evaluations);
    results.json["band_95"] = BandCountsJson(bands.counts, bands.evaluations);
  }

  /// The recording in place of those fitted; the posts of a table are set later.
  MeasuredRun Load(Diagnostics& findings) const {
    FourPostPlan plan = plan_;
    plan.file = subject_.study_file().string();
    StudyRecording recording = is_history_ ? FirstWithPosts() : plan.Stated().front();
    recording.file = request_.recording;
    recording.name = request_.recording.stem().string();
    // The window and the files beside it are those of the other recording.
    recording.start_s = recording.end_s = {};
    recording.time = times_;
    recording.preparation.others.clear();
    if (!is_history_) DropPreparation(recording, plan.channels);
    std::vector<std::string> channels;
    if (is_history_) channels = SetMotion(recording);
    else channels = ChannelsIn(request_.recording);
    if (plan.takes_others_by_name) {
      AddByName(NamesOf(subject_.vehicle().sensors), channels, recording.line, plan.channels);
      plan.takes_others_by_name = false;
    }
    KeepMeasured(request_.recording, channels, plan.channels, findings);
    plan.recordings = {recording};
    Diagnostics diagnostics;
    const std::vector<MeasuredRun> runs = LoadRuns(plan, subject_.vehicle(), diagnostics);
    if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
    findings.Add(diagnostics);
    return runs.front();
  }

  /// What is stated of time histories does not concern a table of responses.
  static void DropPreparation(StudyRecording& recording, StudyChannels& channels) {
    recording.post_channels.clear();
    recording.post_sources.clear();
    recording.filter.reset();
    recording.time.reset();
    recording.preparation = {};
    for (auto& [sensor, source] : channels)
      for (SourceChannel& channel : source.channels) {
        SourceChannel plain(channel.name);
        plain.factor = channel.factor;
        plain.delay_s = channel.delay_s;
        channel = std::move(plain);
      }
  }

  /// Whose channels of posts and filter are those of any other; where none states them, posts are known by name.
  const StudyRecording& FirstWithPosts() const {
    const std::vector<StudyRecording>& all = plan_.Stated();
    const auto found =
        std::find_if(all.begin(), all.end(), [](const StudyRecording& recording) { return recording.IsOfHistory(); });
    return found == all.end() ? all.front() : *found;
  }

  /// Posts as `--mode` has it, or as they moved; returns the channels of the file.
  std::vector<std::string> SetMotion(StudyRecording& recording) const {
    const std::vector<std::string> posts = NamesOf(subject_.vehicle().posts);
    Diagnostics diagnostics;
    const auto content =
        ReadHistoryContent(recording, subject_.study_file().string(), plan_.channels, posts, diagnostics);
    if (!content) throw FaultyInput(diagnostics);
    if (request_.mode.empty() && content->shapes.size() > 1)
      Refuse(kSineSeveralMotions, {request_.recording.string()}, {std::to_string(content->shapes.size())});
    const std::vector<double> shape = request_.mode.empty() ? content->shapes.front() : StatedShape();
    recording.pattern.reset();
    recording.posts.clear();
    for (std::size_t p = 0; p < posts.size(); ++p) recording.posts.emplace_back(posts[p], shape[p]);
    return content->channels;
  }

  std::vector<double> StatedShape() const {
    Diagnostics diagnostics;
    std::vector<double> shape = ReadPostShape(request_.mode, subject_.vehicle(), diagnostics);
    if (diagnostics.HasErrors()) throw FaultyInput(diagnostics);
    return shape;
  }

  FrequencyResponse Respond(const MeasuredRun& run) const {
    return ModelledResponses(model_, subject_.vehicle().sensors, {run}).front();
  }

  std::string SetPosts(MeasuredRun& run) const {
    if (is_history_) return request_.mode.empty() ? SharesText(subject_.vehicle(), run.excitation) : request_.mode;
    if (request_.mode.empty()) return GuessPattern(run);
    run.excitation.shape = StatedShape();
    return request_.mode;
  }

  /// The pattern whose responses are nearest, and the posts of `run` set to it. At the lowest frequencies a car follows
  /// its posts, whatever its parameters are.
  std::string GuessPattern(MeasuredRun& run) const {
    constexpr std::size_t kFrequencies = 8;
    const Vehicle& vehicle = subject_.vehicle();
    const std::vector<double>& all = run.excitation.frequency_Hz;
    const double last = all[std::min(kFrequencies, all.size()) - 1];
    MeasuredRun low = InBand({run}, all.front(), last).front();
    std::string best;
    double least = std::numeric_limits<double>::infinity();
    for (const std::string_view pattern : kPostPatterns) {
      try {
        low.excitation.shape = PostPattern(vehicle, std::string(pattern));
      } catch (const std::invalid_argument&) {
        continue;  // Posts in a line make no roll.
      }
      const double misfit = SquaredMisfit(low, Respond(low));
      if (!(misfit < least)) continue;
      least = misfit;
      best = pattern;
    }
    // Of a pattern that is right, a car misses some per cent.
    constexpr double kNoFit = 0.5;
    if (!(least < kNoFit * static_cast<double>(run.channels.size())))
      Refuse(kPatternNotFound, {run.name}, {vehicle.name});
    run.excitation.shape = PostPattern(vehicle, best);
    hooks_.Note("posts: " + best + ", which fits best up to " + Rounded(last, 3) + " Hz; choose another with --mode");
    return best;
  }

  /// Nothing where it was interrupted.
  std::optional<SteadyResponse> Answer(const MeasuredRun& run) const {
    SteadySolver solver(subject_.vehicle());
    std::optional<SteadyResponse> answer =
        SolveSweep(solver, run.name, run.excitation, request_.engine.value_or(Engine::kAuto), kFitBalance, hooks_);
    if (!answer || answer->unanswered.empty()) return answer;
    if (hooks_.IsStopped()) return std::nullopt;
    const Unanswered& first = answer->unanswered.front();
    throw SimulationError(kResponseUnanswered, {run.name, Rounded(first.frequency_Hz, 3), WithoutId(first.why)});
  }

  const FourPostPlan& plan_;
  const Subject& subject_;
  const PredictionRequest& request_;
  const WorkHooks& hooks_;
  /// Of which responses are made, and which holds the motion of its posts.
  std::optional<SourceChannel> times_;
  bool is_history_;
  CondensedModel model_;
};

}  // namespace

std::optional<ExperimentResults> FourPost::Predict(const Subject& subject, const PredictionRequest& request,
                                                   const WorkHooks& hooks) const {
  if (request.has_kalman) Refuse(kKalmanOfSine, Place::Option("--kalman"), {request.recording.filename().string()});
  RefuseRelease(request);
  return SinePrediction(plan, subject, request, hooks).Run();
}

}  // namespace fourpost
