#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace fourpost {

/// `fourpost check MODEL`
struct CheckCommand {
  std::filesystem::path model;
  bool json = false;
  /// Print the file with its defaults filled in, in place of the report.
  bool resolved = false;
};

/// How a periodic response is found.
enum class Engine {
  /// Harmonic balance on kinematics linearised about static equilibrium: what the fit uses.
  kLinearised,
  /// Harmonic balance on the full multibody system.
  kFull,
  /// The full multibody system integrated to steady state: the reference.
  kMarch,
};

/// `fourpost response STUDY`
struct ResponseCommand {
  std::filesystem::path study;
  bool json = false;
  Engine engine = Engine::kLinearised;
};

/// `fourpost fit STUDY -o DIR`
struct FitCommand {
  std::filesystem::path study;
  std::filesystem::path output;
  bool json = false;
  /// In place of the study's.
  std::optional<std::uint64_t> seed;
  /// 0: one per processor.
  int threads = 0;
};

// Each prints its result on stdout, all else on stderr, and returns an ExitCode. They throw FaultyInput for a user's
// file that cannot be used, OutputError for a result that cannot be written.

int Run(const CheckCommand& command);
int Run(const ResponseCommand& command);
int Run(const FitCommand& command);

}  // namespace fourpost
