#pragma once

#include <string>
#include <vector>

#include "tests/findings.h"
#include "vehicles/shapes/shape_error.h"

namespace fourpost {

/// Of something to call: it throws ShapeError of this kind, whose message names each of `words`.
inline auto RefusesShape(const Finding& kind, const std::vector<std::string>& words = {}) {
  const auto is_it = [&kind, words](const ShapeError& error) {
    return Is({.id = std::string(error.kind().id()), .message = error.what()}, kind, words);
  };
  return testing::Throws<ShapeError>(testing::ResultOf(is_it, testing::IsTrue()));
}

}  // namespace fourpost
