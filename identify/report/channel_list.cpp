#include "identify/report/channel_list.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "analysis/report/html.h"
#include "analysis/text/enumeration.h"
#include "vehicles/description/mirror_partner.h"

namespace fourpost {
namespace {

/// Of left and right the worse one's number.
struct Entry {
  std::string html;
  std::string numbers;
};

/// What the second name has in place of the first one's words: "FR" of "a_body_FL" and "a_body_FR".
std::string WhatDiffers(const std::string& first, const std::string& second) {
  std::size_t same = 0;
  while (same < std::min(first.size(), second.size()) && first[same] == second[same]) ++same;
  while (same > 0 && std::isalnum(static_cast<unsigned char>(second[same - 1])) != 0) --same;
  return second.substr(same);
}

/// The place of its partner among these; their number where there is none.
std::size_t PartnerOf(const std::string& left, const std::vector<const JudgedChannel*>& channels) {
  const std::vector<std::string> partners = MirrorPartners(left);
  const auto found = std::find_if(channels.begin(), channels.end(), [&](const JudgedChannel* channel) {
    return std::find(partners.begin(), partners.end(), channel->name) != partners.end();
  });
  return static_cast<std::size_t>(found - channels.begin());
}

/// `channels`: the worst first.
std::vector<Entry> InPairs(const std::vector<const JudgedChannel*>& channels) {
  std::vector<Entry> entries(channels.size());
  std::vector<bool> is_named(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::size_t right = PartnerOf(channels[i]->name, channels);
    if (right == channels.size() || is_named[i] || is_named[right]) continue;
    is_named[i] = is_named[right] = true;
    // At the place of the worse one.
    entries[std::min(i, right)] = {
        html::Code(channels[i]->name) + " and " + html::Code(WhatDiffers(channels[i]->name, channels[right]->name)),
        channels[std::min(i, right)]->numbers};
  }
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (!is_named[i]) entries[i] = {html::Code(channels[i]->name), channels[i]->numbers};
  std::erase_if(entries, [](const Entry& entry) { return entry.html.empty(); });
  return entries;
}

}  // namespace

std::string ChannelList(const std::vector<JudgedChannel>& channels, Follows follows, bool with_numbers) {
  constexpr std::size_t kMost = 6;
  std::vector<const JudgedChannel*> chosen;
  for (const JudgedChannel& channel : channels)
    if (channel.follows == follows) chosen.insert(chosen.begin(), &channel);
  const std::vector<Entry> entries = InPairs(chosen);
  std::vector<std::string> parts;
  // One alone is as short as its count.
  const std::size_t shown = entries.size() <= kMost + 1 ? entries.size() : kMost;
  for (std::size_t i = 0; i < shown; ++i)
    parts.push_back(entries[i].html + (with_numbers ? " (" + html::Escaped(entries[i].numbers) + ")" : ""));
  if (shown < entries.size()) parts.push_back(std::to_string(entries.size() - shown) + " more");
  return Enumeration(parts);
}

}  // namespace fourpost
