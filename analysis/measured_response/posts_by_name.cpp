#include "analysis/measured_response/posts_by_name.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "analysis/text/name_meaning.h"
#include "analysis/text/nearest.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 16> kCommands = {
    "soll", "sollwert", "sollweg",  "kommando", "cmd",     "command", "commanded", "ref",
    "drv",  "drive",    "setpoint", "demand",   "desired", "target",  "demanded",  "reference"};
constexpr std::array<std::string_view, 16> kFeedbacks = {"ist",  "istwert",  "istweg",   "gemessen", "fb",   "fbk",
                                                         "fdbk", "feedback", "act",      "actual",   "meas", "measured",
                                                         "resp", "rsp",      "response", "achieved"};

template <std::size_t kCount>
bool IsOneOf(std::string_view word, const std::array<std::string_view, kCount>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsCorner(std::string_view word) {
  constexpr std::array<std::string_view, 8> kCorners = {"fl", "fr", "rl", "rr", "front", "rear", "left", "right"};
  return IsOneOf(word, kCorners);
}

bool MeansPost(std::string_view word) { return MeaningOf(word).words.contains("post"); }

/// "road", "roadfl": words of other things as well.
bool IsLoose(std::string_view word) {
  constexpr std::array<std::string_view, 3> kLoose = {"act", "road", "table"};
  constexpr std::size_t kCorner = 2;
  return std::any_of(kLoose.begin(), kLoose.end(), [&](std::string_view loose) {
    return word.starts_with(loose) && (word.size() == loose.size() || word.size() == loose.size() + kCorner);
  });
}

/// A channel's name, and what it is beside what it says of command and feedback.
struct Candidate {
  std::string channel;
  /// In lower case, without those of command and feedback.
  std::vector<std::string> words;
  bool is_command = false;
  bool is_feedback = false;

  /// From one of the words on.
  std::string Joined(char between, std::size_t first = 0) const {
    std::string text;
    for (std::size_t i = first; i < words.size(); ++i) text += (i > first ? std::string(1, between) : "") + words[i];
    return text;
  }
};

/// "vlsoll" is "vl" and "soll".
void TakeRoleBehindPlace(std::string& word, Candidate& candidate) {
  constexpr std::size_t kCorner = 2;
  if (word.size() <= kCorner || (MeaningOf(word.substr(0, kCorner)).front == 0)) return;
  const std::string role = word.substr(kCorner);
  const bool is_command = IsOneOf(role, kCommands);
  if (!is_command && !IsOneOf(role, kFeedbacks)) return;
  (is_command ? candidate.is_command : candidate.is_feedback) = true;
  word.resize(kCorner);
}

Candidate CandidateOf(const std::string& channel) {
  Candidate candidate{.channel = channel, .words = {}};
  std::vector<std::string> words = WordsOf(channel);
  // "act" is an actuator where no other word is one.
  const auto is_plain_post = [](const std::string& word) { return word != "act" && MeansPost(word); };
  const bool has_post = std::any_of(words.begin(), words.end(), is_plain_post);
  for (std::string& word : words) {
    const bool is_actuator = word == "act" && !has_post;
    const bool is_command = IsOneOf(word, kCommands);
    if (is_command) candidate.is_command = true;
    if (is_command) continue;
    if (!is_actuator && IsOneOf(word, kFeedbacks)) {
      candidate.is_feedback = true;
      continue;
    }
    TakeRoleBehindPlace(word, candidate);
    candidate.words.push_back(word);
  }
  return candidate;
}

/// "FL", "front", "left"; empty without a place.
std::string PlaceOf(const NameMeaning& meaning) {
  const std::string front = meaning.front > 0 ? "front" : meaning.front < 0 ? "rear" : "";
  const std::string left = meaning.left > 0 ? "left" : meaning.left < 0 ? "right" : "";
  if (front.empty() || left.empty()) return front + left;
  return std::string(meaning.front > 0 ? "F" : "R") + (meaning.left > 0 ? "L" : "R");
}

/// Of a part of the vehicle, or of a distance to the ground.
bool MeansOther(const Candidate& candidate, const NameMeaning& meaning) {
  for (const char* other : {"body", "strut", "tyre", "cg", "ground", "clearance", "ride"})
    if (meaning.words.contains(other) ||
        std::find(candidate.words.begin(), candidate.words.end(), other) != candidate.words.end())
      return true;
  return false;
}

bool IsPost(const Candidate& candidate, const NameMeaning& meaning) {
  if (!meaning.words.contains("post") || MeansOther(candidate, meaning)) return false;
  const auto is_sure = [](const std::string& word) { return MeansPost(word) && !IsLoose(word); };
  return std::any_of(candidate.words.begin(), candidate.words.end(), is_sure) || meaning.words.size() == 1;
}

/// Candidates for one post.
struct Post {
  std::string key;
  std::string name;
  std::vector<Candidate> candidates = {};
};

void AddTo(std::vector<Post>& posts, Post post, const Candidate& candidate) {
  const auto is_it = [&](const Post& other) { return other.key == post.key; };
  auto place = std::find_if(posts.begin(), posts.end(), is_it);
  if (place == posts.end()) place = posts.insert(posts.end(), std::move(post));
  place->candidates.push_back(candidate);
}

/// "FL" of "post_FL", "front" of "Post front"; with words of command and feedback the place, or what is left.
std::string NameBehindPost(const Candidate& candidate, const std::string& place) {
  constexpr std::size_t kPost = 4;
  const std::size_t rest = candidate.channel.find_first_not_of("_- .:", kPost);
  if (rest == std::string::npos) return candidate.channel;
  if (!candidate.is_command && !candidate.is_feedback) return candidate.channel.substr(rest);
  return place.empty() && candidate.words.size() > 1 ? candidate.Joined('_', 1)
         : place.empty()                             ? candidate.channel
                                                     : place;
}

/// Those that begin with "post".
std::vector<Post> PostsByPrefix(const std::vector<Candidate>& candidates, const std::vector<NameMeaning>& meanings) {
  std::vector<Post> posts;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    if (candidate.words.empty() || !candidate.words.front().starts_with("post")) continue;
    if (candidate.channel.front() != 'p' && candidate.channel.front() != 'P') continue;
    const std::string place = PlaceOf(meanings[i]);
    std::string key = place;
    for (const std::string& word : meanings[i].words) key += ' ' + word;
    AddTo(posts, {key, NameBehindPost(candidate, place)}, candidate);
  }
  return posts;
}

std::vector<Post> PostsByPlaceAlone(const std::vector<Candidate>& candidates) {
  std::vector<Post> posts;
  for (const Candidate& candidate : candidates)
    if (candidate.words.size() == 1 && candidate.words.front().size() == candidate.channel.size() &&
        IsCorner(candidate.words.front()))
      AddTo(posts, {candidate.channel, candidate.channel}, candidate);
  return posts;
}

/// "Zyl_VL" and "actuator rear"; where some have a place, the others are none.
std::vector<Post> PostsByMeaning(const std::vector<Candidate>& candidates, const std::vector<NameMeaning>& meanings) {
  std::vector<Post> placed;
  std::vector<Post> others;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!IsPost(candidates[i], meanings[i])) continue;
    if (const std::string place = PlaceOf(meanings[i]); !place.empty()) AddTo(placed, {place, place}, candidates[i]);
    else AddTo(others, {candidates[i].Joined(' '), candidates[i].channel}, candidates[i]);
  }
  return placed.empty() ? others : placed;
}

/// The post's own motion is what is no command.
void Choose(const Post& post, NamedPosts& out) {
  std::vector<std::string> own;
  std::vector<std::string> commands;
  for (const Candidate& candidate : post.candidates)
    (candidate.is_command ? commands : own).push_back(candidate.channel);
  if (own.empty()) own.swap(commands);
  out.posts.push_back({own.front(), post.name});
  out.commands.insert(out.commands.end(), commands.begin(), commands.end());
  if (own.size() > 1) out.alike.push_back(own);
}

}  // namespace

std::string NamedPosts::InWords() const {
  if (!is_by_meaning && commands.empty()) return "";
  std::string text = "posts by the names of their channels: ";
  for (const PostChannel& post : posts)
    text += (&post == &posts.front() ? "'" : ", '") + post.channel + "' is " +
            (post.post == post.channel ? "one" : post.post);
  if (!commands.empty()) text += "; commands are left out: ";
  for (const std::string& command : commands) text += (&command == &commands.front() ? "'" : ", '") + command + "'";
  return text + "; where this is wrong, state `--post CHANNEL=FL` or 'post_channels'";
}

std::string NearlyPost(const std::string& name, const std::vector<std::string>& posts) {
  static const std::vector<std::vector<std::string_view>> kPlaces = {
      {"FL", "FR", "RL", "RR"}, {"fl", "fr", "rl", "rr"}, {"VL", "VR", "HL", "HR"}, {"vl", "vr", "hl", "hr"},
      {"front", "rear"},        {"Front", "Rear"},        {"left", "right"},        {"Left", "Right"}};
  std::vector<std::string> others;
  for (const std::string& post : posts)
    for (const std::vector<std::string_view>& places : kPlaces)
      for (const std::string_view place : places) {
        const std::size_t at = post.rfind(place);
        if (at == std::string::npos) continue;
        for (const std::string_view other : places) {
          const std::string changed = post.substr(0, at) + std::string(other) + post.substr(at + place.size());
          if (std::find(posts.begin(), posts.end(), changed) == posts.end()) others.push_back(changed);
        }
      }
  return std::string(NearestName(name, others).value_or(""));
}

NamedPosts PostsByName(const std::vector<std::string>& lengths) {
  std::vector<Candidate> candidates;
  std::vector<std::string> bare;
  for (const std::string& name : lengths) {
    candidates.push_back(CandidateOf(name));
    bare.push_back(candidates.back().Joined(' '));
  }
  const std::vector<NameMeaning> meanings = MeaningsOf(bare, true);
  NamedPosts out;
  std::vector<Post> posts = PostsByPrefix(candidates, meanings);
  if (posts.empty()) posts = PostsByPlaceAlone(candidates);
  if (posts.empty()) {
    posts = PostsByMeaning(candidates, meanings);
    out.is_by_meaning = true;
  }
  for (const Post& post : posts) Choose(post, out);
  return out;
}

}  // namespace fourpost
