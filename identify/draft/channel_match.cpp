#include "identify/draft/channel_match.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/text/name_meaning.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

/// One channel, or a left and a right one together.
struct Candidate {
  std::vector<std::string> names;
  NameMeaning meaning;
  Dimension dimension;
};

std::vector<NameMeaning> MeaningsOfAll(const std::vector<SoughtChannel>& sought, bool has_sides) {
  std::vector<std::string> names;
  for (const SoughtChannel& one : sought) names.push_back(one.name);
  return MeaningsOf(names, has_sides);
}

struct Pairing {
  std::size_t sought = 0;
  std::size_t candidate = 0;
  double likeness = 0;
  std::optional<double> correlation;
  double score = 0;
};

/// From where on a name is enough, and motion without a name.
constexpr double kLike = 0.5;
constexpr double kMoved = 0.9;
/// Of scores: what is nearer is a rival.
constexpr double kNear = 0.03;

std::vector<Candidate> CandidatesOf(const std::vector<OfferedChannel>& offered, bool has_sides) {
  std::vector<Candidate> singles;
  std::vector<std::string> names;
  for (const OfferedChannel& channel : offered) names.push_back(channel.name);
  const std::vector<NameMeaning> meanings = MeaningsOf(names, has_sides);
  for (std::size_t i = 0; i < offered.size(); ++i) singles.push_back({{names[i]}, meanings[i], offered[i].dimension});
  if (has_sides) return singles;
  std::vector<Candidate> all;
  std::set<std::string> paired;
  for (const Candidate& left : singles)
    for (const Candidate& right : singles) {
      if (left.meaning.left != 1 || right.meaning.left != -1 || !(left.dimension == right.dimension)) continue;
      if (left.meaning.words != right.meaning.words || left.meaning.front != right.meaning.front) continue;
      Candidate both = {{left.names.front(), right.names.front()}, left.meaning, left.dimension};
      both.meaning.left = 0;
      all.push_back(std::move(both));
      paired.insert({left.names.front(), right.names.front()});
    }
  for (Candidate& single : singles)
    if (!paired.contains(single.names.front())) all.push_back(std::move(single));
  return all;
}

std::optional<double> MeanCorrelation(const std::string& sought, const Candidate& candidate,
                                      const CorrelationOf& correlation) {
  if (!correlation) return std::nullopt;
  double sum = 0;
  for (const std::string& name : candidate.names) {
    const std::optional<double> one = correlation(sought, name);
    if (!one) return std::nullopt;
    sum += *one;
  }
  return sum / static_cast<double>(candidate.names.size());
}

/// Rises with both; an equal name is above all.
double ScoreOf(const Pairing& pairing, bool is_equal) {
  constexpr double kMotion = 0.4;
  return (is_equal ? 2 : pairing.likeness) + kMotion * std::abs(pairing.correlation.value_or(0));
}

/// The channel of a wheel pan moves with the post below.
bool MayBe(const SoughtChannel& sought, const NameMeaning& meaning, const Candidate& candidate) {
  if (!(sought.dimension == candidate.dimension)) return false;
  NameMeaning named = candidate.meaning;
  named.words.erase("tyre");
  return !sought.is_post || !NameOtherParts(meaning, named);
}

std::vector<Pairing> PairingsOf(const std::vector<SoughtChannel>& sought, const std::vector<NameMeaning>& meanings,
                                const std::vector<Candidate>& candidates, const CorrelationOf& correlation) {
  std::vector<Pairing> pairings;
  for (std::size_t s = 0; s < sought.size(); ++s) {
    const NameMeaning& meaning = meanings[s];
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (!MayBe(sought[s], meaning, candidates[c])) continue;
      Pairing pairing{.sought = s, .candidate = c, .likeness = Likeness(meaning, candidates[c].meaning)};
      if (pairing.likeness < 0) continue;
      pairing.correlation = MeanCorrelation(sought[s].name, candidates[c], correlation);
      const bool is_equal = candidates[c].names.size() == 1 && candidates[c].names.front() == sought[s].name;
      if (!is_equal && pairing.likeness < kLike && std::abs(pairing.correlation.value_or(0)) < kMoved) continue;
      pairing.score = ScoreOf(pairing, is_equal);
      pairings.push_back(pairing);
    }
  }
  std::stable_sort(pairings.begin(), pairings.end(),
                   [](const Pairing& a, const Pairing& b) { return a.score > b.score; });
  return pairings;
}

std::string TextOf(const Candidate& candidate) {
  std::string text;
  for (const std::string& name : candidate.names) text += (text.empty() ? "" : " and ") + name;
  return text;
}

ChannelMatch MatchOf(const Pairing& pairing, const SoughtChannel& sought, const Candidate& candidate) {
  ChannelMatch match{.name = sought.name, .source = {}, .correlation = pairing.correlation};
  constexpr double kOpposite = -0.5;
  const double sign = pairing.correlation.value_or(1) < kOpposite ? -1 : 1;
  for (const std::string& name : candidate.names) {
    match.source.channels.emplace_back(name);
    match.source.channels.back().factor = sign;
  }
  if (candidate.names.size() > 1 && sought.is_sum) match.source.combine = ChannelSource::Combine::kSum;
  const bool is_equal = candidate.names.size() == 1 && candidate.names.front() == sought.name;
  match.by = is_equal                                                      ? ChannelMatch::By::kName
             : pairing.likeness < kLike                                    ? ChannelMatch::By::kMotion
             : sought.is_post && !candidate.meaning.words.contains("post") ? ChannelMatch::By::kPlace
                                                                           : ChannelMatch::By::kLikeName;
  return match;
}

bool AreOfOneKind(const NameMeaning& one, const NameMeaning& other) { return one.words == other.words; }

bool AreAtOnePlace(const NameMeaning& one, const NameMeaning& other) {
  return one.front == other.front && one.left == other.left && (one.front != 0 || one.left != 0);
}

/// The channels that were not matched, of which others of their kind were.
class Kin {
 public:
  Kin(const std::vector<SoughtChannel>& sought, const std::vector<NameMeaning>& meanings,
      const std::vector<Candidate>& candidates, const CorrelationOf& correlation)
      : sought_(sought), meanings_(meanings), candidates_(candidates), correlation_(correlation) {}

  /// `pairs`: of each sought the place of its candidate.
  void Add(std::vector<std::optional<std::size_t>>& pairs, std::vector<std::optional<ChannelMatch>>& found) const {
    for (std::size_t s = 0; s < sought_.size(); ++s)
      for (std::size_t c = 0; c < candidates_.size() && !pairs[s]; ++c) {
        const bool is_taken = std::find(pairs.begin(), pairs.end(), c) != pairs.end();
        if (is_taken || !MayBe(sought_[s], meanings_[s], candidates_[c])) continue;
        if (!AreAtOnePlace(meanings_[s], candidates_[c].meaning) || !HasKin(s, c, pairs)) continue;
        const Pairing pairing{
            .sought = s, .candidate = c, .correlation = MeanCorrelation(sought_[s].name, candidates_[c], correlation_)};
        found[s] = MatchOf(pairing, sought_[s], candidates_[c]);
        found[s]->by = ChannelMatch::By::kKind;
        pairs[s] = c;
      }
  }

 private:
  bool HasKin(std::size_t s, std::size_t c, const std::vector<std::optional<std::size_t>>& pairs) const {
    for (std::size_t other = 0; other < sought_.size(); ++other)
      if (pairs[other] && AreOfOneKind(meanings_[s], meanings_[other]) &&
          AreOfOneKind(candidates_[c].meaning, candidates_[*pairs[other]].meaning))
        return true;
    return false;
  }

  const std::vector<SoughtChannel>& sought_;
  const std::vector<NameMeaning>& meanings_;
  const std::vector<Candidate>& candidates_;
  const CorrelationOf& correlation_;
};

/// The last channel of a dimension, where one thing is left that it may be, if it moves about as that does.
void AddLast(const std::vector<SoughtChannel>& sought, const std::vector<NameMeaning>& meanings,
             const std::vector<Candidate>& candidates, const CorrelationOf& correlation,
             std::vector<std::optional<std::size_t>>& pairs, std::vector<std::optional<ChannelMatch>>& found) {
  constexpr double kAbout = 0.5;
  const auto is_left = [&](std::size_t c) { return std::find(pairs.begin(), pairs.end(), c) == pairs.end(); };
  for (std::size_t s = 0; s < sought.size(); ++s) {
    if (pairs[s]) continue;
    std::size_t others = 0;
    for (std::size_t other = 0; other < sought.size(); ++other)
      if (other != s && !pairs[other] && sought[other].dimension == sought[s].dimension) ++others;
    std::vector<std::size_t> left;
    for (std::size_t c = 0; c < candidates.size(); ++c)
      if (is_left(c) && candidates[c].dimension == sought[s].dimension) left.push_back(c);
    if (others > 0 || left.size() != 1) continue;
    const Candidate& last = candidates[left.front()];
    if (!MayBe(sought[s], meanings[s], last) || NameOtherParts(meanings[s], last.meaning)) continue;
    if (Likeness(meanings[s], last.meaning) < 0) continue;
    const Pairing pairing{
        .sought = s, .candidate = left.front(), .correlation = MeanCorrelation(sought[s].name, last, correlation)};
    if (std::abs(pairing.correlation.value_or(0)) < kAbout) continue;
    found[s] = MatchOf(pairing, sought[s], last);
    found[s]->by = ChannelMatch::By::kLast;
    pairs[s] = left.front();
  }
}

}  // namespace

bool ChannelMatch::IsSure() const {
  // A vehicle whose values are not fitted moves about as the real one does.
  const double enough = by == By::kName ? 0.2 : 0.5;
  const bool is_named = by == By::kName || by == By::kLikeName;
  return is_named && rival.empty() && !is_motionless && correlation.value_or(1) > enough;
}

std::vector<ChannelMatch> MatchChannels(const std::vector<SoughtChannel>& sought,
                                        const std::vector<OfferedChannel>& offered, bool has_sides,
                                        const CorrelationOf& correlation) {
  const std::vector<Candidate> candidates = CandidatesOf(offered, has_sides);
  const std::vector<NameMeaning> meanings = MeaningsOfAll(sought, has_sides);
  const std::vector<Pairing> pairings = PairingsOf(sought, meanings, candidates, correlation);
  std::vector<std::optional<std::size_t>> pairs(sought.size());
  std::vector<bool> is_taken(candidates.size());
  std::vector<std::optional<ChannelMatch>> found(sought.size());
  for (const Pairing& best : pairings) {
    if (pairs[best.sought] || is_taken[best.candidate]) continue;
    ChannelMatch match = MatchOf(best, sought[best.sought], candidates[best.candidate]);
    for (const Pairing& other : pairings) {
      const bool is_rival = other.sought == best.sought && other.candidate != best.candidate &&
                            !is_taken[other.candidate] && other.score > best.score - kNear;
      if (is_rival && match.by != ChannelMatch::By::kName) match.rival = TextOf(candidates[other.candidate]);
    }
    pairs[best.sought] = best.candidate;
    is_taken[best.candidate] = true;
    found[best.sought] = std::move(match);
  }
  Kin(sought, meanings, candidates, correlation).Add(pairs, found);
  AddLast(sought, meanings, candidates, correlation, pairs, found);
  std::vector<ChannelMatch> matches;
  for (std::optional<ChannelMatch>& match : found)
    if (match) matches.push_back(*std::move(match));
  return matches;
}

std::vector<SoughtChannel> SoughtSensors(const Vehicle& vehicle) {
  std::vector<SoughtChannel> sought;
  for (const Sensor& sensor : vehicle.sensors)
    sought.push_back({sensor.name, ParseUnit(UnitOf(sensor.type))->dimension, sensor.type == Sensor::Type::kLoadCell});
  return sought;
}

std::vector<SoughtChannel> SoughtPosts(const Vehicle& vehicle) {
  std::vector<SoughtChannel> sought;
  for (const Post& post : vehicle.posts)
    sought.push_back({.name = "post_" + post.name, .dimension = kLength, .is_post = true});
  return sought;
}

std::vector<SoughtChannel> SoughtTyres(const Vehicle& vehicle) {
  std::vector<SoughtChannel> sought;
  for (const Tyre& tyre : vehicle.tyres) sought.push_back({tyre.name, kForce, true});
  return sought;
}

std::vector<SoughtChannel> SoughtActuators(const Vehicle& vehicle) {
  std::vector<SoughtChannel> sought;
  for (const Actuator& actuator : vehicle.actuators) sought.push_back({actuator.name, kForce});
  return sought;
}

bool HasSides(const Vehicle& vehicle) {
  try {
    PostPattern(vehicle, "roll");
    return true;
  } catch (const PatternError&) {
    return false;
  }
}

}  // namespace fourpost
