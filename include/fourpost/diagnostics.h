#pragma once

#include <stdexcept>
#include <string>
#include <vector>

/// Identification of vehicle suspension models from rig tests. Values are SI and doubles, angles in radians, unless a
/// name says otherwise ("_Hz", "_deg", "_percent"). Channels, posts and parameters go by their names in the vehicle
/// file.
namespace fourpost::api {

/// An error or a warning about the input, as `fourpost` prints it.
struct Finding {
  /// Lower case with hyphens; never changes. `fourpost help CODE` explains it.
  std::string code;
  bool is_error = false;
  /// Where it is; empty and 0 where it is in no file or about the file as a whole.
  std::string file;
  int line = 0;
  /// The argument or option that it is about, where it is about one: "--profile".
  std::string argument;
  /// What is wrong and what to do.
  std::string text;
};

/// What ends a call: the input cannot be used, no motion could be computed, or results could not be written.
class Error : public std::runtime_error {
 public:
  enum class Kind { kInput, kSimulation, kOutput };

  Error(Kind kind, const std::string& message, std::vector<Finding> findings)
      : std::runtime_error(message), kind_(kind), findings_(std::move(findings)) {}

  Kind kind() const { return kind_; }
  /// All that was found, errors and warnings; at least one error of kInput; of kSimulation the one that
  /// ended it, where it has a code.
  const std::vector<Finding>& findings() const { return findings_; }

 private:
  Kind kind_;
  std::vector<Finding> findings_;
};

}  // namespace fourpost::api
