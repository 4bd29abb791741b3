#include "analysis/files/text_file.h"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/near_file.h"

namespace fourpost {

namespace {

constexpr std::uintmax_t kLargest_GiB = 1;

/// Why it is not opened at all.
Found WhyNotOpened(const std::filesystem::path& file) {
  if (Found reason = WhyNoFile(file)) return reason;
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (failure || size <= kLargest_GiB << 30) return {};
  return {&kFileTooLarge, {std::to_string(kLargest_GiB) + " GiB"}};
}

}  // namespace

Found WhyNoFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const char* kind = nullptr;
  switch (std::filesystem::status(file, ignored).type()) {
    case std::filesystem::file_type::fifo: kind = "pipe"; break;
    case std::filesystem::file_type::socket: kind = "socket"; break;
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character: kind = "device"; break;
    default: return {};
  }
  return {&kFileNotRegular, {kind}};
}

std::optional<std::string> ReadTextFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  if (const Found reason = WhyNotOpened(file)) {
    diagnostics.Report(*reason.kind, {file.string()}, reason.words);
    return std::nullopt;
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  // Inserting no characters would set failbit, as a failure does: an empty file is passed over.
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  // Reading a folder opens well and fails here.
  if (errno == 0 && stream.is_open() && !stream.bad() && text) return std::move(text).str();
  if (errno == ENOENT) diagnostics.Report(kFileNotThere, {file.string()}, {"", DidYouMeanFile(file)});
  else diagnostics.Report(kFileUnreadable, {file.string()}, {std::generic_category().message(errno)});
  return std::nullopt;
}

}  // namespace fourpost
