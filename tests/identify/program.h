#pragma once

#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace fourpost {

/// What the program answered.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// A copy of the shipped data in a folder of its own, in which a test may break one thing.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() {
    for (const char* part : {"urdf", "meshes", "studies"})
      Copy(std::filesystem::path(FOURPOST_SOURCE_DIR) / part, folder_ / part);
  }

  /// Large recordings, which no test changes, as links.
  static void Copy(const std::filesystem::path& from, const std::filesystem::path& to) {
    constexpr std::uintmax_t kLarge = 300000;
    std::filesystem::create_directories(to);
    for (const auto& entry : std::filesystem::directory_iterator(from)) {
      const std::filesystem::path target = to / entry.path().filename();
      if (entry.is_directory()) Copy(entry.path(), target);
      else if (entry.file_size() > kLarge) std::filesystem::create_symlink(entry.path(), target);
      else std::filesystem::copy_file(entry.path(), target);
    }
  }

  Outcome Run(const std::string& arguments) const {
    return RunShell(std::string("'") + FOURPOST_PROGRAM + "' " + arguments);
  }

  Outcome RunShell(const std::string& line) const {
    const std::filesystem::path out = folder_ / "stdout.txt";
    const std::filesystem::path err = folder_ / "stderr.txt";
    const std::string command =
        "cd '" + folder_.string() + "' && (" + line + ") >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(out), ReadText(err)};
  }

  void ReplaceIn(const std::filesystem::path& file, const std::string& what, const std::string& with) const {
    const std::string text = Replace(ReadText(folder_ / file), what, with);
    temporary_.Write(file, text);
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
};

}  // namespace fourpost
