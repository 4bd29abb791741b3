#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace fourpost {

/// The bytes of a file that is open, read piece by piece where they are asked for. Nothing is taken into memory before
/// it is known to be there. Functions throw RecordingFault.
class FileBytes {
 public:
  /// `format`: for messages.
  FileBytes(const std::filesystem::path& file, std::string format);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  std::uint64_t size() const { return size_; }
  const std::string& format() const { return format_; }
  /// That so many bytes of `what` begin at `at`.
  void Require(std::uint64_t at, std::uint64_t count, const std::string& what) const;
  /// Just these.
  std::string Read(std::uint64_t at, std::uint64_t count, const std::string& what) const;
  /// Those that there are of them.
  std::string ReadUpTo(std::uint64_t at, std::uint64_t count) const;

 private:
  std::string format_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace fourpost
