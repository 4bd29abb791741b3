#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "analysis/files/recording/file_bytes.h"

namespace fourpost {

/// Lines of a file that may be larger than memory, without their line ends (LF, CRLF, CR CR LF). One that is longer
/// than any text is cut into pieces.
class FileLines {
 public:
  /// From this byte on; `line`: its number, 1-based. The bytes must outlive the reader.
  explicit FileLines(const FileBytes& bytes, std::uint64_t at = 0, int line = 1)
      : bytes_(&bytes), at_(at), next_line_(line) {}

  /// Valid until the next call; false at the end.
  bool Next(std::string_view& line);
  /// Byte behind the last line.
  std::uint64_t at() const { return at_; }
  /// Number of the last line.
  int line() const { return next_line_ - 1; }

 private:
  const FileBytes* bytes_;
  /// Of the file, from byte buffer_at_ on.
  std::string buffer_;
  std::uint64_t buffer_at_ = 0;
  std::uint64_t at_;
  int next_line_;
};

}  // namespace fourpost
