#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "analysis/files/recording/recording_file.h"
#include "analysis/files/universal/universal_function.h"

namespace fourpost {

/// A universal file (UFF, UNV) of data sets 58 and 58b. Its channels are the functions over time; without any, the
/// frequency responses are read one by one. A channel's name is that of its response entity, else its node and
/// direction, the label of its axis, or the first line of its description. Functions throw RecordingFault.
class UniversalFile : public RecordingFile {
 public:
  explicit UniversalFile(const std::filesystem::path& file);

  std::vector<double> Values(std::size_t channel) const override;

  /// Of a file without functions over time.
  const std::vector<UniversalFunction>& responses() const { return responses_; }
  UniversalNumbers Numbers(const UniversalFunction& function) const { return ReadNumbers(bytes_, function); }

 protected:
  std::vector<double> ClockTimes(std::size_t channel) const override;

 private:
  FileBytes bytes_;
  /// One per channel.
  std::vector<UniversalFunction> histories_;
  std::vector<UniversalFunction> responses_;
};

/// What a function is called; see UniversalFile.
std::string NameOf(const UniversalFunction& function);

}  // namespace fourpost
