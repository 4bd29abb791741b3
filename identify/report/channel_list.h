#pragma once

#include <string>
#include <vector>

#include "identify/report/judged_channel.h"

namespace fourpost {

/// The channels that are followed so, as HTML, the worst first: left and right ones together, as "a_body_FL and FR", and
/// the rest counted where they are many. Empty without any.
std::string ChannelList(const std::vector<JudgedChannel>& channels, Follows follows, bool with_numbers);

}  // namespace fourpost
