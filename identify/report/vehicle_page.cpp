#include "identify/report/vehicle_page.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/picture_number.h"
#include "analysis/report/report_document.h"
#include "analysis/report/shown_number.h"
#include "analysis/text/counted.h"
#include "analysis/text/units.h"
#include "identify/live/live_program.h"
#include "identify/report/page_footer.h"
#include "identify/report/report_tables.h"
#include "identify/report/scene_json.h"
#include "vehicles/engine/engine.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;
using html::NumberCell;
using html::TextCell;

std::string Fact(const std::string& text) { return html::Element("span", "", html::Escaped(text)); }

std::string Header(const Vehicle& vehicle, const std::vector<std::string>& facts) {
  std::string html;
  for (const std::string& fact : facts) html += Fact(fact) + Fact("\u00b7");
  return "<header>\n<h1>" + html::Escaped(vehicle.name) + "</h1>\n<p class=\"facts\">" + html +
         Fact(Counted(vehicle.parameters.size(), "parameter")) + Fact("\u00b7") +
         Fact(Counted(vehicle.posts.size(), "post")) + Fact("\u00b7") + Fact("fourpost " + Versions().front().second) +
         "</p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
}

std::string FindingsHtml(const Diagnostics& findings) {
  std::string items;
  for (const Diagnostic& finding : findings.ByWeight())
    items += html::Element("li", "", html::Escaped(finding.message)) + '\n';
  return items.empty() ? "" : html::Section("findings", "Findings", "<ul>\n" + items + "</ul>\n");
}

std::string ParametersHtml(const Vehicle& vehicle) {
  std::vector<std::vector<html::Cell>> rows;
  for (const Parameter& parameter : vehicle.parameters) {
    const std::optional<Unit> unit = ParseUnit(parameter.unit);
    const double si = unit ? unit->si : 1;
    rows.push_back({{html::Code(parameter.name), ""},
                    NumberCell(ShownNumber(parameter.value / si, 5)),
                    TextCell(ShownUnit(parameter.unit)),
                    NumberCell(ShownNumber(parameter.lower / si, 5)),
                    NumberCell(ShownNumber(parameter.upper / si, 5))});
  }
  return rows.empty() ? "<p>The file has no parameters.</p>\n"
                      : html::Table({"parameter", "value", "unit", "lower", "upper"}, rows);
}

OrderedJson ChannelJson(const std::string& mode, const FrequencyResponse& response, const ChannelResponse& channel) {
  const std::vector<double> none(response.frequency_Hz.size(), NAN);
  std::vector<double> gain;
  std::vector<double> phase;
  for (const std::complex<double>& value : channel.response) {
    gain.push_back(std::abs(value));
    phase.push_back(std::arg(value) * 180 / std::numbers::pi);
  }
  return {{"recording", mode},
          {"name", channel.name},
          {"unit", channel.unit},
          {"frequency_Hz", PictureNumbers(response.frequency_Hz)},
          {"in_band", std::vector<bool>(response.frequency_Hz.size(), true)},
          {"gain_measured", PictureNumbers(none)},
          {"gain_modelled", PictureNumbers(gain)},
          {"phase_measured", PictureNumbers(none)},
          {"phase_modelled", PictureNumbers(phase)}};
}

OrderedJson ResponsesJson(const std::vector<SweptResponse>& responses) {
  OrderedJson list = OrderedJson::array();
  for (const SweptResponse& swept : responses)
    for (const ChannelResponse& channel : swept.answer.response.channels)
      list.push_back(ChannelJson(swept.mode, swept.answer.response, channel));
  return list;
}

/// Gains are per metre of the post, those of displacements and accelerations plain ratios.
std::string GainUnit(const std::string& unit) { return unit == "m" || unit == "m/s^2" ? "1" : ShownUnit(unit + "/m"); }

/// The largest gain of each channel.
std::string PeaksHtml(const std::vector<SweptResponse>& responses) {
  std::vector<std::vector<html::Cell>> rows;
  for (const SweptResponse& swept : responses)
    for (const ChannelResponse& channel : swept.answer.response.channels) {
      std::size_t peak = 0;
      double most = NAN;
      for (std::size_t i = 0; i < channel.response.size(); ++i)
        if (const double gain = std::abs(channel.response[i]); std::isfinite(gain) && !(gain <= most))
          std::tie(peak, most) = std::pair(i, gain);
      rows.push_back({TextCell(swept.mode),
                      {html::Code(channel.name), ""},
                      NumberCell(ShownNumber(most, 4)),
                      TextCell(GainUnit(channel.unit)),
                      NumberCell(ShownNumber(std::isnan(most) ? NAN : swept.answer.response.frequency_Hz[peak], 3)),
                      TextCell(EngineName(swept.answer.engine))});
    }
  return rows.empty() ? "" : html::Table({"posts", "channel", "largest gain", "unit", "at Hz", "engine"}, rows);
}

std::string ResponsesHtml(const std::vector<SweptResponse>& responses) {
  if (responses.empty()) return "";
  return html::Section(
      "responses", "Frequency responses",
      html::Drawn("responses", "The charts need JavaScript; response.csv of fourpost response has their numbers.") +
          PeaksHtml(responses));
}

std::string SectionsHtml(const std::vector<ReportSection>& sections) {
  std::string html;
  for (const ReportSection& section : sections) html += html::Section(section.id, section.title, section.html);
  return html;
}

/// Null, and the reason in `fault`, where the vehicle cannot be shown.
OrderedJson SceneOf(const Vehicle& vehicle, const VehicleAnswer& answer, std::string& fault) {
  RecordedMotions motions;
  for (const SweptResponse& swept : answer.responses)
    motions.steady.push_back({.name = swept.mode, .excitation = swept.excitation, .differences = {}});
  motions.over_time = answer.over_time;
  try {
    OrderedJson scene = SceneJson(vehicle, motions);
    scene.update(answer.scene);
    return scene;
  } catch (const std::runtime_error& error) {
    fault = error.what();
  }
  return nullptr;
}

std::string Note(const std::string& text) {
  return text.empty() ? "" : html::Element("p", "note", html::Escaped(text)) + '\n';
}

std::string ViewerHtml(const VehicleAnswer& answer, const OrderedJson& scene, const std::string& fault) {
  const std::string viewer =
      scene.is_null() ? "<p class=\"note\">The vehicle is not shown: " + html::Escaped(fault) + "</p>\n"
                      : html::Drawn("viewer", "The moving vehicle needs JavaScript.") +
                            (answer.has_sliders_elsewhere ? "" : html::Drawn("sliders")) + Note(answer.viewer_note);
  return html::Section("vehicle", answer.viewer_title, viewer);
}

}  // namespace

std::string VehiclePage(const Vehicle& vehicle, const VehicleAnswer& answer) {
  std::string fault;
  const OrderedJson scene = SceneOf(vehicle, answer, fault);
  const RunContents contents{.files = {{"vehicle.urdf", answer.file}}, .vehicle = vehicle, .vehicle_fault = ""};
  const OrderedJson live = answer.file.empty() || scene.is_null() ? OrderedJson() : LiveJson(contents, {}, answer.ride);
  OrderedJson data = {{"result", {{"vehicle", vehicle.name}, {"parameters", OrderedJson::array()}}},
                      {"line", "model"},
                      {"responses", ResponsesJson(answer.responses)},
                      {"curves", CurvesJson(answer.curves)},
                      {"scene", scene},
                      {"live", live}};
  data.update(answer.drawn);
  const bool has_modes = answer.shows_modes && !scene.is_null();
  const std::string modes = has_modes ? ModeSectionHtml(nlohmann::json(scene["modes"])) : "";
  const bool is_of_modes = answer.responses.empty() && answer.before.empty();
  const std::string body =
      Header(vehicle, answer.facts) + "<nav id=\"contents\"></nav>\n<main>\n" + FindingsHtml(answer.findings) +
      (is_of_modes ? modes : "") + SectionsHtml(answer.before) + ViewerHtml(answer, scene, fault) +
      ResponsesHtml(answer.responses) + (is_of_modes ? "" : modes) + SectionsHtml(answer.after) +
      html::Section("parameters", "Parameters", ParametersHtml(vehicle)) + "</main>\n" + PageFooter("the vehicle file");
  return ReportDocument(vehicle.name + " \u2013 fourpost", body, CompactJson(data),
                        {.live = live.is_null() ? "" : kLiveProgram, .draws_vehicle = !scene.is_null()});
}

}  // namespace fourpost
