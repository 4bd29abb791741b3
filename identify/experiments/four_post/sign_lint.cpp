#include "identify/experiments/four_post/sign_lint.h"

#include <cmath>
#include <complex>

#include <Eigen/Core>

#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Measured and modelled, each frequency of each run that is in the band. Channels whose members oppose each other say
/// nothing of their sign.
struct Pair {
  Eigen::VectorXcd measured;
  Eigen::VectorXcd modelled;
};

Pair Gather(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, std::size_t sensor) {
  std::vector<Complex> measured;
  std::vector<Complex> model;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& channel : runs[r].channels) {
      if (channel.sensor != sensor || channel.has_opposed_members) continue;
      for (std::size_t i = 0; i < channel.response.size(); ++i) {
        const Complex value = modelled[r].channels[sensor].response[i];
        if (!std::isfinite(value.real())) continue;
        measured.push_back(channel.response[i]);
        model.push_back(value);
      }
    }
  const auto count = static_cast<Eigen::Index>(measured.size());
  return {Eigen::Map<Eigen::VectorXcd>(measured.data(), count), Eigen::Map<Eigen::VectorXcd>(model.data(), count)};
}

}  // namespace

void LintSigns(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
               const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings) {
  // A vehicle file is a guess: rates and masses off by a third leave 0.7 and more of a correlation.
  constexpr double kOpposite = -0.4;
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    const auto [measured, model] = Gather(runs, modelled, s);
    if (measured.size() == 0 || model.squaredNorm() == 0) continue;
    const double correlation = model.dot(measured).real() / (model.norm() * measured.norm());
    if (correlation < kOpposite)
      warnings.Report(kSignOpposite, vehicle.sensors[s].name,
                      {vehicle.sensors[s].name, ShortNumber(correlation, 2), warnings.Turned(vehicle.sensors[s].name)});
  }
}

}  // namespace fourpost
