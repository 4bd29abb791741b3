#include "identify/report/modelled_recordings.h"

#include <cmath>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using html::Code;

std::string Largest(const Json& error, const std::string& kind, const std::string& unit) {
  const Json largest = error.value(kind, Json());
  return ShownShort(NumberAt(largest, "value"), 2) + ' ' + unit + " (" + Code(TextAt(largest, "channel")) + ", " +
         ShownShort(NumberAt(largest, "frequency_Hz"), 3) + " Hz)";
}

/// The error of linear kinematics in a recording; empty where the run does not hold it.
std::string OffBy(const Json& recording) {
  const Json error = recording.is_object() ? recording.value("linear_kinematics_error", Json()) : Json();
  if (!error.is_object()) return "";
  if (const std::string why = TextAt(error, "not_estimated"); !why.empty())
    return "the error of linear kinematics could not be estimated: " + html::Escaped(why);
  if (error.contains("gain_dB"))
    return "error of linear kinematics at most " + Largest(error, "gain_dB", "dB") + " and " +
           Largest(error, "phase_deg", "degrees");
  const std::string channel = TextAt(error, "channel");
  return "error of linear kinematics " + ShownShort(100 * NumberAt(error, "value"), 2) + " % rms" +
         (channel.empty() ? "" : " (" + Code(channel) + ")");
}

}  // namespace

std::string ModelledHtml(const std::vector<Json>& recordings) {
  std::string items;
  for (const Json& recording : recordings) {
    const std::string off = OffBy(recording);
    const double change = NumberAt(recording, "correction_change");
    items += html::Element(
        "li", "",
        Code(TextAt(recording, "recording")) + ": engine " + html::Escaped(TextAt(recording, "engine")) +
            (off.empty() ? "" : "; " + off) +
            (std::isfinite(change) ? "; one more correction would change it by " + ShownShort(100 * change, 2) + " %"
                                   : ""));
  }
  return items.empty() ? "" : html::Element("ul", "", items);
}

}  // namespace fourpost
