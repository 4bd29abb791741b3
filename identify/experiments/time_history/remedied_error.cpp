#include "identify/experiments/time_history/remedied_error.h"

#include <stdexcept>

#include "analysis/signals/fit_quality.h"
#include "analysis/signals/spline_through.h"

namespace fourpost {
namespace {

using Eigen::Index;

double ErrorOf(const Eigen::VectorXd& measured, const Eigen::VectorXd& modelled, double rate_Hz, double factor,
               double delay_s) {
  const double step_s = 1 / rate_Hz;
  const UniformSpline spline = SplineThrough({measured.data(), static_cast<std::size_t>(measured.size())}, 0, step_s);
  std::vector<double> remedied;
  std::vector<double> model;
  for (Index k = 0; k < modelled.size(); ++k) {
    const double t = step_s * static_cast<double>(k) + delay_s;
    if (t < 0 || t > spline.end()) continue;
    remedied.push_back(factor * spline.At(t).value);
    model.push_back(modelled[k]);
  }
  return NormalisedMse_percent(remedied, model);
}

}  // namespace

double RemediedErrors::Percent(const std::string& recording, const std::string& channel, double factor,
                               double delay_s) const {
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    if (histories_[h].name != recording) continue;
    for (std::size_t i = 0; i < histories_[h].signals.size(); ++i)
      if (histories_[h].signals[i].name == channel)
        return ErrorOf(histories_[h].signals[i].values, modelled_[h].col(static_cast<Index>(i)), histories_[h].rate_Hz,
                       factor, delay_s);
  }
  throw std::out_of_range("RemediedErrors: no channel '" + channel + "' of '" + recording + "'");
}

}  // namespace fourpost
