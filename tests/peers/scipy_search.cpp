#include "tests/peers/scipy_search.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "tests/peers/findings.h"

extern char** environ;

namespace fourpost {
namespace {

// Both ends close when another program starts; what becomes its input or output is a copy that does not.
struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) Refuse(kScipyFailed, {}, {"no pipe to Python"});
  }
  int reading() const { return ends[0]; }
  int writing() const { return ends[1]; }
  std::array<int, 2> ends = {};
};

// A Python process that runs scipy_de.py.
class PythonProcess {
 public:
  PythonProcess() {
    const Pipe to, from;
    Spawn(to, from);
    close(to.reading());
    close(from.writing());
    to_ = fdopen(to.writing(), "w");
    from_ = fdopen(from.reading(), "r");
  }
  PythonProcess(const PythonProcess&) = delete;
  PythonProcess& operator=(const PythonProcess&) = delete;
  // The end of its input ends it.
  ~PythonProcess() {
    std::fclose(to_);
    std::fclose(from_);
    waitpid(process_, nullptr, 0);
  }

  void Write(const std::string& line) {
    std::fputs((line + "\n").c_str(), to_);
    std::fflush(to_);
  }

  std::string Read() {
    std::string line;
    for (int c = std::fgetc(from_); c != '\n'; c = std::fgetc(from_)) {
      if (c == EOF) Refuse(kScipyFailed, {}, {"scipy_de.py ended"});
      line += static_cast<char>(c);
    }
    return line;
  }

 private:
  void Spawn(const Pipe& to, const Pipe& from) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to.reading(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, from.writing(), STDOUT_FILENO);
    std::string python = FOURPOST_PYTHON;
    std::string script = FOURPOST_SCIPY_SCRIPT;
    std::array<char*, 3> arguments = {python.data(), script.data(), nullptr};
    const int error = posix_spawn(&process_, python.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) Refuse(kScipyFailed, {}, {"cannot start " + python});
  }

  pid_t process_ = 0;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

std::string StartLine(std::size_t size, const PeerSettings& settings, std::uint32_t seed) {
  std::ostringstream line;
  line.precision(17);
  line << size << ' ' << seed;
  for (const char* name : {"population", "factor_lower", "factor_upper", "crossover", "variant"})
    line << ' ' << ValueOf(settings, name);
  return line.str();
}

std::vector<double> Numbers(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.c_str();
  for (char* end = nullptr; *at != '\0'; at = end) {
    numbers.push_back(std::strtod(at, &end));
    if (end == at) Refuse(kScipyFailed, {}, {"unexpected answer '" + line + "'"});
  }
  return numbers;
}

std::string HexText(double number) {
  std::array<char, 40> text = {};
  std::snprintf(text.data(), text.size(), "%a", number);
  return text.data();
}

}  // namespace

void MinimiseByScipyDe(PeerObjective& objective, const PeerSettings& settings, std::uint32_t seed) {
  // Importing scipy takes longer than many a search.
  thread_local PythonProcess python;
  python.Write(StartLine(objective.size(), settings, seed));
  for (std::string line = python.Read(); line != "end"; line = python.Read()) {
    try {
      python.Write(HexText(objective(Numbers(line))));
    } catch (...) {
      python.Write("leave");
      throw;
    }
  }
}

}  // namespace fourpost
