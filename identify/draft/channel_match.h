#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/units.h"
#include "identify/study_file/channel_source.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A channel of a recording that something of the vehicle is to be matched to.
struct OfferedChannel {
  std::string name;
  Dimension dimension;
};

/// What a sensor, a post or a tyre of the vehicle is measured by.
struct ChannelMatch {
  /// By its kind: named like another whose place alone differs, which was matched to such a one. By its place: of a
  /// post, a displacement whose name says no more. As the last: no other channel and nothing else of its dimension was
  /// left, and it moves about so.
  enum class By { kName, kLikeName, kPlace, kKind, kMotion, kLast };

  std::string name;
  ChannelSource source;
  By by = By::kName;
  /// Of the channel's responses and those of the vehicle as its file has it, -1 to 1; empty where neither is known.
  std::optional<double> correlation;
  /// Another that fits nearly as well; empty: none.
  std::string rival = {};
  /// Beside others of its kind in the recording, see kMotionlessShare: its correlation is that of rounding.
  bool is_motionless = false;

  /// False of what a user should look at.
  bool IsSure() const;
};

/// What is to be matched.
struct SoughtChannel {
  std::string name;
  Dimension dimension;
  /// Several channels are added up, as loads of two tyres; else their mean is taken.
  bool is_sum = false;
  /// A channel whose name means another part of the vehicle is none of a post, wherever it is. By motion they
  /// cannot be distinguished: posts have no responses to compare.
  bool is_post = false;
};

/// Of a sought channel and an offered one; nothing where it is not known.
using CorrelationOf = std::function<std::optional<double>(const std::string& sought, const std::string& offered)>;

/// Matches by equal names, then by what names say of part and place, then by motion alone; each channel once. Last come
/// channels of which others of their kind were matched, such as the rear one beside the front one. In a
/// vehicle of one side, `has_sides` false, left and right channels are taken together. The sign is that of the
/// correlation. What has no match is not in the list.
std::vector<ChannelMatch> MatchChannels(const std::vector<SoughtChannel>& sought,
                                        const std::vector<OfferedChannel>& offered, bool has_sides,
                                        const CorrelationOf& correlation = {});

/// Sensors, posts (displacements) and tyres (loads) as they are sought.
std::vector<SoughtChannel> SoughtSensors(const Vehicle& vehicle);
std::vector<SoughtChannel> SoughtPosts(const Vehicle& vehicle);
std::vector<SoughtChannel> SoughtTyres(const Vehicle& vehicle);
/// Tensions.
std::vector<SoughtChannel> SoughtActuators(const Vehicle& vehicle);

/// Whether posts stand left and right.
bool HasSides(const Vehicle& vehicle);

}  // namespace fourpost
