#pragma once

#include <Eigen/Core>

#include "identify/search/draws.h"

namespace fourpost {

/// A standard normal number between two limits, either of which may be infinite (Robert, Stat. Comput. 5, 1995).
double DrawNormalBetween(double lower, double upper, Draws& draws);

/// A normal vector with this centre, within its bounds, and covariance root root', within bounds: hit-and-run along
/// random lines from the centre, on each of which the next point is drawn exactly (Chen and Schmeiser, Oper. Res. Lett.
/// 19, 1996). Without bounds a step forgets 1/n of where it was; 30 n of them leave nothing. No point is moved to a
/// bound.
Eigen::VectorXd DrawNormalWithin(const Eigen::VectorXd& centre, const Eigen::MatrixXd& root,
                                 const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, Draws& draws);

}  // namespace fourpost
