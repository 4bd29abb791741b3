#include <cstdio>

#include <nlohmann/json.hpp>

#include "analysis/files/inputs_elsewhere.h"
#include "analysis/files/json_text.h"
#include "analysis/files/output_folder.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/measured_response_files.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/file_kind.h"
#include "identify/command_line/print.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

constexpr const char* kMark = "frf.json";

void Write(const std::filesystem::path& folder, const std::string& json, const MeasuredResponses& measured) {
  OutputFolder output(folder, "", kMark);
  for (const MeasuredResponse& response : measured.responses) {
    output.Add(response.name + ".csv", RecordingCsv(response.response));
    output.Add(response.name + ".uff", RecordingUniversal(response, measured.posts[response.shares.reference]));
    output.Add(response.name + ".svg", MeasuredSvg(response, measured.kind));
  }
  output.Add("recordings.yaml", StudySection(measured));
  output.Add(kMark, json);
  output.Commit();
  std::fprintf(stderr, "results: %s\n", folder.string().c_str());
}

/// What a user of this command has perhaps forgotten to state.
void FindWhatIsMissing(const FrfCommand& command, const MeasuredResponses& measured, Diagnostics& findings) {
  const Place place{command.request.files.front().string()};
  std::string unknown;
  for (const std::string& channel : measured.unit_unknown) unknown += (unknown.empty() ? "" : ", ") + channel;
  if (!unknown.empty()) findings.Report(kResponseUnitUnknown, place, {unknown});
  for (const std::string& channel : measured.like_posts) findings.Report(kResponseLikePost, place, {channel, channel});
}

}  // namespace

int Run(const FrfCommand& command) {
  Diagnostics findings = command.faults;
  bool all_may_be = true;
  for (const std::filesystem::path& file : command.request.files)
    all_may_be = MayBeRecording(file, findings) && all_may_be;
  for (const OtherFile& other : command.request.preparation.times.others)
    all_may_be = MayBeRecording(other.path, findings) && all_may_be;
  if (!all_may_be || findings.HasErrors()) throw FaultyInput(findings);
  if (!command.output.empty()) {
    std::vector<std::filesystem::path> inputs = command.request.files;
    for (const OtherFile& other : command.request.preparation.times.others) inputs.push_back(other.path);
    RequireInputsElsewhere(inputs, command.output);
    OutputFolder(command.output, "", kMark);
  }
  const std::optional<MeasuredResponses> measured = MeasureResponses(command.request, findings);
  if (!measured) throw FaultyInput(findings);
  FindWhatIsMissing(command, *measured, findings);
  Tell(findings);
  nlohmann::ordered_json json = MeasuredJson(*measured);
  json["warnings"] = WarningsJson(findings);
  const std::string text = JsonText(json);
  if (!command.output.empty()) Write(command.output, text, *measured);
  if (command.json) Print(text);
  else PrintText(MeasuredText(*measured) + (command.output.empty() ? "\n" + StudySection(*measured) : ""));
  return kGood;
}

}  // namespace fourpost
