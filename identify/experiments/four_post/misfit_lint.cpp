#include "identify/experiments/four_post/misfit_lint.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/four_post_residuals.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/study_file/channel_warnings.h"

namespace fourpost {
namespace {

/// Times noise and model error, as a root mean square over the band: practically never by chance.
constexpr double kFarOff = 4;

/// A channel of one recording.
struct LargeMisfit {
  std::string channel;
  std::string unit;
  std::string recording;
  double off = 0;
};

std::vector<LargeMisfit> WorstFirst(const std::vector<MeasuredRun>& runs,
                                    const std::vector<FrequencyResponse>& modelled, const ModelError& model_error) {
  std::vector<LargeMisfit> findings;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::vector<double> off = ResponseDeviations(runs[r], modelled[r], model_error);
    for (std::size_t c = 0; c < off.size(); ++c)
      if (off[c] > kFarOff)
        findings.push_back({runs[r].channels[c].name, runs[r].channels[c].unit, runs[r].name, off[c]});
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const LargeMisfit& a, const LargeMisfit& b) { return a.off > b.off; });
  return findings;
}

std::string KindOf(const std::string& unit) {
  if (unit == "m/s^2") return "accelerations";
  if (unit == "m") return "displacements";
  if (unit == "N") return "forces";
  return "turn rates";
}

/// "6 channels (4 displacements, 2 forces; 2 in 'bounce', 6 in 'roll')"
std::string Groups(const std::vector<LargeMisfit>& findings) {
  std::map<std::string, std::set<std::string>> kinds;
  std::map<std::string, int> recordings;
  std::set<std::string> channels;
  for (const LargeMisfit& finding : findings) {
    kinds[KindOf(finding.unit)].insert(finding.channel);
    channels.insert(finding.channel);
    ++recordings[finding.recording];
  }
  std::string of;
  for (const auto& [kind, names] : kinds) of += (of.empty() ? "" : ", ") + std::to_string(names.size()) + " " + kind;
  std::string in;
  for (const auto& [recording, count] : recordings)
    in += (in.empty() ? "" : ", ") + std::to_string(count) + " in '" + recording + "'";
  return std::to_string(channels.size()) + " channels (" + of + "; " + in + ")";
}

}  // namespace

void LintChannels(const FourPostPlan& plan, const std::vector<MeasuredRun>& in_band, const Vehicle& vehicle,
                  const CondensedModel& model,
                  const std::function<bool(const std::vector<std::string>& channels)>& is_cleared,
                  Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 3;
  const std::vector<LargeMisfit> findings =
      WorstFirst(in_band, ModelledResponses(model, vehicle.sensors, in_band), plan.model_error);
  if (findings.empty()) return;
  std::string worst;
  for (std::size_t i = 0; i < std::min(kShown, findings.size()); ++i)
    worst += (i == 0 ? "'" : ", '") + findings[i].channel + "' in '" + findings[i].recording + "' " +
             ShortNumber(findings[i].off, 2) + " times";
  // One channel at its line, several at that of their section.
  const bool is_one = std::all_of(findings.begin(), findings.end(), [&](const LargeMisfit& finding) {
    return finding.channel == findings.front().channel;
  });
  std::vector<std::string> channels;
  for (const LargeMisfit& finding : findings) channels.push_back(finding.channel);
  const bool is_model = is_cleared(channels);
  const Place section{plan.file, plan.channels_line};
  if (is_one)
    ChannelWarnings(plan.file, plan.channels, diagnostics)
        .Report(is_model ? kModelFarOffSines : kSinesFarOff, findings.front().channel, {worst});
  else if (findings.size() <= kShown) diagnostics.Report(is_model ? kModelFarOffSines : kSinesFarOff, section, {worst});
  else diagnostics.Report(is_model ? kModelFarOffManySines : kManySinesFarOff, section, {Groups(findings), worst});
}

}  // namespace fourpost
