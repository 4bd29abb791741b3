#include "identify/report/report_page.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/report_document.h"
#include "identify/report/history_table.h"
#include "identify/report/page_footer.h"
#include "identify/report/picture_number.h"
#include "identify/report/report_summary.h"
#include "identify/report/report_tables.h"
#include "identify/report/response_table.h"
#include "identify/report/run_result.h"
#include "identify/report/scene_json.h"
#include "identify/report/shown_number.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

/// Of a recording that was not fitted: its table has all channels of the rig, and is for a look.
constexpr std::size_t kMostRowsUnseen = 20000;

std::vector<ComparedChannel> ChannelsOf(const RunContents& run) {
  const auto file = run.files.find("response.csv");
  if (file == run.files.end()) return {};
  return ReadResponseTable(file->second, "response.csv");
}

OrderedJson OverTime(const RunContents& run, const std::string& name, CsvHeader header,
                     std::size_t most = kMostHistoryRows) {
  const auto file = run.files.find(name);
  return file == run.files.end() ? OrderedJson::array() : HistoriesJson(file->second, name, header, most);
}

OrderedJson ChannelsJson(const std::vector<ComparedChannel>& channels) {
  OrderedJson list = OrderedJson::array();
  const auto numbers = [](const std::vector<double>& values) {
    return PictureNumbers(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  for (const ComparedChannel& channel : channels) {
    OrderedJson json = {{"recording", channel.recording},
                        {"name", channel.name},
                        {"unit", channel.unit},
                        {"frequency_Hz", numbers(channel.frequency_Hz)},
                        {"in_band", channel.in_band},
                        {"gain_measured", numbers(channel.gain_measured)},
                        {"gain_modelled", numbers(channel.gain_modelled)},
                        {"gain_start", numbers(channel.gain_start)},
                        {"gain_sd", numbers(channel.gain_sd)},
                        {"phase_measured", numbers(channel.phase_measured_deg)},
                        {"phase_modelled", numbers(channel.phase_modelled_deg)},
                        {"phase_start", numbers(channel.phase_start_deg)},
                        {"phase_sd", numbers(channel.phase_sd_deg)}};
    const auto finite = [](double value) { return std::isfinite(value); };
    if (std::any_of(channel.mean_measured.begin(), channel.mean_measured.end(), finite)) {
      json["mean_measured"] = numbers(channel.mean_measured);
      json["mean_modelled"] = numbers(channel.mean_modelled);
    }
    list.push_back(std::move(json));
  }
  return list;
}

/// The recordings whose posts' motion is known, with the frequencies of their channels.
std::vector<RecordedMotion> MotionsOf(const Json& result, const std::vector<ComparedChannel>& channels,
                                      const Vehicle& vehicle) {
  std::vector<RecordedMotion> motions;
  for (const Json& recording : ListAt(result, "recordings")) {
    const std::string name = TextAt(recording, "name");
    const auto channel = std::find_if(channels.begin(), channels.end(),
                                      [&](const ComparedChannel& candidate) { return candidate.recording == name; });
    if (channel == channels.end()) continue;
    const Json posts = recording.value("posts", Json());
    RecordedMotion motion{.name = name, .excitation = {channel->frequency_Hz, channel->post_amplitude_m, {}}};
    for (const Post& post : vehicle.posts) {
      const double share = NumberAt(posts, post.name);
      motion.excitation.shape.push_back(std::isfinite(share) ? share : 0);
    }
    motions.push_back(std::move(motion));
  }
  return motions;
}

/// Null, and the reason in `fault`, where there is nothing to show.
OrderedJson SceneOf(const Json& result, const std::vector<ComparedChannel>& channels, const RunContents& run,
                    std::string& fault) {
  fault = run.vehicle_fault;
  if (!run.vehicle) return nullptr;
  try {
    const auto file = run.files.find("motion.csv");
    const std::vector<RecordedHistory> histories = file == run.files.end()
                                                       ? std::vector<RecordedHistory>()
                                                       : ReadMotionCsv(file->second, file->first, *run.vehicle);
    return SceneJson(*run.vehicle, MotionsOf(result, channels, *run.vehicle), histories);
  } catch (const std::runtime_error& error) {
    fault = error.what();
  } catch (const std::invalid_argument& error) {
    fault = error.what();
  }
  return nullptr;
}

std::string Header(const Json& result) {
  const std::string vehicle = html::Escaped(TextAt(result, "vehicle"));
  std::string facts;
  const auto add = [&](const std::string& html) { facts += (facts.empty() ? "" : "<span>\u00b7</span>") + html; };
  if (const std::string study = TextAt(result, "study"); !study.empty()) add(html::Escaped(study));
  const std::vector<Json> band = ListAt(result, "band_Hz");
  if (band.size() == 2 && band[0].is_number() && band[1].is_number() && band[1] > 0)
    add(ShownShort(band[0], 3) + "\u2013" + ShownShort(band[1], 3) + " Hz");
  add(ShownDecimals(NumberAt(result, "residuals"), 0) + " residuals");
  add(ShownDecimals(NumberAt(result.value("evaluations", Json()), "paid"), 0) + " evaluations");
  if (const std::string version = TextAt(result.value("versions", Json()), "fourpost"); !version.empty())
    add("fourpost " + html::Escaped(version));
  return "<header>\n<h1>" + vehicle + "</h1>\n<p class=\"facts\">" + facts +
         "</p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
}

/// A place that the scripts fill, and what stands there without them.
std::string Drawn(const std::string& id, const std::string& without = "") {
  return "<div class=\"drawn\" data-draw=\"" + id + "\">" +
         (without.empty() ? "" : "<noscript><p class=\"note\">" + without + "</p></noscript>") + "</div>\n";
}

/// Two blocks, side by side where there is room.
std::string Pair(const std::string& left, const std::string& right) {
  return "<div class=\"pair\"><div>" + left + "</div><div>" + right + "</div></div>\n";
}

/// "a -2 %" with the sign that tables have.
std::string WithMinusSigns(std::string text) {
  for (std::size_t at = text.find(" -"); at != std::string::npos; at = text.find(" -", at))
    text.replace(at, 2, " \u2212");
  return text;
}

std::string OfOneParameter(bool is_determined) {
  return std::string("<p>") +
         (is_determined ? "One parameter was fitted, so it is correlated with no other."
                        : "The data do not depend on the one parameter that was fitted.") +
         "</p>\n";
}

std::string Directions(const Json& result) {
  const Json identifiability = result.value("identifiability", Json());
  std::string items;
  for (const Json& direction : ListAt(identifiability, "weakest"))
    if (direction.is_string()) items += html::Element("li", "", html::Escaped(WithMinusSigns(direction)));
  if (items.empty()) return "";
  if (ListAt(result, "parameters").size() == 1) return OfOneParameter(NumberAt(identifiability, "rank") > 0);
  const bool open = NumberAt(identifiability, "rank") < NumberAt(identifiability, "parameters");
  const double condition = NumberAt(identifiability, "condition");
  return "<p>" + std::string(open ? "Directions that are not identifiable:" : "Least identifiable direction") +
         (open                       ? ""
          : std::isfinite(condition) ? " (condition number " + ShownNumber(condition, 2) + "):"
                                     : ":") +
         "</p><ul class=\"directions\">" + items + "</ul>\n";
}

std::string Profiles(const Json& result, const RunContents& run) {
  const std::string table = ProfileTableHtml(result, run);
  const auto chart = run.files.find("profile.svg");
  return table.empty() || chart == run.files.end()
             ? table
             : table + html::Picture(chart->second, "Rise of the cost with each parameter held at other values");
}

std::string Determination(const Json& result, const std::string& why_no_deviations) {
  const std::string why =
      why_no_deviations.empty() ? "" : html::Element("p", "", html::Escaped(why_no_deviations)) + '\n';
  return html::Section("determination", "What the data determine", Directions(result) + why + Drawn("correlation"));
}

std::string Body(const Json& result, const std::vector<ComparedChannel>& channels, const OrderedJson& scene,
                 const std::string& scene_fault, bool has_histories, bool has_bench,
                 const std::string& why_no_deviations) {
  std::string body;
  const bool is_on_posts = !channels.empty() || has_histories || !has_bench;
  const bool is_shown = scene.is_null() ? is_on_posts : !scene["posts"].empty();
  const std::string viewer =
      scene.is_null() ? "<p class=\"note\">The vehicle is not shown: " + html::Escaped(scene_fault) + "</p>\n"
                      : Drawn("viewer", "The moving vehicle needs JavaScript.");
  // A damper between clamps does nothing worth a picture.
  if (is_shown) body += html::Section("vehicle", "The vehicle on its posts", viewer);
  if (!channels.empty())
    body +=
        html::Section("responses", "Frequency responses",
                      Drawn("responses", "The charts need JavaScript; response.svg beside this file shows them.") +
                          ChannelTableHtml(result)) +
        html::Section("residuals", "Residuals by band",
                      Drawn("residuals", "The table needs JavaScript; response.csv beside this file has its numbers."));
  if (has_histories)
    body += html::Section(
        "histories", "Time histories",
        Drawn("histories", "The charts need JavaScript; history.svg and validation.svg beside this file show them.") +
            (channels.empty() ? ChannelTableHtml(result) : ""));
  if (has_bench)
    body += html::Section("bench", "Damper bench",
                          Drawn("bench", "The charts need JavaScript; bench.csv beside this file has their numbers.") +
                              (channels.empty() && !has_histories ? ChannelTableHtml(result) : ""));
  if (const std::string loads = StaticLoadTableHtml(result); !loads.empty())
    body += html::Section("loads", "Static loads", loads);
  body += Determination(result, why_no_deviations);
  if (!scene.is_null() && is_shown)
    body += html::Section("modes", "Modes and poles",
                          Pair(ModeTableHtml(Json(scene["modes"])) +
                                   "<p class=\"note\">About static equilibrium, with mean damper rates.</p>\n",
                               Drawn("poles")));
  return body +
         html::Section("search", "Search and refinement",
                       SearchNoteHtml(result) + Drawn("convergence") + Pair(StartTableHtml(result), Drawn("agreement")) + SettingsHtml(result));
}

}  // namespace

std::string ReportPage(const RunContents& run) {
  const Json result = FitResultOf(run);
  const std::vector<ComparedChannel> channels = ChannelsOf(run);
  const std::vector<ReportedParameter> parameters = ReportedParameters(result, run);
  const std::string why = WhyNoDeviations(result, parameters);
  std::string scene_fault;
  const OrderedJson scene = SceneOf(result, channels, run, scene_fault);
  const OrderedJson histories = OverTime(run, "history.csv", CsvHeader::kNamesAndUnits);
  const OrderedJson validation = OverTime(run, "validation.csv", CsvHeader::kNamesAndUnits, kMostRowsUnseen);
  const OrderedJson bench = OverTime(run, "bench.csv", CsvHeader::kNames);

  const std::string body =
      Header(result) + "<nav id=\"contents\"></nav>\n<main>\n" +
      html::Section("summary", "Summary", SummaryHtml(result, parameters, channels)) +
      html::Section("parameters", "Parameters", ParameterTableHtml(parameters, why) + Profiles(result, run)) +
      Body(result, channels, scene, scene_fault, !histories.empty() || !validation.empty(), !bench.empty(), why) +
      "</main>\n" + PageFooter("the files in the folder of the fit");
  const OrderedJson data = {{"result", OrderedJson(result)},
                            {"responses", ChannelsJson(channels)},
                            {"scene", scene},
                            {"histories", histories},
                            {"validation", validation},
                            {"bench", bench}};
  const std::string text = CompactJson(data);
  return ReportDocument(TextAt(result, "vehicle") + " \u2013 fourpost report", body, text);
}

}  // namespace fourpost
