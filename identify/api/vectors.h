#pragma once

#include <vector>

#include <Eigen/Core>

namespace fourpost::api {

/// The same numbers.
template <typename Number>
Eigen::Matrix<Number, Eigen::Dynamic, 1> VectorOf(const std::vector<Number>& values) {
  return Eigen::Map<const Eigen::Matrix<Number, Eigen::Dynamic, 1>>(values.data(),
                                                                    static_cast<Eigen::Index>(values.size()));
}

}  // namespace fourpost::api
