#pragma once

#include <sys/wait.h>

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
      std::filesystem::copy(std::filesystem::path(FOURPOST_SOURCE_DIR) / part, folder_ / part,
                            std::filesystem::copy_options::recursive);
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
