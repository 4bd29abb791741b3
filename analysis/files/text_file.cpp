#include "analysis/files/text_file.h"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "analysis/files/near_file.h"

namespace fourpost {

namespace {

constexpr std::uintmax_t kLargest_GiB = 1;

/// Why it is not opened at all; empty for a file.
std::string WhyNotOpened(const std::filesystem::path& file) {
  if (std::string reason = WhyNoFile(file); !reason.empty()) return reason;
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (failure || size <= kLargest_GiB << 30) return "";
  return "is larger than " + std::to_string(kLargest_GiB) + " GiB; give a part of it, or a lower rate";
}

}  // namespace

std::string WhyNoFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const char* kind = nullptr;
  switch (std::filesystem::status(file, ignored).type()) {
    case std::filesystem::file_type::fifo: kind = "pipe"; break;
    case std::filesystem::file_type::socket: kind = "socket"; break;
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character: kind = "device"; break;
    default: return "";
  }
  return std::string("is a ") + kind + ", not a file; write what it holds to a file, and give that";
}

std::optional<std::string> ReadTextFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  if (std::string reason = WhyNotOpened(file); !reason.empty()) {
    diagnostics.Error(file.string(), 0, std::move(reason));
    return std::nullopt;
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  // Inserting no characters would set failbit, as a failure does: an empty file is passed over.
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  // Reading a folder opens well and fails here.
  if (errno == 0 && stream.is_open() && !stream.bad() && text) return std::move(text).str();
  const std::string reason = std::generic_category().message(errno);
  diagnostics.Error(file.string(), 0, "cannot be read: " + reason + DidYouMeanFile(file));
  return std::nullopt;
}

}  // namespace fourpost
