#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// A number that a peer can be given.
struct PeerSetting {
  std::string name;
  double value = 0;
  /// Legal values, both included.
  double lower = 0;
  double upper = 0;
};

using PeerSettings = std::vector<PeerSetting>;

/// Throws std::logic_error for a name that is not there.
inline double ValueOf(const PeerSettings& settings, std::string_view name) {
  for (const PeerSetting& setting : settings)
    if (setting.name == name) return setting.value;
  throw std::logic_error("a peer has no setting '" + std::string(name) + "'");
}

inline unsigned CountOf(const PeerSettings& settings, std::string_view name) {
  return static_cast<unsigned>(ValueOf(settings, name));
}

}  // namespace fourpost
