#include "identify/draft/bench_draft.h"

#include <sstream>

#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

constexpr std::array<const char*, 2> kKeys = {"displacement", "force"};

std::string Indented(const std::string& lines, const std::string& by) {
  std::string text;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) text += by + line + '\n';
  return text;
}

}  // namespace

BenchDraft::Columns BenchDraft::ColumnsOf(const FileReading& reading) {
  SourceChannel force = BenchChannel(reading, kForce);
  if (reading.has_force_reversed) force.factor = -1;
  return {SourceText({.channels = {BenchChannel(reading, kLength)}}),
          SourceText({.channels = {force}}) +
              (reading.has_force_reversed ? "  # look at: it acts along the motion, so its sign is turned" : "")};
}

std::string BenchDraft::LinesOf(const Columns& own, const Columns& others, const std::string& indent) {
  std::string lines;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i] != others[i]) lines += indent + kKeys[i] + ": " + own[i] + '\n';
  return lines;
}

void BenchDraft::Add(const FileReading& reading, const std::string& path, const std::string& times) {
  const Columns own = ColumnsOf(reading);
  if (recordings_.empty()) shared_ = own;
  // Lines of times stand two columns further right than in other lists of recordings.
  const std::string lines = Indented(times, "  ") + LinesOf(own, shared_, "      ");
  recordings_ += lines.empty() ? "    - " + path + '\n' : "    - file: " + path + '\n' + lines;
}

std::string BenchDraft::Text() const {
  if (recordings_.empty()) return "";
  const std::string damper =
      dampers_.size() > 1 ? "  damper: " + YamlText(dampers_.front()) + "  # look at: the first of several\n" : "";
  return "\nbench:\n" + damper + LinesOf(shared_, {kKeys[0], kKeys[1]}, "  ") + "  recordings:\n" + recordings_;
}

}  // namespace fourpost
