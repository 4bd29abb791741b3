#include "vehicles/requests/channel_json.h"

#include <cmath>

#include "analysis/signals/decibel.h"

namespace fourpost {

using Json = nlohmann::ordered_json;

Json ChannelJson(const ChannelResponse& channel) {
  Json gain = Json::array();
  Json phase = Json::array();
  for (const std::complex<double>& value : channel.response) {
    gain.push_back(std::abs(value));
    phase.push_back(DegreesFromRadians(std::arg(value)));
  }
  return {{"name", channel.name}, {"unit", channel.unit}, {"gain", gain},
          {"phase_deg", phase},   {"mean", channel.mean}, {"second_harmonic", channel.second_harmonic}};
}

Json FindingsJson(const Diagnostics& findings) {
  Json list = Json::array();
  for (const Diagnostic& item : findings.items())
    list.push_back({{"id", item.id},
                    {"file", Name(item.place)},
                    {"line", item.place.line == 0 ? Json() : Json(item.place.line)},
                    {"severity", item.severity == Severity::kError ? "error" : "warning"},
                    {"text", item.message}});
  return list;
}

}  // namespace fourpost
