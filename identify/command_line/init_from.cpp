#include "identify/command_line/init_from.h"

#include <algorithm>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/work_progress.h"
#include "identify/draft/study_draft.h"
#include "identify/inspection/file_kind.h"
#include "identify/study_file/channel_source_text.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kStudyFile = "study.yaml";

/// Files in folders that may be recordings, in the order of their names; files that are named must be.
std::vector<fs::path> RecordingsAmong(const std::vector<fs::path>& named, Diagnostics& findings) {
  std::vector<fs::path> files;
  for (const fs::path& one : named) {
    std::error_code failure;
    if (!fs::is_directory(one, failure)) {
      if (MayBeRecording(one, findings)) files.push_back(one);
      continue;
    }
    std::vector<fs::path> inside;
    Diagnostics of_others;
    for (const fs::directory_entry& entry : fs::directory_iterator(one, failure))
      if (entry.is_regular_file(failure) && !entry.path().filename().string().starts_with(".") &&
          MayBeRecording(entry.path(), of_others))
        inside.push_back(entry.path());
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string WordsFor(ChannelMatch::By by) {
  switch (by) {
    case ChannelMatch::By::kName: return "name";
    case ChannelMatch::By::kLikeName: return "like name";
    case ChannelMatch::By::kPlace: return "place";
    case ChannelMatch::By::kKind: return "kind";
    case ChannelMatch::By::kMotion: return "motion";
    case ChannelMatch::By::kLast: return "last";
  }
  return "";
}

/// How the match was found; empty of what is none of a sensor.
std::string HowFound(const DraftedFile& file, const DraftedChannel& channel) {
  for (const ChannelMatch& match : file.matches)
    if (match.name == channel.of)
      return WordsFor(match.by) + (match.correlation ? ", correlation " + Rounded(*match.correlation, 2) : "");
  return "";
}

std::string TextOf(const StudyDraft& draft, const fs::path& study) {
  TextTable table({"file", "channel", "of the vehicle", "by", "", ""});
  std::string unused;
  std::string named;
  bool has_rows = false;
  for (const DraftedFile& file : draft.files) {
    const std::string name = file.path.filename().string();
    if (!file.is_used) unused += "not used: " + name + ": " + file.use + '\n';
    for (const DraftedChannel& channel : file.channels) {
      if (!file.same_as.empty()) break;
      has_rows = true;
      table.Add({name, channel.name, channel.of, HowFound(file, channel), StateName(channel.state), channel.why});
    }
    if (file.use == "bench") named += name + ": bench\n";
    else if (file.is_used)
      named += name + ": " + file.use + "; " + std::to_string(file.matches.size()) + " of " +
               std::to_string(file.matches.size() + file.without_channel.size()) + " sensors have a channel" +
               (file.without_channel.empty() ? ""
                : !file.same_as.empty()      ? ", as of " + file.same_as
                                             : ", not: " + Listed(file.without_channel)) +
               '\n';
  }
  return named + (has_rows ? table.Format() : "") + unused + "wrote\n  " + study.string() + "\nnext\n  " +
         (draft.findings.HasErrors() ? "correct what its first lines name\n  " : "") + "fourpost fit " +
         study.string() + " -o run\n";
}

std::string JsonOf(const StudyDraft& draft, const fs::path& folder) {
  Json recordings = Json::array();
  for (const DraftedFile& file : draft.files) {
    Json matches = Json::array();
    for (const ChannelMatch& match : file.matches)
      matches.push_back({{"name", match.name},
                         {"channel", SourceText(match.source)},
                         {"by", WordsFor(match.by)},
                         {"correlation", match.correlation ? Json(*match.correlation) : Json()},
                         {"sure", match.IsSure()}});
    Json channels = Json::array();
    for (const DraftedChannel& channel : file.channels)
      channels.push_back({{"name", channel.name},
                          {"of", channel.of.empty() ? Json() : Json(channel.of)},
                          {"state", StateName(channel.state)},
                          {"why", channel.why}});
    recordings.push_back({{"file", file.path.string()},
                          {"use", file.is_used ? Json(file.use) : Json()},
                          {"reason", file.is_used ? Json() : Json(file.use)},
                          {"matches", matches},
                          {"channels", channels},
                          {"channels_left", file.channels_left},
                          {"sensors_left", file.sensors_left}});
  }
  return JsonText(Json{{"folder", folder.string()},
                       {"files", {kStudyFile}},
                       {"recordings", recordings},
                       {"warnings", WarningsJson(draft.findings)}});
}

}  // namespace

int RunInitFrom(const InitCommand& command) {
  const fs::path study = command.folder / kStudyFile;
  std::error_code failure;
  if (fs::exists(command.folder, failure) && !fs::is_directory(command.folder, failure))
    RefuseToWrite(kStarterFolderIsFile, command.folder);
  if (fs::exists(study, failure)) RefuseToWrite(kDraftIsThere, study);
  Diagnostics findings = command.faults;
  const std::vector<fs::path> files = RecordingsAmong(command.from, findings);
  const std::optional<Vehicle> vehicle = ReadVehicle(command.vehicle, findings);
  if (files.empty() && !findings.HasErrors()) findings.Report(kNothingToDraftFrom, {command.from.front().string()});
  if (!vehicle || findings.HasErrors()) throw FaultyInput(findings);
  WorkProgress progress;
  const StudyDraft draft =
      DraftStudy(files, *vehicle, study, {.units = command.units, .posts = command.posts}, progress.Hooks());
  progress.End();
  const bool is_any_used =
      std::any_of(draft.files.begin(), draft.files.end(), [](const DraftedFile& file) { return file.is_used; });
  for (const DraftedFile& file : draft.files)
    if (!is_any_used || (!file.is_used && file.has_misspelt_post))
      findings.Report(kNotDrafted, {file.path.string()}, {file.use});
  if (findings.HasErrors()) throw FaultyInput(findings);
  fs::create_directories(command.folder, failure);
  if (failure) RefuseToWrite(command.folder, failure);
  WriteFile(study, draft.text);
  Tell(draft.findings);
  if (command.json) Print(JsonOf(draft, command.folder));
  else PrintText(TextOf(draft, study));
  return kGood;
}

}  // namespace fourpost
