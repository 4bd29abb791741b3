#include "vehicles/requests/engine_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

std::string IntegrationText(const HistoryEngine& by) {
  // Less says nothing to a user.
  const std::string change = by.change ? Percent(std::max(1e-5, *by.change), 2) : "";
  if (!by.step_s)
    return "full geometry, by Simbody's integrator" +
           (change.empty() ? "\n" : "; a tenfold accuracy changed no channel by more than " + change + " of its rms\n");
  const std::string step = Rounded(1e3 * *by.step_s, 3) + " ms";
  if (change.empty()) return "step " + step + ", not compared with another\n";
  return "halving the step to " + step + " changed no channel by more than " + change + " of its rms\n";
}

std::string Where(const LargestDifference& difference) {
  return difference.channel.empty() ? ""
                                    : " (" + difference.channel + ", " + Rounded(difference.frequency_Hz, 3) + " Hz)";
}

/// Rounded up.
std::string AtMost(double value, int decimals) {
  const double step = std::pow(10, -decimals);
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::max(1.0, std::ceil(value / step)) * step);
  return text;
}

}  // namespace

std::string KinematicsText(const KinematicsError& error) {
  return "linear kinematics are off by at most " + AtMost(error.gain_dB.value, 3) + " dB" + Where(error.gain_dB) +
         " and " + AtMost(error.phase_deg.value, 2) + " deg" + Where(error.phase_deg);
}

std::string EngineText(const std::string& recording, const SteadyResponse& answer) {
  const std::string engine = EngineName(answer.engine);
  if (answer.kinematics_error)
    return recording + ": " + KinematicsText(*answer.kinematics_error) + ": engine " + engine + '\n';
  const std::string why = answer.not_estimated.empty() ? "" : "; linear kinematics: " + answer.not_estimated;
  return recording + ": engine " + engine + why + '\n';
}

std::string Percent(double share, int digits) { return Rounded(100 * share, digits) + " %"; }

std::string KinematicsText(const HistoryDifference& error) {
  // Less is what both engines are integrated to.
  const std::string size = Percent(std::max(1e-5, error.share), 2);
  return "linear kinematics are off by " + size + " rms" + (error.channel.empty() ? "" : " (" + error.channel + ")") +
         (error.IsVisible() ? ", above" : ", below") + " the visible limit (" + Percent(kVisibleShare, 1) + ")";
}

std::string FitEngineText(const std::string& recording, const HistoryEngine& by) {
  // An engine that was asked for estimates nothing.
  if (!by.kinematics_error && by.not_estimated.empty())
    return recording + ": engine " + std::string(EngineName(by.engine)) + '\n';
  if (!by.kinematics_error) return recording + ": error of linear kinematics not estimated: " + by.not_estimated + '\n';
  const std::string text = recording + ": " + KinematicsText(*by.kinematics_error) + ": ";
  if (by.correction_change)
    return text + "corrected by the full geometry, whose correction would change by another " +
           Percent(*by.correction_change, 2) + " of a channel's standard deviation\n";
  return text + (by.engine == Engine::kFull ? "full geometry used\n" : "reduced model used\n");
}

std::string EngineText(const HistoryEngine& by) {
  std::string text = IntegrationText(by);
  if (!by.kinematics_error) return text;
  return text + KinematicsText(*by.kinematics_error) + ": " +
         (by.engine == Engine::kFull ? "full geometry used\n" : "reduced model used\n");
}

}  // namespace fourpost
