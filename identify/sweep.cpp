#include "identify/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/frequency_grid.h"
#include "analysis/nearest.h"
#include "analysis/number.h"
#include "analysis/units.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/post_stroke.h"

namespace fourpost {
namespace {

template <typename Part>
std::vector<std::string> NamesOf(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

class SweepReader {
 public:
  SweepReader(const SweepText& text, const Vehicle& vehicle, Diagnostics& diagnostics)
      : text_(text), vehicle_(vehicle), diagnostics_(diagnostics) {}

  std::optional<SweepRequest> Read() {
    const std::optional<std::vector<double>> frequencies =
        ParseFrequencies(text_.frequencies, "--frequencies", diagnostics_);
    SweepRequest request{.amplitude = Amplitude(), .falling = text_.falling, .channels = Channels()};
    for (const std::string& mode : text_.modes) AddSweep(mode, request);
    if (faulty_ || !frequencies) return std::nullopt;
    for (Sweep& sweep : request.sweeps) Fill(*frequencies, request, sweep.excitation);
    for (const Sweep& sweep : request.sweeps) CheckStrokes(sweep);
    WarnAbove(frequencies->back());
    if (faulty_) return std::nullopt;
    return request;
  }

 private:
  void Fault(const char* option, const std::string& message) {
    faulty_ = true;
    diagnostics_.Error(option, 0, message);
  }

  double Limit(const char* option, const std::string& text, const Dimension& dimension, const char* example) {
    if (text.empty()) return std::numeric_limits<double>::infinity();
    const std::optional<Quantity> quantity = ParseQuantity(text);
    if (!quantity || quantity->unit.dimension != dimension)
      Fault(option,
            "'" + text + "' is no " + DimensionName(dimension) + ": write a number with its unit, such as " + example);
    else if (!(quantity->si > 0)) Fault(option, "'" + text + "' must be above zero");
    else return quantity->si;
    return 1;
  }

  AmplitudeLaw Amplitude() {
    if (text_.amplitude.empty() && text_.velocity.empty() && text_.acceleration.empty()) return kUsualAmplitude;
    return {.displacement_m = Limit("--amplitude", text_.amplitude, kLength, "5 mm"),
            .velocity_mps = Limit("--velocity", text_.velocity, kVelocity, "0.15 m/s"),
            .acceleration_mps2 = Limit("--acceleration", text_.acceleration, kAcceleration, "6 m/s^2")};
  }

  std::vector<std::size_t> Channels() {
    const std::vector<std::string> names = NamesOf(vehicle_.sensors);
    if (names.empty()) Fault("--channel", "the vehicle has no fp:sensor, so nothing tells how it answers: give it one");
    std::vector<std::size_t> channels;
    if (text_.channels.empty())
      for (std::size_t i = 0; i < names.size(); ++i) channels.push_back(i);
    for (const std::string& name : text_.channels) {
      const auto found = std::find(names.begin(), names.end(), name);
      if (found != names.end()) channels.push_back(static_cast<std::size_t>(found - names.begin()));
      else if (!names.empty()) Fault("--channel", "the vehicle has no sensor '" + name + "'" + DidYouMean(name, names));
    }
    return channels;
  }

  void AddSweep(const std::string& mode, SweepRequest& request) {
    const auto same = [&](const Sweep& sweep) { return sweep.mode == mode; };
    if (std::any_of(request.sweeps.begin(), request.sweeps.end(), same)) return;
    if (vehicle_.posts.empty()) {
      Fault("--mode", "the vehicle has no fp:post to move");
      return;
    }
    request.sweeps.push_back({.mode = mode, .excitation = {.shape = Shape(mode)}});
  }

  std::vector<double> Shape(const std::string& mode) {
    if (mode.find('=') != std::string::npos) return Shares(mode);
    try {
      return PostPattern(vehicle_, mode);
    } catch (const std::invalid_argument& refusal) {
      Fault("--mode",
            std::string(refusal.what()) +
                (IsPattern(mode) ? "" : "; or tell the share of each post, as " + vehicle_.posts.front().name + "=1"));
      return {};
    }
  }

  static bool IsPattern(std::string_view mode) {
    return std::find(kPostPatterns.begin(), kPostPatterns.end(), mode) != kPostPatterns.end();
  }

  /// "FL=1,FR=-1"
  std::vector<double> Shares(const std::string& mode) {
    std::vector<double> shape(vehicle_.posts.size(), 0.0);
    for (std::size_t begin = 0; begin <= mode.size();) {
      const std::size_t end = std::min(mode.find(',', begin), mode.size());
      AddShare(mode.substr(begin, end - begin), shape);
      begin = end + 1;
    }
    const auto is_reference = [](double share) { return std::abs(share) == 1; };
    if (!faulty_ && std::none_of(shape.begin(), shape.end(), is_reference))
      Fault("--mode", "'" + mode + "': one post is the reference, whose share is 1 or -1");
    return shape;
  }

  void AddShare(const std::string& part, std::vector<double>& shape) {
    const std::vector<std::string> posts = NamesOf(vehicle_.posts);
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = part.substr(0, equals);
    const std::optional<double> share = equals < part.size() ? ParseNumber(part.substr(equals + 1)) : std::nullopt;
    const auto post = std::find(posts.begin(), posts.end(), name);
    if (post == posts.end()) Fault("--mode", "the vehicle has no post '" + name + "'" + DidYouMean(name, posts));
    else if (!share) Fault("--mode", "'" + part + "' is no share of a post: write " + name + "=1, or -1 against it");
    else shape[static_cast<std::size_t>(post - posts.begin())] = *share;
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
    Diagnostics found;
    CheckStroke(vehicle_, excursion, sweep.mode + " at " + FormatNumber(sweep.excitation.frequency_Hz[at]) + " Hz",
                found);
    for (const Diagnostic& item : found.items()) diagnostics_.Error(item.file, item.line, item.message);
    faulty_ = faulty_ || found.HasErrors();
  }

  void WarnAbove(double highest_Hz) {
    // The last of a range is computed.
    constexpr double kSlack = 1e-9;
    if (highest_Hz <= kHighestRigid_Hz * (1 + kSlack)) return;
    diagnostics_.Warning(
        "--frequencies", 0,
        "above " + FormatNumber(kHighestRigid_Hz) +
            " Hz the bodies of a road vehicle bend, and rigid bodies do not: take the answers up there "
            "for those of the model, not of a car");
  }

  const SweepText& text_;
  const Vehicle& vehicle_;
  Diagnostics& diagnostics_;
  bool faulty_ = false;
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
  return SweepReader(text, vehicle, diagnostics).Read();
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
