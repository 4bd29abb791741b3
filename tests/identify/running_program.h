#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/temporary_folder.h"

namespace fourpost {

/// The program at work in a folder, to send signals to. Killed with its test.
class RunningProgram {
 public:
  RunningProgram(const std::filesystem::path& folder, const std::string& arguments)
      : out_(folder / "running_out.txt"), err_(folder / "running_err.txt") {
    const std::string command = std::string("exec '") + FOURPOST_PROGRAM + "' " + arguments;
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot fork");
    if (pid_ > 0) return;
    const bool ready = chdir(folder.c_str()) == 0 && Redirect(out_, STDOUT_FILENO) && Redirect(err_, STDERR_FILENO);
    if (ready) execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  ~RunningProgram() {
    if (IsRunning()) Signal(SIGKILL);
    Wait();
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  bool IsRunning() {
    if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
    return !ended_;
  }

  void Signal(int signal) const { kill(pid_, signal); }

  /// As shells tell it: 128 + signal when one ended it.
  int Wait() {
    if (!ended_) ended_ = waitpid(pid_, &status_, 0) == pid_;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }

  std::string err() const { return ReadText(err_); }
  std::string out() const { return ReadText(out_); }

 private:
  static bool Redirect(const std::filesystem::path& file, int to) {
    const int from = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    return from >= 0 && dup2(from, to) >= 0;
  }

  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

}  // namespace fourpost
