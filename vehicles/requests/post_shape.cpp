#include "vehicles/requests/post_shape.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "analysis/text/known_names.h"
#include "analysis/text/number.h"
#include "vehicles/description/post_pattern.h"

namespace fourpost {
namespace {

bool IsPattern(std::string_view mode) {
  return std::find(kPostPatterns.begin(), kPostPatterns.end(), mode) != kPostPatterns.end();
}

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
    if (!faulty_ && std::none_of(shares_.begin(), shares_.end(), is_reference))
      Fault("'" + mode + "': one post is the reference, whose share is 1 or -1");
    std::vector<double> shape;
    for (const std::optional<double>& share : shares_) shape.push_back(share.value_or(0));
    return shape;
  }

 private:
  void Fault(const std::string& message) {
    faulty_ = true;
    diagnostics_.Error("--mode", 0, message);
  }

  void Add(const std::string& part) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = part.substr(0, equals);
    const std::optional<double> share = equals < part.size() ? ParseNumber(part.substr(equals + 1)) : std::nullopt;
    const auto post = std::find(posts_.begin(), posts_.end(), name);
    std::optional<double>* const place = post == posts_.end() ? nullptr : &shares_[post - posts_.begin()];
    if (!place) Fault("the vehicle has no post '" + name + "'" + KnownNames(name, posts_));
    else if (!share) Fault("'" + part + "' is no share of a post: write " + name + "=1, or -1 against it");
    else if (*place) Fault("post '" + name + "' is named twice");
    else *place = share;
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
  } catch (const std::invalid_argument& refusal) {
    const std::string shares = "; or tell the share of each post, as " + vehicle.posts.front().name + "=1";
    diagnostics.Error("--mode", 0, refusal.what() + (IsPattern(mode) ? "" : shares));
    return {};
  }
}

}  // namespace fourpost
