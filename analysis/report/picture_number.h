#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

namespace fourpost {

/// Six significant digits, which is more than a picture shows and a third of the text; null when not finite.
nlohmann::ordered_json PictureNumber(double value);

/// A list of them.
nlohmann::ordered_json PictureNumbers(const std::vector<double>& values);
/// Likewise, column by column.
template <typename Derived>
nlohmann::ordered_json PictureNumbers(const Eigen::DenseBase<Derived>& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index i = 0; i < values.rows(); ++i) list.push_back(PictureNumber(values(i, j)));
  return list;
}

}  // namespace fourpost
