#include "vehicles/shapes/sound_meshes.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>

#include "vehicles/shapes/mesh.h"

namespace fourpost {
namespace {

struct FileState {
  std::uintmax_t size = 0;
  std::filesystem::file_time_type time;
  bool operator==(const FileState&) const = default;
};

std::optional<FileState> StateOf(const std::filesystem::path& file) {
  std::error_code failure;
  FileState state;
  state.size = std::filesystem::file_size(file, failure);
  if (!failure) state.time = std::filesystem::last_write_time(file, failure);
  return failure ? std::nullopt : std::optional(state);
}

class SoundMeshes {
 public:
  bool Has(const std::filesystem::path& file, const FileState& state) {
    const std::lock_guard lock(mutex_);
    const auto found = states_.find(file);
    return found != states_.end() && found->second == state;
  }

  void Add(const std::filesystem::path& file, const FileState& state) {
    const std::lock_guard lock(mutex_);
    states_.insert_or_assign(file, state);
  }

 private:
  std::mutex mutex_;
  std::map<std::filesystem::path, FileState> states_;
};

}  // namespace

void CheckMesh(const std::filesystem::path& file) {
  static SoundMeshes sound;
  // Of before the reading: what is written meanwhile is another file.
  const std::filesystem::path place = std::filesystem::absolute(file);
  const std::optional<FileState> state = StateOf(place);
  if (state && sound.Has(place, *state)) return;
  ReadMesh(file);
  if (state) sound.Add(place, *state);
}

}  // namespace fourpost
