#include "analysis/signals/frequency_grid.h"

#include <algorithm>
#include <cmath>

#include "analysis/signals/findings.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

constexpr double kMostFrequencies = 10000;

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& option, Diagnostics& diagnostics)
      : text_(text), option_(option), diagnostics_(diagnostics) {}

  std::optional<std::vector<double>> Read() {
    std::vector<double> frequencies = text_.find(':') == std::string_view::npos ? List() : Range();
    if (faulty_) return std::nullopt;
    return frequencies;
  }

 private:
  void Fault(const Finding& kind, const std::vector<std::string>& words) {
    faulty_ = true;
    diagnostics_.Report(kind, Place::Option(option_), words);
  }

  double Frequency(std::string_view part) {
    const std::optional<Quantity> quantity = ParseQuantity(part);
    // Also rad/s has the dimension of a frequency.
    if (!quantity || quantity->unit_text != "Hz") Fault(kFrequencyUnreadable, {std::string(part)});
    else if (!(quantity->si > 0)) Fault(kFrequencyNotPositive, {std::string(part)});
    else return quantity->si;
    return 1;
  }

  std::vector<double> List() {
    std::vector<double> frequencies;
    for (const std::string_view part : Split(text_, ',')) frequencies.push_back(Frequency(part));
    std::sort(frequencies.begin(), frequencies.end());
    const auto twice = std::adjacent_find(frequencies.begin(), frequencies.end());
    if (!faulty_ && twice != frequencies.end()) Fault(kFrequencyTwice, {FormatNumber(*twice) + " Hz"});
    return frequencies;
  }

  std::vector<double> Range() {
    const std::vector<std::string_view> parts = Split(text_, ':');
    if (parts.size() != 3) {
      Fault(kFrequencyRangeMalformed, {std::string(text_)});
      return {};
    }
    const double first = Frequency(parts[0]);
    const double last = Frequency(parts[1]);
    if (!faulty_ && !(first < last)) Fault(kFrequencyRangeFalling, {std::string(text_)});
    if (const std::optional<double> count = ParseNumber(parts[2])) return Steps(first, last, *count);
    return EverySo(first, last, Frequency(parts[2]));
  }

  std::vector<double> Steps(double first, double last, double count) {
    if (!(count >= 2 && count <= kMostFrequencies && count == std::floor(count)))
      Fault(kFrequencyCount, {FormatNumber(count), FormatNumber(kMostFrequencies)});
    if (faulty_) return {};
    std::vector<double> frequencies;
    for (double i = 0; i < count; ++i) frequencies.push_back(first * std::pow(last / first, i / (count - 1)));
    frequencies.back() = last;
    return frequencies;
  }

  std::vector<double> EverySo(double first, double last, double step) {
    // Rounding of the step must not lose the last.
    constexpr double kSlack = 1e-9;
    const double steps = std::floor((last - first) / step + kSlack);
    if (!faulty_ && !(steps >= 1 && steps < kMostFrequencies))
      Fault(kFrequencyStep, {FormatNumber(step) + " Hz", FormatNumber(steps + 1), FormatNumber(kMostFrequencies)});
    if (faulty_) return {};
    std::vector<double> frequencies;
    for (double i = 0; i <= steps; ++i) frequencies.push_back(std::min(first + i * step, last));
    return frequencies;
  }

  std::string_view text_;
  const std::string& option_;
  Diagnostics& diagnostics_;
  bool faulty_ = false;
};

}  // namespace

std::optional<std::vector<double>> ParseFrequencies(std::string_view text, const std::string& option,
                                                    Diagnostics& diagnostics) {
  return Reader(text, option, diagnostics).Read();
}

}  // namespace fourpost
