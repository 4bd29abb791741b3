#include "analysis/files/universal/universal_writer.h"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// Of 80 columns, as all writers of data set 58b have them.
std::string Line(std::string text) {
  text.resize(80, ' ');
  return text + '\n';
}

/// The first `width` bytes, with NONE where there are none.
std::string Field(const std::string& text, std::size_t width) {
  std::string field = text.empty() ? "NONE" : text.substr(0, width);
  field.resize(width, ' ');
  return field;
}

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string Short(double value) { return Format("%13.5E", value); }

bool IsShort(double value) { return ParseNumber(Short(value).substr(Short(value).find_first_not_of(' '))) == value; }

std::string Axis(int quantity, const std::string& label, const std::string& unit) {
  return Line(Format("%10d%5d%5d%5d ", quantity, 0, 0, 0) + Field(label, 20) + " " + Field(unit, 20));
}

void Append(double number, std::string& bytes) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); }

std::string DataOf(const RecordingChannel& channel, bool is_even) {
  std::string data;
  for (std::size_t k = 0; k < channel.values.size(); ++k) {
    const double even = channel.start_s + channel.step_s * static_cast<double>(k);
    if (!is_even) Append(channel.times_s.empty() ? even : channel.times_s[k], data);
    Append(channel.values[k], data);
  }
  return data;
}

std::string DataSet(const RecordingChannel& channel, std::size_t number) {
  const std::size_t samples = channel.values.size();
  const bool has_step = channel.step_s > 0 && channel.times_s.empty();
  if (samples == 0 || (!has_step && channel.times_s.size() != samples))
    throw std::invalid_argument("channel '" + channel.name + "' needs values, and a step or as many times");
  const bool is_even = has_step && IsShort(channel.start_s) && IsShort(channel.step_s);
  const std::string data = DataOf(channel, is_even);
  std::string set = Line("    -1");
  set += Line(Format("%6s%6d%6d%12d%12zu%6d%6d%12d%12d", "58b", 1, 2, 11, data.size(), 0, 0, 0, 0));
  set += Line(Field(channel.name, 80)) + Line("NONE") + Line("NONE") + Line("NONE") + Line("NONE");
  // The entity has ten columns and a label twenty; a longer name stands in the description alone.
  const std::string entity = channel.name.size() <= 10 ? channel.name : "";
  const std::string label = channel.name.size() <= 20 ? channel.name : "";
  set += Line(Format("%5d%10zu%5d%10d ", 1, number, 0, 0) + Field(entity, 10) + Format("%10d%4d ", 0, 0) +
              Field("", 10) + Format("%10d%4d", 0, 0));
  set += Line(Format("%10d%10zu%10d", 4, samples, is_even ? 1 : 0) + Short(is_even ? channel.start_s : 0) +
              Short(is_even ? channel.step_s : 0) + Short(0));
  set += Axis(17, "time", "s") + Axis(0, label, channel.unit) + Axis(0, "", "") + Axis(0, "", "");
  return set + data + '\n' + Line("    -1");
}

}  // namespace

std::string UniversalBytes(const Recording& recording) {
  if (recording.channels.empty()) throw std::invalid_argument("a recording to be written needs channels");
  const std::string first = recording.description.substr(0, recording.description.find('\n'));
  std::string bytes = Line("    -1") + Line("   151") + Line(Field(first, 80)) + Line("NONE") + Line("fourpost") +
                      Line("") + Line("") + Line("fourpost") + Line("") + Line("    -1");
  for (std::size_t i = 0; i < recording.channels.size(); ++i) bytes += DataSet(recording.channels[i], i + 1);
  return bytes;
}

}  // namespace fourpost
