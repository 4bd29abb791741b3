#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fourpost {

/// Changes of the text of a study, which keep all else, comments included. The text must be that of a study that was
/// read without a fault.
class StudyEdit {
 public:
  explicit StudyEdit(std::string text);

  /// `file: NAME` and the like: every scalar that names one of these files from the study's folder `from` names it from
  /// the folder `to`.
  void Rebase(const std::vector<std::filesystem::path>& files, const std::filesystem::path& from,
              const std::filesystem::path& to);
  /// The value of the key `vehicle`, whose file has the values of its parameters: `start` goes.
  void SetVehicle(const std::string& file);
  /// To the list `free`, where there is one.
  void AddFree(const std::vector<std::string>& names);
  /// Of a `bench` that names no damper, for a vehicle that gets another one.
  void NameDamper(const std::string& name);
  /// Adds `key: value`, such as "delay: 2 ms", to all recorded channels that the sensors of these names are taken from,
  /// in `channels` and in those of `histories`. A delay is added to one that is stated already, a scale multiplied with
  /// it. False, and nothing is changed, where no channel is listed or what is stated cannot be read.
  bool CorrectChannels(const std::vector<std::string>& sensors, const std::string& key, const std::string& value);
  /// Of these sensors, where histories state it: noise of channels that are scaled.
  void ScaleNoise(const std::vector<std::string>& sensors, double factor);

  std::string Text() const;

 private:
  struct Change {
    std::size_t end = 0;
    std::string text;
  };

  std::string text_;
  /// By where they begin.
  std::map<std::size_t, Change> changes_;
};

/// The sensors that the study's `channels` and those of its `histories` name, each once.
std::vector<std::string> MeasuredSensors(const std::string& study_text);

}  // namespace fourpost
