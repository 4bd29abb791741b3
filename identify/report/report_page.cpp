#include "identify/report/report_page.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/report_document.h"
#include "analysis/report/shown_number.h"
#include "identify/live/live_program.h"
#include "identify/report/audit_section.h"
#include "identify/report/live_json.h"
#include "identify/report/page_footer.h"
#include "identify/report/parameter_table.h"
#include "identify/report/report_summary.h"
#include "identify/report/report_tables.h"
#include "identify/report/run_result.h"
#include "identify/report/scene_json.h"
#include "identify/study_file/study_about.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

using Parts = std::vector<std::unique_ptr<ExperimentData>>;

Parts PartsOf(const RunFolder& run, ExperimentReports experiments) {
  Parts parts;
  for (const ExperimentReport* experiment : experiments) parts.push_back(experiment->Read(run));
  return parts;
}

ReportRemarks RemarksOf(const Parts& parts) {
  ReportRemarks remarks;
  for (const auto& part : parts) AddRemarks(part->Remarks(), remarks);
  return remarks;
}

/// Null, and the reason in `fault`, where there is nothing to show.
OrderedJson SceneOf(const Parts& parts, const RunContents& run, std::string& fault) {
  fault = run.vehicle_fault;
  if (!run.vehicle) return nullptr;
  try {
    RecordedMotions motions;
    for (const auto& part : parts) part->AddMotions(*run.vehicle, motions);
    return SceneJson(*run.vehicle, motions);
  } catch (const std::runtime_error& error) {
    fault = error.what();
  } catch (const std::invalid_argument& error) {
    fault = error.what();
  }
  return nullptr;
}

StudyAbout AboutOf(const RunContents& run) {
  const auto study = run.files.find("study.yaml");
  return study == run.files.end() ? StudyAbout() : StudyAboutOf(study->second);
}

/// The car's name where the study has one, else its file's.
std::string TitleOf(const Json& result, const StudyAbout& about) {
  return about.car.empty() ? TextAt(result, "vehicle") : about.car;
}

/// Words with dots between them.
class Facts {
 public:
  void Add(const std::string& html) {
    if (!html.empty()) html_ += (html_.empty() ? "" : "<span>\u00b7</span>") + html;
  }
  std::string Html() const { return html_.empty() ? "" : "<p class=\"facts\">" + html_ + "</p>\n"; }

 private:
  std::string html_;
};

/// What was tested, where, when and by whom.
std::string Identity(const Json& result, const StudyAbout& about) {
  Facts facts;
  if (!about.car.empty()) facts.Add(html::Escaped(TextAt(result, "vehicle")));
  facts.Add(html::Escaped(about.rig));
  facts.Add(html::Escaped(about.date));
  facts.Add(html::Escaped(about.operated_by));
  return facts.Html();
}

std::string Header(const Json& result, const StudyAbout& about) {
  Facts facts;
  facts.Add(html::Escaped(TextAt(result, "study")));
  const std::vector<Json> band = ListAt(result, "band_Hz");
  if (band.size() == 2 && band[0].is_number() && band[1].is_number() && band[1] > 0)
    facts.Add(ShownShort(band[0], 3) + "\u2013" + ShownShort(band[1], 3) + " Hz");
  const auto add_count = [&](double count, const char* of) {
    if (!std::isnan(count)) facts.Add(ShownDecimals(count, 0) + of);
  };
  add_count(NumberAt(result, "residuals"), " residuals");
  add_count(NumberAt(result.value("evaluations", Json()), "paid"), " evaluations");
  if (const std::string version = TextAt(result.value("versions", Json()), "fourpost"); !version.empty())
    facts.Add("fourpost " + html::Escaped(version));
  return "<header>\n<h1>" + html::Escaped(TitleOf(result, about)) + "</h1>\n" + Identity(result, about) + facts.Html() +
         "<button id=\"theme\" type=\"button\" hidden>dark</button>\n</header>\n";
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

/// "80 to 90 %"; empty of runs of older versions.
std::string ConfidenceOf(const Json& result) { return TextAt(result.value("intervals", Json()), "confidence"); }

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
  return html::Section("determination", "What the data determine",
                       Directions(result) + why + html::Drawn("correlation"));
}

/// Where the vehicle cannot be shown, whether that is worth a word: a damper between clamps does nothing worth a
/// picture.
bool IsOnPosts(const Parts& parts) {
  bool is_beside = false;
  for (const auto& part : parts) {
    if (part->empty()) continue;
    if (part->IsOnPosts()) return true;
    is_beside = true;
  }
  return !is_beside;
}

/// Of what the folder holds of each experiment, and once the errors of all channels.
std::string Sections(const Parts& parts, const Json& result) {
  std::string html;
  bool has_channels = false;
  for (const auto& part : parts) {
    if (part->empty()) continue;
    for (const ReportSection& section : part->Sections()) {
      const bool is_place = section.has_channels && !has_channels;
      html += html::Section(section.id, section.title, section.html + (is_place ? ChannelTableHtml(result) : ""));
      has_channels |= is_place;
    }
  }
  return html;
}

std::string ViewerHtml(const OrderedJson& scene, const std::string& fault) {
  return html::Section("vehicle", "The vehicle on its posts",
                       scene.is_null()
                           ? "<p class=\"note\">The vehicle is not shown: " + html::Escaped(fault) + "</p>\n"
                           : html::Drawn("viewer", "The moving vehicle needs JavaScript.") + html::Drawn("sliders"));
}

std::string Body(const Json& result, const Parts& parts, const OrderedJson& scene, const std::string& scene_fault,
                 const std::string& why_no_deviations) {
  const bool is_shown = scene.is_null() ? IsOnPosts(parts) : !scene["posts"].empty();
  std::string body;
  if (is_shown) body += ViewerHtml(scene, scene_fault);
  body += Sections(parts, result);
  if (const std::string audit = AuditHtml(result); !audit.empty())
    body += html::Section("audit", "Audit of the rig", audit);
  body += Determination(result, why_no_deviations);
  if (!scene.is_null() && is_shown) body += ModeSectionHtml(Json(scene["modes"]));
  return body + html::Section("search", "Search and refinement",
                              SearchNoteHtml(result) + html::Drawn("convergence") +
                                  Pair(StartTableHtml(result), html::Drawn("agreement")) + SettingsHtml(result));
}

/// What the scripts draw, with sliders where posts move the vehicle: `parameters` are the fitted ones.
OrderedJson DataOf(const Json& result, const Parts& parts, const OrderedJson& scene, const RunContents& run,
                   const std::vector<ReportedParameter>& parameters) {
  OrderedJson data = {{"result", OrderedJson(result)}, {"scene", scene}};
  for (const auto& part : parts) data.update(part->Drawn());
  const auto has = [&](const char* key) { return data.contains(key) && !data[key].empty(); };
  const bool is_live = !scene.is_null() && (has("responses") || has("histories"));
  data["live"] = is_live ? LiveJson(run, parameters) : OrderedJson();
  return data;
}

std::string PageOf(const std::string& title, const std::string& body, const OrderedJson& data) {
  return ReportDocument(
      title, body, CompactJson(data),
      {.live = data["live"].is_null() ? "" : kLiveProgram, .draws_vehicle = !data["scene"].is_null()});
}

}  // namespace

std::string StudyResponsePage(const RunContents& run, ExperimentReports experiments) {
  Json result = Json::parse(run.files.at("result.json"));
  result["vehicle"] = run.vehicle->name;
  result["parameters"] = Json::array();
  const Parts parts = PartsOf({"", run, result}, experiments);
  std::string fault;
  const OrderedJson scene = SceneOf(parts, run, fault);
  const bool is_shown = scene.is_null() ? IsOnPosts(parts) : !scene["posts"].empty();
  const StudyAbout about = AboutOf(run);
  const std::string body = Header(result, about) + "<nav id=\"contents\"></nav>\n<main>\n" +
                           (is_shown ? ViewerHtml(scene, fault) : "") + Sections(parts, result) +
                           (is_shown && !scene.is_null() ? ModeSectionHtml(Json(scene["modes"])) : "") + "</main>\n" +
                           PageFooter("the study and its vehicle, which was not fitted");
  OrderedJson data = DataOf(result, parts, scene, run, {});
  data["line"] = "model";
  return PageOf(TitleOf(result, about) + " \u2013 fourpost", body, data);
}

std::string ReportPage(const RunContents& run, ExperimentReports experiments) {
  const Json result = FitResultOf(run);
  const Parts parts = PartsOf({"", run, result}, experiments);
  const ReportRemarks remarks = RemarksOf(parts);
  const std::vector<ReportedParameter> parameters = ReportedParameters(result, run);
  const std::string why = WhyNoDeviations(parameters, remarks.why_no_deviations);
  std::string scene_fault;
  const OrderedJson scene = SceneOf(parts, run, scene_fault);

  const FitOverview overview = OverviewOf(result);
  const StudyAbout about = AboutOf(run);
  const std::string body = Header(result, about) + "<nav id=\"contents\"></nav>\n<main>\n" +
                           html::Section("summary", "Summary", SummaryHtml(result, overview, parameters, remarks)) +
                           html::Section("parameters", "Parameters",
                                         ParameterTableHtml(parameters, why, ConfidenceOf(result)) +
                                             IntervalBasisHtml(parameters, result, overview) + Profiles(result, run)) +
                           Body(result, parts, scene, scene_fault, why) + "</main>\n" +
                           PageFooter("the files in the folder of the fit");
  OrderedJson data = DataOf(result, parts, scene, run, parameters);
  data["overview"] = OverviewJson(overview);
  return PageOf(TitleOf(result, about) + " \u2013 fourpost report", body, data);
}

}  // namespace fourpost
