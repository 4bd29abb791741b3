#include "vehicles/shapes/shape_error.h"

#include <utility>

namespace fourpost {
namespace {

std::vector<std::string> Joined(const std::string& first, const std::vector<std::string>& others) {
  std::vector<std::string> all = {first};
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

}  // namespace

ShapeError::ShapeError(const Finding& kind, std::vector<std::string> words, const std::string& shape)
    : std::runtime_error(kind.Message(Joined(shape, words))), kind_(kind), words_(std::move(words)) {}

Found ShapeError::About(const std::string& shape) const { return {&kind_, Joined(shape, words_)}; }

}  // namespace fourpost
