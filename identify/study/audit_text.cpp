#include "identify/study/audit_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "analysis/files/json_text.h"
#include "analysis/text/short_number.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;
using Kind = RigFault::Kind;

constexpr double kInMilli = 1e3;
constexpr double kInPercent = 100;

const char* KindName(Kind kind) {
  switch (kind) {
    case Kind::kScale: return "scale";
    case Kind::kDelay: return "delay";
    case Kind::kPlace: return "position";
    case Kind::kWheelpan: return "wheelpan";
    case Kind::kExchange: return "exchange";
    case Kind::kOther: return "other channel";
  }
  return "";
}

Json FaultJson(const RigFault& fault, double size) {
  Json json = {{"kind", KindName(fault.kind)}, {"of", fault.name}, {"size", CountedSize(fault, size)}};
  json["axis"] = fault.kind == Kind::kPlace ? Json(AxisName(fault.axis)) : Json(nullptr);
  return json;
}

/// Sizes from which on faults of one thing are seen.
struct Seen {
  std::string scale;
  std::string delay;
  std::string place;
  std::string wheelpan;
};

std::string SeenText(const Resolution& resolution, double unit, int digits) {
  return std::isfinite(resolution.sd) ? ShortNumber(unit * resolution.Seen(), digits) : "-";
}

/// Of shares; nothing of a channel that no other checks: what it leaves over is of rounding.
std::string ShareText(double share, double expected) {
  constexpr double kUnchecked = 0.01;
  return share < kUnchecked * expected ? "-" : ShortNumber(kInPercent * share, 2);
}

/// The fault of a clock.
constexpr const char* kClock = "frequency";

/// The clock's scale is that of the frequencies.
std::string ShownName(const std::string& name) { return name == kClock ? "(all frequencies)" : name; }

}  // namespace

const char* AxisName(int axis) {
  constexpr std::array kNames = {"x", "y", "z"};
  return kNames[static_cast<std::size_t>(axis)];
}

double CountedSize(const RigFault& fault, double size) {
  return fault.kind == Kind::kScale ? 1 / (1 + size) - 1 : size;
}

std::string AuditText(const Audit& audit) {
  if (!audit.is_redundant)
    return "audit of the rig: no channel can be checked by others, as they measure no more motions than the car has; "
           "add sensors of a motion that others measure too, such as displacement and acceleration of one point, or "
           "load cells under all tyres\n";
  std::map<std::string, Seen> seen;
  std::vector<std::string> order;
  std::string open;
  for (const Resolution& resolution : audit.resolutions) {
    const RigFault& fault = resolution.fault;
    if (!seen.count(fault.name)) order.push_back(fault.name);
    Seen& entry = seen[fault.name];
    if (fault.kind == Kind::kScale) entry.scale = SeenText(resolution, kInPercent, 2);
    if (fault.kind == Kind::kDelay) entry.delay = SeenText(resolution, kInMilli, 2);
    if (fault.kind == Kind::kPlace && fault.axis == 0) entry.place = SeenText(resolution, kInPercent, 2);
    if (fault.kind == Kind::kWheelpan) entry.wheelpan = SeenText(resolution, 1, 2);
    if (!std::isfinite(resolution.sd) && fault.kind != Kind::kPlace)
      open += std::string(open.empty() ? "" : ", ") + KindName(fault.kind) + " of " + fault.name;
  }
  std::sort(order.begin(), order.end());
  TextTable table({"channel", "left over [%]", "expected [%]", "scale seen from [%]", "delay from [ms]",
                   "position (x) from [cm]", "wheelpan from [kg]"});
  for (const std::string& name : order) {
    // Without load cells there is no word of it; a row of dashes says nothing.
    if (name == kClock && seen[name].scale == "-") continue;
    double rest = 0;
    double expected = 0;
    int count = 0;
    for (const ChannelRest& channel : audit.channels)
      if (channel.name == name) {
        rest = std::max(rest, channel.share);
        expected = std::max(expected, channel.expected);
        ++count;
      }
    table.Add({ShownName(name), count > 0 ? ShareText(rest, expected) : "",
               count > 0 ? ShortNumber(kInPercent * expected, 2) : "", seen[name].scale, seen[name].delay,
               seen[name].place, seen[name].wheelpan});
  }
  return "audit of the rig, without a fit: what channels leave over of the motion and the forces that all agree on\n" +
         table.Format() + "left over: root mean square, of the worst recording; misfit " +
         ShortNumber(audit.misfit, 2) +
         (audit.is_noise_known
              ? " (about 1 or less is expected)\n"
              : " (1 % of each channel without a stated 'noise' is expected; state it to see more)\n") +
         (seen.count(kClock) > 0 && !seen[kClock].scale.empty() && seen[kClock].scale != "-"
              ? ShownName(kClock) + ": a clock of the rig that runs fast or slow\n"
              : "") +
         (open.empty() ? "" : "not checked, as no other channel depends on it: " + open + '\n') +
         "not checked: amplitudes of posts where responses are relative to them, and mean offsets\n";
}

nlohmann::ordered_json AuditJson(const Audit& audit) {
  Json channels = Json::array();
  for (const ChannelRest& channel : audit.channels)
    channels.push_back({{"name", channel.name},
                        {"recording", channel.run},
                        {"left_over", NumberOrNull(channel.share)},
                        {"expected", NumberOrNull(channel.expected)}});
  Json suspicions = Json::array();
  for (const Suspicion& suspicion : audit.suspicions) {
    Json json = FaultJson(suspicion.fault, suspicion.size);
    json["sd"] = suspicion.sd;
    json["score"] = suspicion.score;
    json["next_score"] = suspicion.next_score;
    json["rivals"] = Json::array();
    for (const Suspicion::Rival& rival : suspicion.rivals) {
      json["rivals"].push_back(FaultJson(rival.fault, rival.size));
      json["rivals"].back()["score"] = rival.score;
    }
    suspicions.push_back(std::move(json));
  }
  Json resolutions = Json::array();
  for (const Resolution& resolution : audit.resolutions) {
    Json json = FaultJson(resolution.fault, 0);
    json.erase("size");
    json["allowed_sd"] = resolution.fault.allowed;
    json["seen_from"] = NumberOrNull(resolution.Seen());
    resolutions.push_back(std::move(json));
  }
  return {{"misfit", NumberOrNull(audit.misfit)},
          {"channels", channels},
          {"suspicions", suspicions},
          {"resolutions", resolutions}};
}

}  // namespace fourpost
