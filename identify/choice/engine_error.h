#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "identify/choice/choice.h"

namespace fourpost {

/// By which factor time histories change each objective against the present setting otherwise than spectra, for all
/// settings and possible cars: settings x draws, a matrix per objective. At settings that were compared it is what
/// `checks` say; its logarithm d is, between and beyond them, fractional Brownian motion of exponent 3/4, zero at the
/// present setting, with covariance
///   v/2 (|f_s|^1.5 + |f_t|^1.5 - |f_s - f_t|^1.5),  f: positions of knobs from the present ones, as shares of each,
/// and v by the draw d' C^-1 d / n * m / chi^2_m, m = n + 3, of n comparisons: few leave it in doubt. One draw is the
/// mean. Empty where nothing was compared.
std::vector<Eigen::MatrixXd> EngineErrors(const SettingsFile& file, const std::vector<Setting>& settings,
                                          std::size_t present, const std::vector<EngineCheck>& checks,
                                          Eigen::Index draws);

}  // namespace fourpost
