#include "analysis/measured_response/dwell_responses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/frequency_response/rest_level.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/missed_motions.h"
#include "analysis/signals/median.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

/// Of a dwell, for a response: ten, and four blocks of 16 samples, one of which is the run-in.
int EnoughCycles(const Dwell& dwell) {
  return std::max(10, 4 * static_cast<int>(std::ceil(16 * dwell.cycles_per_sample)));
}

/// NaN where a recording does not begin at rest.
void TakeFromRest(const Rest& rest, DwellResponse& response) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const bool has_rest = !rest.levels.empty();
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    response.channels[c].mean -= has_rest ? rest.levels[c].mean : kUnknown;
    response.channels[c].mean_variance += has_rest ? rest.levels[c].variance : kUnknown;
  }
}

bool HasMeans(const DwellResponse& response) {
  return std::none_of(response.channels.begin(), response.channels.end(),
                      [](const DwellChannel& channel) { return std::isnan(channel.mean); });
}

/// "a.csv does not begin at rest: its posts move by 0.12 mm at 16.0 Hz, of which 0.0075 mm would be rest"
std::string MotionInWords(const Rest& rest, const std::filesystem::path& file) {
  return file.filename().string() + " does not begin at rest: in its first half second a post moves by " +
         Rounded(1e3 * rest.motion, 2) + " mm" +
         (rest.frequency_Hz > 0 ? " at " + Rounded(rest.frequency_Hz, 3) + " Hz" : "") + ", more than " +
         Rounded(1e3 * rest.limit, 2) + " mm";
}

/// Frequency, first and last second, what is enough in cycles and in seconds.
std::vector<std::string> InWords(const Dwell& dwell, double rate_Hz) {
  const int enough = EnoughCycles(dwell);
  const double frequency_Hz = dwell.cycles_per_sample * rate_Hz;
  return {Rounded(frequency_Hz, 3), Rounded(dwell.start / rate_Hz, 3), Rounded(dwell.end / rate_Hz, 3),
          std::to_string(enough), Rounded(enough / frequency_Hz, 2)};
}

/// "the dwell at 20 Hz from 3.0 to 3.2 s is too short ..." of those that gave no response.
std::vector<std::string> ShortDwells(const std::vector<Dwell>& dwells, double rate_Hz) {
  std::vector<std::string> list;
  for (const Dwell& dwell : dwells) {
    const std::vector<std::string> words = InWords(dwell, rate_Hz);
    list.push_back("the dwell at " + words[0] + " Hz from " + words[1] + " to " + words[2] +
                   " s is too short for a response: left out; dwell for " + words[3] + " cycles, " + words[4] + " s");
  }
  return list;
}

/// Few cycles that the run-in still moves say nothing: a fit that pools variances over frequencies would believe them.
bool SaysLittle(const DwellResponse& response) {
  constexpr int kFew = 9;
  constexpr double kMost = 0.05;
  if (response.cycles >= kFew || response.channels.empty()) return false;
  std::vector<double> shares;
  for (const DwellChannel& channel : response.channels)
    shares.push_back(std::sqrt(channel.variance / 2) / std::max(1e-300, std::abs(channel.response)));
  return Median(shares) > kMost;
}

/// Whether a response lies in its middle.
bool HasResponse(const Dwell& dwell, const std::vector<DwellResponse>& responses) {
  return std::any_of(responses.begin(), responses.end(), [&](const DwellResponse& response) {
    const double middle = 0.5 * (dwell.start + dwell.end);
    return static_cast<double>(response.first) - 1 / dwell.cycles_per_sample < middle &&
           middle < static_cast<double>(response.last);
  });
}

/// "20, 25 Hz", of many the first.
std::string FrequenciesInWords(const std::vector<double>& frequencies_Hz) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, frequencies_Hz.size()); ++i)
    text += (i > 0 ? ", " : "") + Rounded(frequencies_Hz[i], 3);
  text += " Hz";
  if (frequencies_Hz.size() > kShown) text += " and " + std::to_string(frequencies_Hz.size() - kShown) + " others";
  return text;
}

}  // namespace

void DwellResponses::Add(const LookedAt& looked) {
  const RigSignals signals = looked.recording.Signals();
  std::vector<DwellResponse> responses = RespondInDwells(signals, looked.dwells, work_.reference);
  std::erase_if(responses, SaysLittle);
  if (responses.empty()) {
    Refuse(looked);
    return;
  }
  const double rate_Hz = looked.recording.rate_Hz;
  const std::size_t stated = work_.request.frequencies_Hz.size();
  std::vector<Dwell> short_ones;
  for (const Dwell& dwell : looked.dwells) {
    if (HasResponse(dwell, responses)) answered_Hz_.push_back(dwell.cycles_per_sample * rate_Hz);
    else short_ones.push_back(dwell);
  }
  for (const std::vector<std::string>& list :
       {MotionsWithoutDwell(looked, stated > 0), ShortDwells(short_ones, rate_Hz)})
    work_.out.missed.insert(work_.out.missed.end(), list.begin(), list.end());
  const Rest rest = RestBefore(signals, looked.dwells);
  if (rest.levels.empty()) work_.out.without_rest.push_back(MotionInWords(rest, looked.file));
  for (DwellResponse& response : responses) {
    TakeFromRest(rest, response);
    UndoFilter(response);
    ++work_.out.dwells;
    cycles_.push_back(response.cycles);
    if (!response.is_settled && work_.out.unsettled++ == 0) unsettled_Hz_ = response.frequency_Hz;
    dwells_.push_back(std::move(response));
  }
}

void DwellResponses::Refuse(const LookedAt& looked) const {
  const std::string& post = looked.recording.posts[looked.largest_post];
  const std::size_t stated = work_.request.frequencies_Hz.size();
  if (!looked.dwells.empty()) {
    std::vector<std::string> words = InWords(looked.dwells.front(), looked.recording.rate_Hz);
    const bool is_one = looked.dwells.size() == 1;
    words.insert(words.begin(), {is_one ? "the dwell" : "all " + std::to_string(looked.dwells.size()) + " dwells", post,
                                 is_one ? "is" : "are"});
    work_.Fault(kResponseDwellsShort, looked.file, words);
  } else if (stated > 0) {
    work_.Fault(kResponseStatedNone, looked.file, {post, std::to_string(stated)});
  } else {
    work_.Fault(kResponseNoDwell, looked.file, {post});
  }
}

void DwellResponses::CheckStated(const std::filesystem::path& file) {
  const std::vector<double>& stated = work_.request.frequencies_Hz;
  std::vector<double> without;
  for (const double frequency : stated) {
    // Dwells have the stated frequencies, in rounding.
    const auto is_it = [&](double answered) { return std::abs(answered - frequency) < 1e-9 * frequency; };
    if (std::none_of(answered_Hz_.begin(), answered_Hz_.end(), is_it)) without.push_back(frequency);
  }
  if (without.empty()) return;
  const Dwell slowest = {.cycles_per_sample = without.front() / work_.out.rate_Hz};
  const std::vector<std::string> words = InWords(slowest, work_.out.rate_Hz);
  work_.Fault(kResponseStatedMissing, file,
              {std::to_string(without.size()), std::to_string(stated.size()), FrequenciesInWords(without), words[3],
               words[4], words[0]});
}

void DwellResponses::UndoFilter(DwellResponse& response) const {
  if (!work_.request.filter) return;
  response.amplitude /= work_.Passed(response.frequency_Hz);
  for (DwellChannel& channel : response.channels)
    for (std::size_t h = 0; h < channel.harmonics.size(); ++h)
      channel.harmonics[h] /= work_.Passed(static_cast<double>(h + 1) * response.frequency_Hz);
}

void DwellResponses::Finish() {
  const std::filesystem::path& file = work_.request.files.front();
  work_.out.median_cycles = Median(cycles_);
  if (work_.out.unsettled > 0)
    work_.Fault(kResponseNotSettled, file,
                {std::to_string(work_.out.unsettled), std::to_string(work_.out.dwells), Rounded(unsettled_Hz_, 3)});
  CheckStated(file);
  for (const DwellGroup& group : GroupsOf(dwells_)) work_.out.responses.push_back(ResponseOf(group));
  CheckFilter(file);
}

MeasuredResponse DwellResponses::ResponseOf(const DwellGroup& group) {
  MeasuredResponse out = work_.Blank(group.shares);
  out.name = work_.NameFor(out);
  std::vector<double> rests;
  std::vector<DwellResponse> means;
  for (const std::vector<DwellResponse>& repeats : group.frequencies) {
    means.push_back(MeanOf(repeats));
    const DwellResponse& mean = means.back();
    rests.push_back(mean.shares.rest);
    out.repeats.push_back(static_cast<int>(repeats.size()));
    out.response.frequency_Hz.push_back(mean.frequency_Hz);
    out.response.amplitude_m.push_back(mean.amplitude);
    for (std::size_t c = 0; c < work_.names.size(); ++c) AddDwell(mean, c, out.response.channels[c]);
  }
  const bool has_means = std::all_of(means.begin(), means.end(), HasMeans);
  work_.out.has_means = work_.out.has_means || has_means;
  for (std::size_t c = 0; c < work_.names.size(); ++c) {
    for (std::size_t i = 0; has_means && i < means.size(); ++i) {
      out.response.channels[c].mean.push_back(means[i].channels[c].mean);
      out.response.channels[c].mean_sd.push_back(std::sqrt(means[i].channels[c].mean_variance));
    }
    AddQuality(means, c, out);
  }
  work_.CheckPosts(Median(rests), out);
  return out;
}

void DwellResponses::AddDwell(const DwellResponse& dwell, std::size_t c, ChannelResponse& channel) const {
  const DwellChannel& measured = dwell.channels[c];
  AddResponse(measured.response, measured.variance, dwell.frequency_Hz, channel);
  channel.second_harmonic.push_back(measured.harmonics.size() > 1 ? measured.harmonics[1] : 0);
}

void DwellResponses::AddQuality(const std::vector<DwellResponse>& means, std::size_t c, MeasuredResponse& out) const {
  ChannelQuality quality = QualityOf(out.response.channels[c]);
  quality.distortion = 0;
  for (const DwellResponse& mean : means) {
    const DwellChannel& channel = mean.channels[c];
    // Next to a node anything is large.
    constexpr double kNode = 0.2;
    if (channel.harmonics.front() < kNode * LoudestLike(c, mean)) continue;
    // Noise has harmonics, too: four of them.
    const double noise = std::sqrt(4 * channel.variance) / std::abs(channel.response);
    const double distortion = std::sqrt(std::max(0.0, std::pow(channel.Distortion(), 2) - noise * noise));
    if (distortion <= quality.distortion) continue;
    quality.distortion = distortion;
    quality.distortion_Hz = mean.frequency_Hz;
  }
  out.channels.push_back(std::move(quality));
}

double DwellResponses::LoudestLike(std::size_t c, const DwellResponse& mean) const {
  double loudest = 0;
  for (std::size_t other = 0; other < work_.units.size(); ++other)
    if (work_.units[other] == work_.units[c]) loudest = std::max(loudest, mean.channels[other].harmonics.front());
  return loudest;
}

void DwellResponses::CheckFilter(const std::filesystem::path& file) {
  constexpr double kLittle = 0.1;
  for (const MeasuredResponse& response : work_.out.responses) {
    const double highest = response.response.frequency_Hz.back();
    if (const double passed = work_.Passed(highest); passed < kLittle) {
      work_.Fault(kResponseFilterTooLow, file, {Rounded(100 * passed, 2), Rounded(highest, 3)});
      return;
    }
  }
}

}  // namespace fourpost
