#include "identify/study_file/channel_source_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "analysis/text/short_number.h"

namespace fourpost {
namespace {

constexpr int kDigits = 5;

std::string ChannelText(const SourceChannel& channel) {
  std::string keys;
  if (!channel.unit.empty()) keys += ", unit: " + channel.unit;
  if (channel.factor < 0) keys += ", sign: -1";
  if (std::abs(channel.factor) != 1) keys += ", scale: " + ShortNumber(std::abs(channel.factor), kDigits);
  if (channel.delay_s != 0) keys += ", delay: " + ShortNumber(1e3 * channel.delay_s, kDigits) + " ms";
  if (!channel.offset.empty()) keys += ", offset: " + channel.offset;
  if (channel.has_trend) keys += ", trend: remove";
  if (channel.high_pass_Hz) keys += ", high_pass: " + ShortNumber(*channel.high_pass_Hz, kDigits) + " Hz";
  if (channel.integrated_above_Hz) keys += ", integrate: " + ShortNumber(*channel.integrated_above_Hz, kDigits) + " Hz";
  const std::string name = YamlText(channel.name);
  return keys.empty() ? name : "{channel: " + name + keys + "}";
}

}  // namespace

std::string YamlText(const std::string& name) {
  const bool is_word = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
                       name.back() != ' ' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
                         return std::isalnum(c) != 0 || c == '_' || c == ' ' || c == '.' || c == '/' || c == '-';
                       });
  const bool is_path =
      (name.starts_with("../") || name.starts_with("/")) && name.find_first_of(" #:,[]{}\"'") == std::string::npos;
  if (is_word || is_path) return name;
  std::string quoted;
  for (const char c : name) quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return '"' + quoted + '"';
}

std::string SourceText(const ChannelSource& source) {
  const bool is_mean = source.combine == ChannelSource::Combine::kMean;
  if (source.channels.size() == 1 && is_mean) return ChannelText(source.channels.front());
  std::string list;
  for (const SourceChannel& channel : source.channels) list += (list.empty() ? "" : ", ") + ChannelText(channel);
  return std::string(is_mean ? "{mean: [" : "{sum: [") + list + "]}";
}

}  // namespace fourpost
