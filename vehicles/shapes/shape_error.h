#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/found.h"

namespace fourpost {

/// A mesh that cannot be read, or a shape that is no solid.
class ShapeError : public std::runtime_error {
 public:
  /// `words` follow the shape's name.
  explicit ShapeError(const Finding& kind, std::vector<std::string> words = {}, const std::string& shape = "the shape");

  /// The same of a shape of another name, such as "mesh 'wheel.stl'".
  Found About(const std::string& shape) const;
  const Finding& kind() const { return kind_; }
  const std::vector<std::string>& words() const { return words_; }

 private:
  const Finding& kind_;
  std::vector<std::string> words_;
};

}  // namespace fourpost
