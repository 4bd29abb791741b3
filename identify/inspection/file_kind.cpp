#include "identify/inspection/file_kind.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "analysis/text/diagnostics.h"
#include "identify/inspection/findings.h"

namespace fourpost {
namespace {

enum class FileKind { kVehicle, kStudy, kTable, kPicture, kJson, kFolder, kUnknown };

FileKind KindOf(const std::filesystem::path& file) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) return FileKind::kFolder;
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".urdf" || ending == ".xml") return FileKind::kVehicle;
  if (ending == ".yaml" || ending == ".yml") return FileKind::kStudy;
  if (ending == ".csv") return FileKind::kTable;
  if (ending == ".svg" || ending == ".png") return FileKind::kPicture;
  if (ending == ".json") return FileKind::kJson;
  return FileKind::kUnknown;
}

const char* Called(FileKind kind) {
  switch (kind) {
    case FileKind::kVehicle: return "a vehicle file";
    case FileKind::kStudy: return "a study";
    case FileKind::kTable: return "a table";
    case FileKind::kPicture: return "a picture";
    case FileKind::kJson: return "a JSON file";
    case FileKind::kFolder: return "a folder";
    case FileKind::kUnknown: break;
  }
  return "a file of unknown kind";
}

[[noreturn]] void RefuseKind(const std::filesystem::path& file, FileKind kind, const std::string& needed) {
  Refuse(kFileOfOtherKind, {file.string()}, {Called(kind), needed});
}

}  // namespace

void RequireVehicleFile(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kStudy) Refuse(kStudyForVehicle, {file.string()});
  if (kind != FileKind::kVehicle && kind != FileKind::kUnknown) RefuseKind(file, kind, "a vehicle file (.urdf)");
}

void RequireStudyFile(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kVehicle) Refuse(kVehicleForStudy, {file.string()});
  if (kind != FileKind::kStudy && kind != FileKind::kUnknown) RefuseKind(file, kind, "a study (.yaml)");
}

void RequireTable(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind != FileKind::kTable && kind != FileKind::kUnknown)
    RefuseKind(file, kind, "a recording (.csv, .mat, .rsp, .uff, .tdms, .mf4, .lvm, .h5)");
}

bool MayBeRecording(const std::filesystem::path& file, Diagnostics& faults) {
  const FileKind kind = KindOf(file);
  switch (kind) {
    case FileKind::kVehicle: faults.Report(kVehicleForRecording, {file.string()}); return false;
    case FileKind::kStudy:
    case FileKind::kFolder: faults.Report(kFolderForRecording, {file.string()}); return false;
    case FileKind::kPicture:
    case FileKind::kJson:
      faults.Report(kFileOfOtherKind, {file.string()},
                    {Called(kind), "a recording (.csv, .mat, .rsp, .uff, .tdms, .mf4, .lvm, .h5)"});
      return false;
    case FileKind::kTable:
    case FileKind::kUnknown: break;
  }
  return true;
}

bool IsStudy(const std::filesystem::path& file) { return KindOf(file) == FileKind::kStudy; }

bool IsStudyNotVehicle(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kStudy) return true;
  if (kind != FileKind::kVehicle && kind != FileKind::kUnknown)
    RefuseKind(file, kind, "a vehicle file (.urdf) or a study (.yaml)");
  return false;
}

}  // namespace fourpost
