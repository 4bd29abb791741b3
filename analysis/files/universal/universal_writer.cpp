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

/// What stands in data set 58b up to its record 6: `type` of the function, and the number of bytes of its data. The
/// entity has ten columns; a longer name stands in the description, and in a label of twenty.
std::string Opening(const std::string& name, int type, std::size_t number, const std::string& reference,
                    std::size_t bytes) {
  const auto entity = [](const std::string& text) { return Field(text.size() <= 10 ? text : "", 10); };
  const bool has_reference = !reference.empty();
  return Line("    -1") + Line(Format("%6s%6d%6d%12d%12zu%6d%6d%12d%12d", "58b", 1, 2, 11, bytes, 0, 0, 0, 0)) +
         Line(Field(name, 80)) + Line("NONE") + Line("NONE") + Line("NONE") + Line("NONE") +
         Line(Format("%5d%10zu%5d%10d ", type, number, 0, 0) + entity(name) + Format("%10d%4d ", 0, 0) +
              entity(reference) + Format("%10d%4d", has_reference ? 1 : 0, has_reference ? 3 : 0));
}

std::string Label(const std::string& name) { return name.size() <= 20 ? name : ""; }

std::string DataSet(const RecordingChannel& channel, std::size_t number) {
  const std::size_t samples = channel.values.size();
  const bool has_step = channel.step_s > 0 && channel.times_s.empty();
  if (samples == 0 || (!has_step && channel.times_s.size() != samples))
    throw std::invalid_argument("channel '" + channel.name + "' needs values, and a step or as many times");
  const bool is_even = has_step && IsShort(channel.start_s) && IsShort(channel.step_s);
  const std::string data = DataOf(channel, is_even);
  std::string set = Opening(channel.name, 1, number, "", data.size());
  set += Line(Format("%10d%10zu%10d", 4, samples, is_even ? 1 : 0) + Short(is_even ? channel.start_s : 0) +
              Short(is_even ? channel.step_s : 0) + Short(0));
  set += Axis(17, "time", "s") + Axis(0, Label(channel.name), channel.unit) + Axis(0, "", "") + Axis(0, "", "");
  return set + data + '\n' + Line("    -1");
}

/// Data set 151.
std::string Title(const std::string& title) {
  return Line("    -1") + Line("   151") + Line(Field(title, 80)) + Line("NONE") + Line("fourpost") + Line("") +
         Line("") + Line("fourpost") + Line("") + Line("    -1");
}

std::string DataSet(std::span<const double> frequency_Hz, const std::string& reference,
                    const UniversalResponse& response, std::size_t number) {
  if (response.values.size() != frequency_Hz.size())
    throw std::invalid_argument("response '" + response.name + "' needs a value at each frequency");
  std::string data;
  for (std::size_t k = 0; k < frequency_Hz.size(); ++k) {
    Append(frequency_Hz[k], data);
    Append(response.values[k].real(), data);
    Append(response.values[k].imag(), data);
  }
  // Complex, double precision, at uneven frequencies.
  return Opening(response.name, 4, number, reference, data.size()) +
         Line(Format("%10d%10zu%10d", 6, frequency_Hz.size(), 0) + Short(0) + Short(0) + Short(0)) +
         Axis(18, "frequency", "Hz") + Axis(0, Label(response.name), response.unit) + Axis(8, Label(reference), "m") +
         Axis(0, "", "") + data + '\n' + Line("    -1");
}

}  // namespace

std::string UniversalBytes(std::span<const double> frequency_Hz, const std::string& reference,
                           std::span<const UniversalResponse> responses) {
  if (responses.empty()) throw std::invalid_argument("frequency responses to be written need channels");
  std::string bytes = Title("frequency responses");
  for (std::size_t i = 0; i < responses.size(); ++i) bytes += DataSet(frequency_Hz, reference, responses[i], i + 1);
  return bytes;
}

std::string UniversalBytes(const Recording& recording) {
  if (recording.channels.empty()) throw std::invalid_argument("a recording to be written needs channels");
  std::string bytes = Title(recording.description.substr(0, recording.description.find('\n')));
  for (std::size_t i = 0; i < recording.channels.size(); ++i) bytes += DataSet(recording.channels[i], i + 1);
  return bytes;
}

}  // namespace fourpost
