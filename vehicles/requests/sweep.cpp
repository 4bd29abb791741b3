#include "vehicles/requests/sweep.h"

#include <algorithm>
#include <cmath>

#include "analysis/signals/frequency_grid.h"
#include "analysis/text/number.h"
#include "vehicles/requests/chosen_sensors.h"
#include "vehicles/requests/findings.h"
#include "vehicles/requests/post_shape.h"
#include "vehicles/requests/rigid_range.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost {
namespace {

class SweepReader {
 public:
  SweepReader(const SweepText& text, const Vehicle& vehicle) : text_(text), vehicle_(vehicle) {}

  const Diagnostics& found() const { return found_; }

  std::optional<SweepRequest> Read() {
    const std::optional<std::vector<double>> frequencies = ParseFrequencies(text_.frequencies, "--frequencies", found_);
    SweepRequest request{
        .amplitude = ReadLimits(text_.limits, found_), .falling = text_.falling, .channels = Channels()};
    stroke_m_ = ReadStroke(text_.stroke, found_);
    for (const std::string& mode : text_.modes) AddSweep(mode, request);
    if (found_.HasErrors() || !frequencies) return std::nullopt;
    for (Sweep& sweep : request.sweeps) Fill(*frequencies, request, sweep.excitation);
    for (const Sweep& sweep : request.sweeps) CheckStrokes(sweep);
    WarnAboveRigid(frequencies->back(), "--frequencies", found_);
    WarnBeyondUsual(request.amplitude, *frequencies, found_);
    if (found_.HasErrors()) return std::nullopt;
    return request;
  }

 private:
  std::vector<std::size_t> Channels() {
    if (vehicle_.sensors.empty()) found_.Report(kSensorNone, {vehicle_.file});
    return ChosenSensors(text_.channels, vehicle_, found_);
  }

  void AddSweep(const std::string& mode, SweepRequest& request) {
    const auto same = [&](const Sweep& sweep) { return sweep.mode == mode; };
    if (std::any_of(request.sweeps.begin(), request.sweeps.end(), same)) return;
    if (vehicle_.posts.empty()) found_.Report(kPostNone, {vehicle_.file});
    else request.sweeps.push_back({.mode = mode, .excitation = {.shape = ReadPostShape(mode, vehicle_, found_)}});
  }

  void Fill(const std::vector<double>& frequencies, const SweepRequest& request, Excitation& excitation) const {
    excitation.frequency_Hz = frequencies;
    if (request.falling) std::reverse(excitation.frequency_Hz.begin(), excitation.frequency_Hz.end());
    for (const double frequency : excitation.frequency_Hz)
      excitation.amplitude_m.push_back(request.amplitude.At(frequency));
  }

  void CheckStrokes(const Sweep& sweep) {
    const auto largest = std::max_element(sweep.excitation.amplitude_m.begin(), sweep.excitation.amplitude_m.end());
    const auto at = static_cast<std::size_t>(largest - sweep.excitation.amplitude_m.begin());
    std::vector<double> excursion;
    for (const double share : sweep.excitation.shape) excursion.push_back(std::abs(share) * *largest);
    CheckStroke(vehicle_, excursion, sweep.mode + " at " + FormatNumber(sweep.excitation.frequency_Hz[at]) + " Hz",
                found_, stroke_m_);
  }

  const SweepText& text_;
  const Vehicle& vehicle_;
  Diagnostics found_;
  double stroke_m_ = 0;
};

template <typename Value>
void ReverseAll(std::vector<Value>& values) {
  std::reverse(values.begin(), values.end());
}

void Reverse(FrequencyResponse& response) {
  ReverseAll(response.frequency_Hz);
  ReverseAll(response.amplitude_m);
  for (ChannelResponse& channel : response.channels) {
    ReverseAll(channel.response);
    ReverseAll(channel.mean);
    ReverseAll(channel.second_harmonic);
  }
}

void Keep(const std::vector<std::size_t>& channels, FrequencyResponse& response) {
  std::vector<ChannelResponse> kept;
  for (const std::size_t i : channels) kept.push_back(response.channels[i]);
  response.channels = std::move(kept);
}

}  // namespace

std::optional<SweepRequest> ReadSweep(const SweepText& text, const Vehicle& vehicle, Diagnostics& diagnostics) {
  SweepReader reader(text, vehicle);
  std::optional<SweepRequest> request = reader.Read();
  for (const Diagnostic& item : reader.found().items()) {
    diagnostics.Add(item);
  }
  return request;
}

SweptResponse Sorted(const Sweep& sweep, SteadyResponse answer, const std::vector<std::size_t>& channels) {
  SweptResponse out{.mode = sweep.mode, .excitation = sweep.excitation, .answer = std::move(answer)};
  Keep(channels, out.answer.response);
  if (out.answer.linearised) Keep(channels, *out.answer.linearised);
  if (std::is_sorted(sweep.excitation.frequency_Hz.begin(), sweep.excitation.frequency_Hz.end())) return out;
  ReverseAll(out.excitation.frequency_Hz);
  ReverseAll(out.excitation.amplitude_m);
  ReverseAll(out.answer.engine_at);
  Reverse(out.answer.response);
  if (out.answer.linearised) Reverse(*out.answer.linearised);
  return out;
}

}  // namespace fourpost
