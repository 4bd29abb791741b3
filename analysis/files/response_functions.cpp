#include "analysis/files/response_functions.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <set>

#include "analysis/files/findings.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/signals/decibel.h"

namespace fourpost {
namespace {

/// How often the reference or response is a derivative of a displacement.
std::optional<int> Derivatives(const Dimension& dimension) {
  if (dimension == kLength) return 0;
  if (dimension == kVelocity) return 1;
  if (dimension == kAcceleration) return 2;
  return std::nullopt;
}

/// Of an axis, as MeasuredUnit of a channel; by its quantity where it states none.
std::optional<Unit> UnitOf(const UniversalAxis& axis) {
  std::optional<Unit> unit = axis.unit.empty() ? std::nullopt : ParseRecordedUnit(axis.unit);
  if (unit) unit->si *= axis.factor;
  return unit;
}

bool IsAngular(const Unit& unit, const std::string& text) {
  return unit.dimension == kFrequency &&
         (text.starts_with("rad") || text.starts_with("deg") || text.starts_with("\xC2\xB0"));
}

std::vector<double> FrequenciesOf(const UniversalFunction& function, const UniversalNumbers& numbers) {
  if (!function.is_even) return numbers.abscissa;
  std::vector<double> frequencies;
  for (std::size_t k = 0; k < numbers.values.size(); ++k)
    frequencies.push_back(function.start + function.step * static_cast<double>(k));
  return frequencies;
}

class SteppedSine {
 public:
  SteppedSine(const UniversalFile& file, std::string name, Diagnostics& diagnostics)
      : file_(file), name_(std::move(name)), diagnostics_(diagnostics) {}

  std::optional<std::vector<MatVector>> Read() {
    CheckReferences();
    for (const UniversalFunction& function : file_.responses()) Add(function);
    if (good_ && gain_.values.empty()) Fault(kResponsesNone, 0);
    if (!good_) return std::nullopt;
    return std::vector<MatVector>{std::move(frequency_), std::move(channel_), std::move(unit_), std::move(gain_),
                                  std::move(phase_)};
  }

 private:
  void Fault(const Finding& kind, int line, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(kind, {name_, line}, words);
    good_ = false;
  }

  void CheckReferences() {
    std::set<std::string> points;
    for (const UniversalFunction& function : file_.responses())
      points.insert(function.reference.entity + " " + function.reference.Text());
    if (points.size() < 2) return;
    std::string list;
    for (const std::string& point : points) list += (list.empty() ? "" : ", ") + point;
    Fault(kResponsesOfSeveralPoints, 0, {list});
  }

  void Add(const UniversalFunction& function) {
    const std::string channel = UniqueName(function);
    const std::optional<Unit> response = UnitOf(function.ordinate);
    const std::optional<Unit> reference = UnitOf(function.denominator);
    const std::optional<int> to = reference ? Derivatives(reference->dimension) : std::nullopt;
    if (!to)
      return Fault(kResponseReference, function.line, {channel, function.denominator.label, function.denominator.unit});
    const bool is_acceleration = response && response->dimension == kAcceleration;
    const bool is_read = response && (is_acceleration || response->dimension == kLength ||
                                      response->dimension == kForce || IsAngular(*response, function.ordinate.unit));
    if (!is_read) return diagnostics_.Report(kResponseUnit, {name_, function.line}, {channel, function.ordinate.unit});
    const UniversalNumbers numbers = file_.Numbers(function);
    const std::vector<double> frequencies = FrequenciesOf(function, numbers);
    if (frequencies_.empty()) frequencies_ = frequencies;
    if (frequencies != frequencies_) return Fault(kResponsesDiffer, function.line, {channel, channel_.texts.front()});
    const std::string unit = response->dimension == kFrequency ? "rad/s" : SiUnit(response->dimension);
    const int derivatives = *to - (is_acceleration ? 2 : 0);
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      if (!(frequencies[k] > 0)) continue;
      const std::complex<double> speed(0, 2 * std::numbers::pi * frequencies[k]);
      std::complex<double> value = numbers.values[k] * (response->si / reference->si);
      for (int d = 0; d < derivatives; ++d) value *= speed;
      for (int d = 0; d > derivatives; --d) value /= speed;
      AddRow(frequencies[k], channel, unit, value);
    }
  }

  std::string UniqueName(const UniversalFunction& function) {
    std::string name = NameOf(function);
    if (!names_.insert(name).second) names_.insert(name += " " + function.response.Text());
    return name;
  }

  void AddRow(double frequency_Hz, const std::string& channel, const std::string& unit, std::complex<double> value) {
    frequency_.values.push_back(frequency_Hz);
    channel_.texts.push_back(channel);
    unit_.texts.push_back(unit);
    gain_.values.push_back(std::abs(value));
    phase_.values.push_back(DegreesFromRadians(std::arg(value)));
  }

  const UniversalFile& file_;
  std::string name_;
  Diagnostics& diagnostics_;
  std::set<std::string> names_;
  std::vector<double> frequencies_;
  MatVector frequency_{.name = "frequency_Hz"};
  MatVector channel_{.name = "channel"};
  MatVector unit_{.name = "unit"};
  MatVector gain_{.name = "gain"};
  MatVector phase_{.name = "phase_deg"};
  bool good_ = true;
};

}  // namespace

std::optional<std::vector<MatVector>> SteppedSineOf(const UniversalFile& file, const std::string& name,
                                                    Diagnostics& diagnostics) {
  try {
    return SteppedSine(file, name, diagnostics).Read();
  } catch (const RecordingFault& fault) {
    diagnostics.Report(*fault.found().kind, {name, fault.line()}, fault.found().words);
    return std::nullopt;
  }
}

}  // namespace fourpost
