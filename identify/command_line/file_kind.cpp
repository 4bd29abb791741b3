#include "identify/command_line/file_kind.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "analysis/text/diagnostics.h"

namespace fourpost {
namespace {

enum class FileKind { kVehicle, kStudy, kTable, kPicture, kResult, kFolder, kUnknown };

FileKind KindOf(const std::filesystem::path& file) {
  std::error_code failure;
  if (std::filesystem::is_directory(file, failure)) return FileKind::kFolder;
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".urdf" || ending == ".xml") return FileKind::kVehicle;
  if (ending == ".yaml" || ending == ".yml") return FileKind::kStudy;
  if (ending == ".csv") return FileKind::kTable;
  if (ending == ".svg" || ending == ".png") return FileKind::kPicture;
  if (ending == ".json") return FileKind::kResult;
  return FileKind::kUnknown;
}

const char* Called(FileKind kind) {
  switch (kind) {
    case FileKind::kVehicle: return "a vehicle file";
    case FileKind::kStudy: return "a study";
    case FileKind::kTable: return "a table";
    case FileKind::kPicture: return "a picture";
    case FileKind::kResult: return "a result";
    case FileKind::kFolder: return "a folder";
    case FileKind::kUnknown: break;
  }
  return "of unknown kind";
}

[[noreturn]] void Refuse(const std::filesystem::path& file, FileKind kind, const std::string& wanted) {
  Diagnostics faults;
  faults.Error(file.string(), 0, std::string("is ") + Called(kind) + "; " + wanted + " is wanted here");
  throw FaultyInput(faults);
}

}  // namespace

void RequireVehicleFile(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kStudy) Refuse(file, kind, "a vehicle file (.urdf), such as the one that it names,");
  if (kind != FileKind::kVehicle && kind != FileKind::kUnknown) Refuse(file, kind, "a vehicle file (.urdf)");
}

void RequireStudyFile(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kVehicle) Refuse(file, kind, "a study (.yaml), which names its vehicle and recordings,");
  if (kind != FileKind::kStudy && kind != FileKind::kUnknown) Refuse(file, kind, "a study (.yaml)");
}

void RequireTable(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind != FileKind::kTable && kind != FileKind::kUnknown) Refuse(file, kind, "a table (.csv)");
}

std::string NoRecording(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  const std::string is = std::string("is ") + Called(kind) + "; ";
  switch (kind) {
    case FileKind::kVehicle: return is + "`fourpost check` and `fourpost params` tell what it holds";
    case FileKind::kStudy:
      return is + "`fourpost response` compares its vehicle with its recordings; name these to see what they hold";
    case FileKind::kFolder: return is + "name the recordings in it; what a fit wrote is shown by `fourpost report`";
    case FileKind::kPicture:
    case FileKind::kResult: return is + "a recording (.csv, .mat) is wanted here";
    case FileKind::kTable:
    case FileKind::kUnknown: break;
  }
  return "";
}

bool IsStudyNotVehicle(const std::filesystem::path& file) {
  const FileKind kind = KindOf(file);
  if (kind == FileKind::kStudy) return true;
  if (kind != FileKind::kVehicle && kind != FileKind::kUnknown)
    Refuse(file, kind, "a vehicle file (.urdf) or a study (.yaml)");
  return false;
}

}  // namespace fourpost
