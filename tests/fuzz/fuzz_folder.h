#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace fourpost {

/// A folder of this process for files to be read, which goes with it; on a file system in memory if TMPDIR is.
class FuzzFolder {
 public:
  explicit FuzzFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("fourpost_" + name + "_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~FuzzFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  FuzzFolder(const FuzzFolder&) = delete;
  FuzzFolder& operator=(const FuzzFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace fourpost
