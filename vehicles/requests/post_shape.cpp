#include "vehicles/requests/post_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "analysis/text/known_names.h"
#include "analysis/text/name_meaning.h"
#include "analysis/text/number.h"
#include "vehicles/description/findings.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/requests/findings.h"

namespace fourpost {
namespace {

class ShareReader {
 public:
  ShareReader(const Vehicle& vehicle, Diagnostics& diagnostics)
      : diagnostics_(diagnostics), shares_(vehicle.posts.size()) {
    for (const Post& post : vehicle.posts) posts_.push_back(post.name);
  }

  /// "FL=1,FR=-1"
  std::vector<double> Read(const std::string& mode) {
    for (std::size_t begin = 0; begin <= mode.size();) {
      const std::size_t end = std::min(mode.find(',', begin), mode.size());
      Add(mode.substr(begin, end - begin));
      begin = end + 1;
    }
    const auto is_reference = [](const std::optional<double>& share) { return std::abs(share.value_or(0)) == 1; };
    if (!faulty_ && std::none_of(shares_.begin(), shares_.end(), is_reference)) Fault(kShareNoReference, {mode});
    std::vector<double> shape;
    for (const std::optional<double>& share : shares_) shape.push_back(share.value_or(0));
    return shape;
  }

 private:
  void Fault(const Finding& kind, const std::vector<std::string>& words) {
    faulty_ = true;
    diagnostics_.Report(kind, Place::Option("--mode"), words);
  }

  void Add(const std::string& part) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = part.substr(0, equals);
    const std::optional<double> share = equals < part.size() ? ParseNumber(part.substr(equals + 1)) : std::nullopt;
    const auto post = FindPost(name);
    std::optional<double>* const place = post == posts_.end() ? nullptr : &shares_[post - posts_.begin()];
    if (!place) Fault(kSharePost, {name, KnownNames(name, posts_)});
    else if (!share) Fault(kShareMalformed, {part, name});
    else if (*place) Fault(kSharePostTwice, {name});
    else *place = share;
  }

  /// By its name, or by a place that is that of one post alone: "FL" of 'front_post_left'.
  std::vector<std::string>::const_iterator FindPost(const std::string& name) const {
    const auto exact = std::find(posts_.begin(), posts_.end(), name);
    const NameMeaning meant = MeaningOf(name);
    if (exact != posts_.end() || (meant.front == 0 && meant.left == 0)) return exact;
    const auto is_there = [&](const std::string& post) {
      const NameMeaning meaning = MeaningOf(post);
      return meaning.front == meant.front && meaning.left == meant.left;
    };
    return std::count_if(posts_.begin(), posts_.end(), is_there) == 1
               ? std::find_if(posts_.begin(), posts_.end(), is_there)
               : posts_.end();
  }

  Diagnostics& diagnostics_;
  std::vector<std::string> posts_;
  std::vector<std::optional<double>> shares_;
  bool faulty_ = false;
};

}  // namespace

std::vector<double> ReadPostShape(const std::string& mode, const Vehicle& vehicle, Diagnostics& diagnostics) {
  if (mode.find('=') != std::string::npos) return ShareReader(vehicle, diagnostics).Read(mode);
  try {
    return PostPattern(vehicle, mode);
  } catch (const PatternError& refusal) {
    Found found = refusal.found();
    if (found.kind == &kPatternUnknown) {
      found.kind = &kModeUnknown;
      found.words.push_back(vehicle.posts.front().name);
    }
    diagnostics.Report(*found.kind, Place::Option("--mode"), found.words);
    return {};
  }
}

}  // namespace fourpost
