#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// How well a model follows a channel.
enum class Follows { kWell, kRoughly, kNot };

/// A channel of a result.json, by its misfit.
struct JudgedChannel {
  std::string name;
  /// Of a channel over time.
  std::string recording;
  std::string numbers;
  Follows follows = Follows::kWell;
  /// The misfit over that of a channel which is followed well.
  double score = 0;
  bool is_history = false;
};

/// Best first. Where all have one name, such as a damper's force, their recordings tell them apart; where all are of
/// one recording, their names do.
std::vector<JudgedChannel> JudgeChannels(const std::vector<nlohmann::json>& channels);

/// What a channel that is followed stays within, of the kinds of channels there are.
std::string ShownLimits(const std::vector<JudgedChannel>& channels);

}  // namespace fourpost
