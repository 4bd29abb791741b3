#include "identify/report/audit_section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using html::Cell;
using html::NumberCell;
using html::TextCell;
using Json = nlohmann::json;
using Rows = std::vector<std::vector<Cell>>;

/// "reads 1.03 times the true value", "comes 2 ms late"
std::string FaultText(const Json& fault) {
  const std::string kind = TextAt(fault, "kind");
  const double size = NumberAt(fault, "size");
  const std::string amount = ShownNumber(std::abs(kind == "delay" ? 1e3 * size : size), 2);
  if (kind == "scale") return "reads " + ShownNumber(1 + size, 4) + " times the true value";
  if (kind == "delay") return "comes " + amount + " ms " + (size > 0 ? "late" : "early");
  if (kind == "position")
    return "sits " + amount + " m further along " + (size > 0 ? "+" : "\u2212") + TextAt(fault, "axis");
  if (kind == "wheelpan")
    return "feels " + amount + " kg " + (size > 0 ? "more" : "less") + " of a wheelpan than stated";
  return kind == "exchange" ? "are exchanged" : "measures something else";
}

/// In standard deviations; a score is the square of a normal variable.
std::string SureText(const Json& fault, const char* key) {
  const double score = NumberAt(fault, key);
  return score > 0 ? ShownNumber(std::sqrt(score), 2) : "\u2013";
}

std::string Suspicions(const Json& audit) {
  Rows rows;
  for (const Json& one : ListAt(audit, "suspicions")) {
    std::string rivals;
    for (const Json& rival : ListAt(one, "rivals"))
      rivals += (rivals.empty() ? "" : "; ") + TextAt(rival, "of") + ' ' + FaultText(rival);
    rows.push_back({TextCell(TextAt(one, "of")), TextCell(FaultText(one)), NumberCell(SureText(one, "score")),
                    NumberCell(SureText(one, "next_score")), TextCell(rivals)});
  }
  if (rows.empty())
    return "<p>No channel is suspected of a wrong sign, unit, scale, delay, position or exchange.</p>\n";
  return "<p>Suspected before the fit:</p>\n" +
         html::Table({"channel", "fault", "sd", "next best, sd", "explains it as well"}, rows);
}

/// A channel of the audit's table.
struct AuditedChannel {
  double left_over = 0;
  double expected = 0;
  std::string recording;
  /// By the kind of the fault; NaN where it would not be seen.
  std::map<std::string, double> seen_from;
};

std::map<std::string, AuditedChannel> Channels(const Json& audit) {
  std::map<std::string, AuditedChannel> channels;
  for (const Json& one : ListAt(audit, "channels")) {
    AuditedChannel& channel = channels[TextAt(one, "name")];
    if (const double left = NumberAt(one, "left_over"); left >= channel.left_over) {
      channel.left_over = left;
      channel.expected = NumberAt(one, "expected");
      channel.recording = TextAt(one, "recording");
    }
  }
  for (const Json& one : ListAt(audit, "resolutions")) {
    const auto found = channels.find(TextAt(one, "of"));
    if (found == channels.end()) continue;
    const std::string axis = TextAt(one, "axis");
    // A position along x stands for all.
    if (axis.empty() || axis == "x") found->second.seen_from[TextAt(one, "kind")] = NumberAt(one, "seen_from");
  }
  return channels;
}

/// The left-over part as a bar, full where it is three times what is expected.
Cell RestCell(const AuditedChannel& channel) {
  constexpr double kFull = 3;
  const double ratio = channel.left_over / channel.expected;
  if (!std::isfinite(ratio)) return TextCell("");
  const auto percent = [](double share) { return ShownDecimals(100 * std::min(1.0, share), 1) + '%'; };
  return {"<span class=\"bar\" title=\"left over, and what is expected\"><i class=\"interval\" style=\"left:0%;width:" +
              percent(ratio / kFull) + "\"></i><i class=\"start\" style=\"left:" + percent(1 / kFull) +
              "\"></i></span>",
          "barcell"};
}

Cell SeenCell(const AuditedChannel& channel, const char* kind, double unit) {
  const auto found = channel.seen_from.find(kind);
  const bool is_seen = found != channel.seen_from.end() && std::isfinite(found->second);
  return NumberCell(is_seen ? ShownNumber(unit * found->second, 2) : "\u2013");
}

}  // namespace

std::string AuditHtml(const Json& result) {
  const Json audit = result.value("audit", Json());
  if (!audit.is_object()) return "";
  const std::map<std::string, AuditedChannel> channels = Channels(audit);
  if (channels.empty()) return "";
  Rows rows;
  for (const auto& [name, channel] : channels)
    rows.push_back({TextCell(name), NumberCell(ShownNumber(100 * channel.left_over, 2)),
                    NumberCell(ShownNumber(100 * channel.expected, 2)), RestCell(channel), TextCell(channel.recording),
                    SeenCell(channel, "scale", 100), SeenCell(channel, "delay", 1e3),
                    SeenCell(channel, "position", 100)});
  return Suspicions(audit) +
         "<p>Without masses, rates or dampers, what each channel leaves over of the motion and forces that all "
         "channels agree on, in its worst recording, and from which size on a fault of it would be seen:</p>\n" +
         html::Table({"channel", "left over [%]", "expected [%]", "", "recording", "scale from [%]", "delay from [ms]",
                      "position from [cm]"},
                     rows) +
         "<p class=\"note\">Misfit " + ShownNumber(NumberAt(audit, "misfit"), 2) +
         "; about 1 or less is expected. Not checked: amplitudes of posts where responses are relative to them, and "
         "mean offsets.</p>\n";
}

}  // namespace fourpost
