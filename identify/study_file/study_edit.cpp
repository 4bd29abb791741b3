#include "identify/study_file/study_edit.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include <yaml-cpp/yaml.h>

#include "analysis/files/recorded_unit.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

namespace fs = std::filesystem;

void Visit(const YAML::Node& node, const std::function<void(const YAML::Node&)>& visit) {
  if (node.IsScalar()) visit(node);
  if (node.IsSequence())
    for (const YAML::Node& entry : node) Visit(entry, visit);
  if (node.IsMap())
    for (const auto& entry : node) Visit(entry.second, visit);
}

/// Maps of sensors to channels.
std::vector<YAML::Node> ChannelMaps(const YAML::Node& study) {
  std::vector<YAML::Node> maps;
  if (study["channels"].IsDefined() && study["channels"].IsMap()) maps.push_back(study["channels"]);
  if (study["histories"].IsDefined() && study["histories"].IsSequence())
    for (const YAML::Node& history : study["histories"])
      if (history.IsMap() && history["channels"].IsDefined() && history["channels"].IsMap())
        maps.push_back(history["channels"]);
  return maps;
}

/// Of a scalar as it is written, quotes included.
std::pair<std::size_t, std::size_t> SpanOf(const YAML::Node& scalar, const std::string& text) {
  const auto begin = static_cast<std::size_t>(scalar.Mark().pos);
  const char first = begin < text.size() ? text[begin] : '\0';
  if (first == '"' || first == '\'') return {begin, text.find(first, begin + 1) + 1};
  return {begin, begin + scalar.Scalar().size()};
}

/// Nodes that name one recorded channel each: a scalar, or a map with the key `channel`.
void AddSources(const YAML::Node& node, std::vector<YAML::Node>& sources) {
  if (node.IsScalar() || (node.IsMap() && node["channel"].IsDefined())) return sources.push_back(node);
  if (!node.IsMap()) return;
  for (const char* key : {"mean", "sum"})
    if (node[key].IsDefined() && node[key].IsSequence())
      for (const YAML::Node& entry : node[key]) AddSources(entry, sources);
}

/// A stated correction and another one: delays add up, scales multiply; nothing where one cannot be read.
std::optional<std::string> Together(const std::string& key, const YAML::Node& stated, const std::string& more) {
  if (!stated.IsScalar()) return std::nullopt;
  const std::optional<Quantity> one = ParseQuantity(stated.Scalar());
  const std::optional<Quantity> other = ParseQuantity(more);
  if (!one || !other || !(one->unit.dimension == other->unit.dimension)) return std::nullopt;
  if (key == "delay") return FormatQuantity(AtDigits(one->si + other->si, 6), one->unit_text);
  if (key == "scale") return FormatNumber(AtDigits(one->si * other->si, 6));
  return std::nullopt;
}

}  // namespace

StudyEdit::StudyEdit(std::string text) : text_(std::move(text)) {}

void StudyEdit::Rebase(const std::vector<fs::path>& files, const fs::path& from, const fs::path& to) {
  Visit(YAML::Load(text_), [&](const YAML::Node& node) {
    const fs::path named = (from / node.Scalar()).lexically_normal();
    if (std::find(files.begin(), files.end(), named) == files.end()) return;
    const auto [begin, end] = SpanOf(node, text_);
    const fs::path target = fs::weakly_canonical(fs::absolute(named));
    const fs::path relative = target.lexically_relative(fs::weakly_canonical(fs::absolute(to)));
    changes_[begin] = {end, '"' + (relative.empty() ? target : relative).generic_string() + '"'};
  });
}

void StudyEdit::SetVehicle(const std::string& file) {
  const YAML::Node vehicle = YAML::Load(text_)["vehicle"];
  const auto [begin, end] = SpanOf(vehicle, text_);
  changes_[begin] = {end, file};
  // A key of the study begins a line, and its value goes on in lines that begin with blanks.
  constexpr std::string_view kStart = "start:";
  for (std::size_t line = 0; line < text_.size();) {
    std::size_t next = std::min(text_.find('\n', line), text_.size() - 1) + 1;
    if (text_.compare(line, kStart.size(), kStart) != 0) {
      line = next;
      continue;
    }
    while (next < text_.size() && (text_[next] == ' ' || text_[next] == '#'))
      next = std::min(text_.find('\n', next), text_.size() - 1) + 1;
    changes_[line] = {next, ""};
    return;
  }
}

void StudyEdit::AddFree(const std::vector<std::string>& names) {
  const YAML::Node free = YAML::Load(text_)["free"];
  if (!free.IsDefined() || !free.IsSequence() || free.size() == 0 || names.empty()) return;
  const YAML::Node last = free[free.size() - 1];
  const std::size_t end = SpanOf(last, text_).second;
  std::string added;
  if (free.Style() == YAML::EmitterStyle::Flow) {
    for (const std::string& name : names) added += ", " + name;
  } else {
    // As far in as the entry before.
    const auto begin = static_cast<std::size_t>(last.Mark().pos);
    const std::size_t line = text_.rfind('\n', begin) + 1;
    for (const std::string& name : names) added += '\n' + text_.substr(line, begin - line) + name;
  }
  changes_[end] = {end, added};
}

void StudyEdit::NameDamper(const std::string& name) {
  const YAML::Node bench = YAML::Load(text_)["bench"];
  if (!bench.IsDefined() || !bench.IsMap() || bench.size() == 0 || bench["damper"].IsDefined()) return;
  const auto begin = static_cast<std::size_t>(bench.begin()->first.Mark().pos);
  const std::size_t line = text_.rfind('\n', begin) + 1;
  const std::string next = bench.Style() == YAML::EmitterStyle::Flow ? ", " : '\n' + std::string(begin - line, ' ');
  changes_[begin] = {begin, "damper: \"" + name + '"' + next};
}

bool StudyEdit::CorrectChannels(const std::vector<std::string>& sensors, const std::string& key,
                                const std::string& value) {
  const YAML::Node study = YAML::Load(text_);
  std::map<std::size_t, Change> changes;
  for (const YAML::Node& map : ChannelMaps(study))
    for (const std::string& sensor : sensors) {
      if (!map[sensor].IsDefined()) continue;
      std::vector<YAML::Node> sources;
      AddSources(map[sensor], sources);
      for (const YAML::Node& source : sources) {
        if (source.IsScalar()) {
          const auto [begin, end] = SpanOf(source, text_);
          changes[begin] = {end, "{channel: " + text_.substr(begin, end - begin) + ", " + key + ": " + value + "}"};
          continue;
        }
        if (source[key].IsDefined()) {
          const std::optional<std::string> both = Together(key, source[key], value);
          if (!both) return false;
          const auto [begin, end] = SpanOf(source[key], text_);
          changes[begin] = {end, *both};
          continue;
        }
        const std::size_t end = SpanOf(source["channel"], text_).second;
        const bool is_flow = source.Style() == YAML::EmitterStyle::Flow;
        const std::string between =
            is_flow ? ", " : "\n" + std::string(static_cast<std::size_t>(std::max(0, source.Mark().column)), ' ');
        changes[end] = {end, between + key + ": " + value};
      }
    }
  if (changes.empty()) return false;
  changes_.merge(changes);
  return true;
}

void StudyEdit::ScaleNoise(const std::vector<std::string>& sensors, double factor) {
  const YAML::Node histories = YAML::Load(text_)["histories"];
  if (!histories.IsDefined() || !histories.IsSequence()) return;
  for (const YAML::Node& history : histories)
    for (const std::string& sensor : sensors) {
      if (!history.IsMap() || !history["noise"].IsDefined() || !history["noise"].IsMap()) continue;
      const YAML::Node noise = history["noise"][sensor];
      const auto stated = noise.IsDefined() && noise.IsScalar() ? ParseRecordedQuantity(noise.Scalar()) : std::nullopt;
      if (!stated) continue;
      const auto [begin, end] = SpanOf(noise, text_);
      const double number = AtDigits(factor * stated->si / stated->unit.si, 6);
      changes_[begin] = {end, FormatNumber(number) + (stated->unit_text.empty() ? "" : " " + stated->unit_text)};
    }
}

std::string StudyEdit::Text() const {
  std::string result;
  std::size_t done = 0;
  for (const auto& [begin, change] : changes_) {
    result += text_.substr(done, begin - done) + change.text;
    done = change.end;
  }
  return result + text_.substr(done);
}

std::vector<std::string> MeasuredSensors(const std::string& study_text) {
  std::vector<std::string> names;
  for (const YAML::Node& map : ChannelMaps(YAML::Load(study_text)))
    for (const auto& entry : map)
      if (const auto name = entry.first.as<std::string>(); std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

}  // namespace fourpost
