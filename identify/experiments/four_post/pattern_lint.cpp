#include "identify/experiments/four_post/pattern_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;
using Shape = std::vector<double>;

/// Below it accelerations and forces of the Land Rover's recordings are alike to those of its models at their starting
/// values by 0.95 and more, and to those of another pattern by 0.5 at the most.
constexpr double kFollowsBelow_Hz = 1;
constexpr double kRight = 0.8;
constexpr double kClearlyMore = 0.25;
constexpr double kLikeNothing = 0.2;

/// Of one kind of channel at one frequency.
struct Products {
  int channels = 0;
  Complex both;
  double measured = 0;
  double modelled = 0;
};

/// Mean correlation of measurement and model over kinds of channels and frequencies, -1 to 1; nothing where no kind has
/// two channels. Struts are left out: friction holds them at such frequencies.
std::optional<double> Likeness(const MeasuredRun& low, const FrequencyResponse& modelled) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < low.excitation.frequency_Hz.size(); ++i) {
    std::map<std::string, Products> kinds;
    for (const MeasuredChannel& channel : low.channels) {
      const Complex model = modelled.channels[channel.sensor].response[i];
      if (channel.unit == "m" || !std::isfinite(std::abs(model))) continue;
      Products& kind = kinds[channel.unit];
      ++kind.channels;
      kind.both += std::conj(model) * channel.response[i];
      kind.measured += std::norm(channel.response[i]);
      kind.modelled += std::norm(model);
    }
    for (const auto& [unit, kind] : kinds) {
      const double size = std::sqrt(kind.measured * kind.modelled);
      if (kind.channels < 2 || !(size > 0)) continue;
      sum += kind.both.real() / size;
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::optional<Shape> PatternOf(const Vehicle& vehicle, std::string_view pattern) {
  try {
    return PostPattern(vehicle, pattern);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // Posts in a line make no roll.
  }
}

/// What the post at the other end of an axis does: `turned` and `kept` say on which side of two axes each post is.
std::optional<Shape> Swapped(const Shape& stated, const Shape& turned, const Shape& kept) {
  Shape swapped = stated;
  for (std::size_t p = 0; p < stated.size(); ++p) {
    int found = 0;
    for (std::size_t q = 0; q < stated.size(); ++q) {
      if (turned[q] == turned[p] || kept[q] != kept[p]) continue;
      swapped[p] = stated[q];
      ++found;
    }
    if (found != 1) return std::nullopt;
  }
  return swapped;
}

/// Without their opposites.
std::vector<Shape> OtherMotions(const Vehicle& vehicle, const Shape& stated) {
  std::vector<Shape> motions = {stated};
  const auto add = [&](const std::optional<Shape>& shape) {
    if (shape && std::find(motions.begin(), motions.end(), *shape) == motions.end()) motions.push_back(*shape);
  };
  for (const std::string_view pattern : kPostPatterns) add(PatternOf(vehicle, pattern));
  const Shape alike(stated.size(), 1);
  const std::optional<Shape> front = PatternOf(vehicle, "pitch");
  const std::optional<Shape> left = PatternOf(vehicle, "roll");
  if (front) add(Swapped(stated, *front, left.value_or(alike)));
  if (left) add(Swapped(stated, *left, front.value_or(alike)));
  return motions;
}

/// "pitch (front 1, rear -1)"
std::string InWords(const Vehicle& vehicle, const Shape& shape) {
  std::string posts;
  for (std::size_t p = 0; p < shape.size(); ++p)
    posts += (p == 0 ? "" : ", ") + vehicle.posts[p].name + " " + FormatNumber(shape[p]);
  for (const std::string_view pattern : kPostPatterns)
    if (PatternOf(vehicle, pattern) == shape) return std::string(pattern) + " (" + posts + ")";
  return "{" + posts + "}";
}

struct Match {
  Shape shape;
  double likeness = -1;
};

/// Among the motions that are not stated.
Match BestOther(const Vehicle& vehicle, const CondensedModel& model, MeasuredRun low) {
  const Shape stated = low.excitation.shape;
  Match best;
  for (const Shape& shape : OtherMotions(vehicle, stated)) {
    low.excitation.shape = shape;
    const double likeness = Likeness(low, ModelledResponses(model, vehicle.sensors, {low}).front()).value_or(0);
    if (shape != stated && likeness > best.likeness) best = {shape, likeness};
    if (-likeness <= best.likeness) continue;
    // Half a period later.
    best = {shape, -likeness};
    for (double& share : best.shape) share = -share + 0.0;
  }
  return best;
}

}  // namespace

Found PatternDoubt(const Vehicle& vehicle, const CondensedModel& model, const MeasuredRun& run) {
  constexpr double kSlack = 1e-6;
  const MeasuredRun low = InBand({run}, 0, kFollowsBelow_Hz * (1 + kSlack)).front();
  if (low.excitation.frequency_Hz.empty()) return {};
  const std::optional<double> stated = Likeness(low, ModelledResponses(model, vehicle.sensors, {low}).front());
  if (!stated || *stated > kRight) return {};
  const Match other = BestOther(vehicle, model, low);
  const bool is_other = other.likeness > kRight && other.likeness > *stated + kClearlyMore;
  if (!is_other && *stated > kLikeNothing) return {};
  Found doubt{is_other ? &kPostsMoveOtherwise : &kPostsMatchNothing,
              {run.name, InWords(vehicle, run.excitation.shape), FormatNumber(kFollowsBelow_Hz)}};
  if (is_other) doubt.words.insert(doubt.words.end(), {InWords(vehicle, other.shape), ShortNumber(other.likeness, 2)});
  doubt.words.push_back(ShortNumber(*stated, 2));
  return doubt;
}

}  // namespace fourpost
