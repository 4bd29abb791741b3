#include "analysis/files/recording_format.h"

#include <array>
#include <fstream>
#include <string>

#include "analysis/files/findings.h"
#include "analysis/files/hdf5/hdf5_file.h"
#include "analysis/files/lvm/lvm_file.h"
#include "analysis/files/mdf/mdf_file.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/rpc/rpc_file.h"
#include "analysis/files/rpc/rpc_header.h"
#include "analysis/files/tdms/tdms_file.h"
#include "analysis/files/universal/universal_file.h"
#include "analysis/files/universal/universal_index.h"

namespace fourpost {
namespace {

struct RecordingFormat {
  bool (*is)(std::string_view head);
  std::unique_ptr<RecordingFile> (*open)(const std::filesystem::path& file);
};

std::unique_ptr<RecordingFile> OpenUniversal(const std::filesystem::path& file) {
  return std::make_unique<UniversalFile>(file);
}

constexpr std::array<RecordingFormat, 6> kFormats = {{
    {&IsRpc, &OpenRpc},
    {&IsUniversal, &OpenUniversal},
    {&IsTdms, &OpenTdms},
    {&IsMdf, &OpenMdf},
    {&IsLvm, &OpenLvm},
    {&IsHdf5, &OpenHdf5},
}};

const RecordingFormat* FormatOf(const std::filesystem::path& file) {
  const std::string head = FileHead(file);
  for (const RecordingFormat& format : kFormats)
    if (format.is(head)) return &format;
  return nullptr;
}

void Report(const RecordingFault& fault, const std::string& file, Diagnostics& diagnostics) {
  diagnostics.Report(*fault.found().kind, {file, fault.line()}, fault.found().words);
}

}  // namespace

std::string FileHead(const std::filesystem::path& file, std::size_t count) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return "";
  std::string head(count, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

bool IsRecordingFile(const std::filesystem::path& file) { return FormatOf(file) != nullptr; }

std::shared_ptr<const RecordingFile> OpenRecording(const std::filesystem::path& file, Diagnostics& diagnostics) {
  try {
    const RecordingFormat* format = FormatOf(file);
    if (format == nullptr) return nullptr;
    std::shared_ptr<const RecordingFile> opened = format->open(file);
    for (const Found& remark : opened->remarks()) diagnostics.Report(*remark.kind, {file.string()}, remark.words);
    return opened;
  } catch (const RecordingFault& fault) {
    Report(fault, file.string(), diagnostics);
    return nullptr;
  }
}

}  // namespace fourpost
