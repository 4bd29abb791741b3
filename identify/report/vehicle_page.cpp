#include "identify/report/vehicle_page.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/picture_number.h"
#include "analysis/report/report_document.h"
#include "analysis/report/shown_number.h"
#include "analysis/text/units.h"
#include "identify/live/live_program.h"
#include "identify/report/live_json.h"
#include "identify/report/page_footer.h"
#include "identify/report/report_tables.h"
#include "identify/report/scene_json.h"
#include "vehicles/requests/versions.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;
using html::NumberCell;
using html::TextCell;

std::string Header(const Vehicle& vehicle, std::size_t posts) {
  return "<header>\n<h1>" + html::Escaped(vehicle.name) +
         "</h1>\n<p class=\"facts\"><span>not fitted</span><span>\u00b7</span>" + "<span>" +
         std::to_string(vehicle.parameters.size()) + " parameters</span><span>\u00b7</span><span>" +
         std::to_string(posts) + " posts</span><span>\u00b7</span><span>fourpost " + Versions().front().second +
         "</span></p>\n<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
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

RecordedMotions MotionsOf(const std::vector<SweptResponse>& responses) {
  RecordedMotions motions;
  for (const SweptResponse& swept : responses)
    motions.steady.push_back({.name = swept.mode, .excitation = swept.excitation, .differences = {}});
  return motions;
}

}  // namespace

std::string VehiclePage(const std::string& file, const Vehicle& vehicle, const std::vector<SweptResponse>& responses) {
  const OrderedJson scene = SceneJson(vehicle, MotionsOf(responses));
  const RunContents contents{.files = {{"vehicle.urdf", file}}, .vehicle = vehicle, .vehicle_fault = ""};
  const OrderedJson live = LiveJson(contents, {});
  const OrderedJson data = {
      {"result", {{"vehicle", vehicle.name}, {"parameters", OrderedJson::array()}}},
      {"responses", ResponsesJson(responses)},
      {"scene", scene},
      {"live", live},
  };
  const std::string body =
      Header(vehicle, vehicle.posts.size()) + "<nav id=\"contents\"></nav>\n<main>\n" +
      html::Section("vehicle", "The vehicle on its posts",
                    html::Drawn("viewer", "The moving vehicle needs JavaScript.")) +
      html::Section("responses", "Frequency responses",
                    html::Drawn("responses", "The charts need JavaScript; fourpost response prints their numbers.")) +
      html::Section("modes", "Modes and poles",
                    "<div class=\"pair\"><div>" + ModeTableHtml(nlohmann::json(scene["modes"])) + "</div><div>" +
                        html::Drawn("poles") + "</div></div>\n") +
      html::Section("parameters", "Parameters", ParametersHtml(vehicle)) + "</main>\n" + PageFooter("the vehicle file");
  return ReportDocument(vehicle.name + " \u2013 fourpost", body, CompactJson(data),
                        {.live = live.is_null() ? "" : kLiveProgram, .draws_vehicle = true});
}

}  // namespace fourpost
