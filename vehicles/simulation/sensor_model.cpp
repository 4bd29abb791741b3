#include "vehicles/simulation/sensor_model.h"

#include <cmath>
#include <span>

#include "analysis/signals/low_pass.h"
#include "analysis/signals/random_stream.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

void AddNoise(double share, RandomStream draws, std::span<double> signal) {
  Eigen::Map<Eigen::ArrayXd> samples(signal.data(), static_cast<Eigen::Index>(signal.size()));
  const double deviation = share * std::sqrt((samples - samples.mean()).square().mean());
  for (double& sample : signal) sample += deviation * draws.Normal();
}

}  // namespace

void SensorModel::Apply(TimeHistory& history) const {
  RequireOption(noise >= 0 && std::isfinite(noise), "SensorModel: noise", noise, "finite and not negative");
  std::uint64_t channel = 0;
  for (Eigen::MatrixXd* columns : {&history.posts, &history.readings})
    for (Eigen::Index i = 0; i < columns->cols(); ++i, ++channel) {
      const std::span<double> signal(columns->col(i).data(), static_cast<std::size_t>(columns->rows()));
      if (filter) LowPass(filter->order, filter->cutoff_Hz, history.rate_Hz).Apply(signal);
      if (noise > 0) AddNoise(noise, RandomStream(seed, "channel noise", channel), signal);
    }
}

}  // namespace fourpost
