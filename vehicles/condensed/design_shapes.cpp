#include "vehicles/condensed/design_shapes.h"

#include <array>
#include <utility>

namespace fourpost {

std::vector<DesignShape> DesignShapes(Multibody& multibody, Chart& chart, const std::vector<GeometricScalar>& scalars) {
  // Truncation h^4 and rounding eps/h meet near 1e-3; both stay below 1e-12 for lengths of about a metre.
  constexpr double kStep = 1e-3;
  constexpr std::array<std::pair<double, double>, 4> kStencil = {
      {{-2, 1.0 / 12}, {-1, -8.0 / 12}, {1, 8.0 / 12}, {2, -1.0 / 12}}};
  const Eigen::Index n = chart.size();
  std::vector<DesignShape> shapes(scalars.size());
  for (DesignShape& shape : shapes) shape.curvature.setZero(n, n);
  for (Eigen::Index column = 0; column < n; ++column) {
    for (const auto& [offset, weight] : kStencil) {
      const Eigen::MatrixXd tangent = chart.MoveTo(offset * kStep * Eigen::VectorXd::Unit(n, column));
      const Kinematics pose(multibody, tangent);
      for (std::size_t i = 0; i < scalars.size(); ++i)
        shapes[i].curvature.col(column) += weight / kStep * scalars[i](pose).gradient;
    }
  }
  const Kinematics design(multibody, chart.MoveTo(Eigen::VectorXd::Zero(n)));
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const Coordinate here = scalars[i](design);
    shapes[i].value = here.value;
    shapes[i].gradient = here.gradient;
    shapes[i].curvature = (0.5 * (shapes[i].curvature + shapes[i].curvature.transpose())).eval();
  }
  return shapes;
}

}  // namespace fourpost
