#include "identify/inspection/measured_files.h"

#include <algorithm>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/measured_response_files.h"
#include "analysis/measured_response/plausible_amplitude.h"
#include "analysis/text/short_number.h"
#include "identify/inspection/file_kind.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

constexpr const char* kMark = "frf.json";

std::vector<std::filesystem::path> FilesOf(const ResponseRequest& request) {
  std::vector<std::filesystem::path> files = request.files;
  for (const OtherFile& other : request.preparation.times.others) files.push_back(other.path);
  return files;
}

/// "--post post_FL=FL --post psot_RR=NAME"
std::string PostOptions(const MeasuredResponses& measured, const std::string& more) {
  std::string options;
  for (std::size_t p = 0; p < measured.posts.size(); ++p)
    options += "--post '" + measured.post_channels[p] + "=" + measured.posts[p] + "' ";
  return options + "--post '" + more + "=NAME'";
}

/// What a user has perhaps forgotten to state.
void FindWhatIsMissing(const ResponseRequest& request, const MeasuredResponses& measured, Diagnostics& findings) {
  const Place place{request.files.front().string()};
  std::string unknown;
  for (const std::string& channel : measured.unit_unknown) unknown += (unknown.empty() ? "" : ", ") + channel;
  if (!unknown.empty()) findings.Report(kResponseUnitUnknown, place, {unknown});
  for (std::size_t i = 0; i < measured.like_posts.size(); ++i) {
    const std::string& channel = measured.like_posts[i];
    const std::string& meant = measured.nearly_posts[i];
    if (!request.posts.empty() || meant.empty()) findings.Report(kResponseLikePost, place, {channel, channel});
    else findings.Report(kResponsePostMisspelt, place, {channel, meant, PostOptions(measured, channel)});
  }
}

/// Posts that move as none do: the unit is another one.
void CheckSizes(const ResponseRequest& request, const MeasuredResponses& measured, Diagnostics& findings) {
  double most = 0;
  for (const MeasuredResponse& response : measured.responses)
    for (const double amplitude : response.response.amplitude_m) most = std::max(most, amplitude);
  if (most >= kSurelyNoAmplitude_m && most <= kMostAmplitude_m) return;
  const std::string& channel = measured.post_channels[measured.responses.front().shares.reference];
  findings.Report(kResponsePostSize, {request.files.front().string()},
                  {channel, ShortNumber(1e3 * most, 3), channel, most > kMostAmplitude_m ? "mm" : "m"});
}

}  // namespace

void RequireRecordings(const ResponseRequest& request, Diagnostics& findings) {
  bool all_may_be = true;
  for (const std::filesystem::path& file : FilesOf(request)) all_may_be = MayBeRecording(file, findings) && all_may_be;
  if (!all_may_be || findings.HasErrors()) throw FaultyInput(findings);
}

MeasuredResponses MeasureFiles(const ResponseRequest& request, Diagnostics& findings) {
  std::optional<MeasuredResponses> measured = MeasureResponses(request, findings);
  if (measured) CheckSizes(request, *measured, findings);
  if (!measured || findings.HasErrors()) throw FaultyInput(findings);
  FindWhatIsMissing(request, *measured, findings);
  if (findings.HasErrors()) throw FaultyInput(findings);
  return *std::move(measured);
}

std::string MeasuredFilesJson(const MeasuredResponses& measured, const Diagnostics& findings) {
  nlohmann::ordered_json json = MeasuredJson(measured);
  json["warnings"] = WarningsJson(findings);
  return JsonText(json);
}

void RequireMeasuredFolder(const ResponseRequest& request, const std::filesystem::path& folder) {
  RequireInputsElsewhere(FilesOf(request), folder);
  OutputFolder(folder, "", kMark);
}

void WriteMeasured(const std::filesystem::path& folder, const std::string& json, const MeasuredResponses& measured) {
  OutputFolder output(folder, "", kMark);
  for (const MeasuredResponse& response : measured.responses) {
    output.Add(response.name + ".csv", RecordingCsv(response.response));
    output.Add(response.name + ".uff", RecordingUniversal(response, measured.posts[response.shares.reference]));
    output.Add(response.name + ".svg", MeasuredSvg(response, measured.kind));
  }
  output.Add("recordings.yaml", StudySection(measured));
  output.Add(kMark, json);
  output.Commit();
}

}  // namespace fourpost
