#include "identify/experiments/bench/bench_residuals.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

/// A recording's force at the samples that are compared, over what is expected of the model.
struct Target {
  BenchRecording recording;
  std::size_t stride = 1;
  std::size_t count = 0;
  /// Of a residual [1/N].
  double weight = 1;
};

double DeviationOfForce(const BenchRecording& recording) {
  return DeviationOf(std::span(recording.force).subspan(recording.first, recording.end - recording.first));
}

Target TargetOf(const BenchRecording& recording, double model_error) {
  Target target{.recording = recording, .stride = ResidualStride(recording)};
  target.count = (recording.end - recording.first + target.stride - 1) / target.stride;
  target.weight = 1 / (model_error * DeviationOfForce(recording));
  return target;
}

Evaluation Evaluate(const BenchDamper& damper, const std::vector<Target>& targets, Eigen::Index count,
                    const std::vector<double>& values, const Deadline& deadline) {
  Evaluation evaluation;
  evaluation.residuals.resize(count);
  double* out = evaluation.residuals.data();
  for (const Target& target : targets) {
    deadline.Check();
    const BenchRecording& recording = target.recording;
    const std::vector<double> force = ModelledForce(damper, recording, values);
    if (force.empty()) return Infeasible(1, "a chamber of the damper closes in '" + recording.name + "'");
    for (std::size_t k = recording.first; k < recording.end; k += target.stride)
      *out++ = target.weight * (force[k] - recording.force[k]);
  }
  return evaluation;
}

}  // namespace

std::size_t ResidualStride(const BenchRecording& recording) {
  if (!recording.filter) return 1;
  return static_cast<std::size_t>(std::max(1.0, std::floor(1 / (2 * recording.cutoff_Hz * recording.sample_s))));
}

ResidualBlock BenchResiduals(const Vehicle& vehicle, const BenchData& data, double model_error) {
  std::vector<Target> targets;
  std::size_t count = 0;
  for (const BenchRecording& recording : data.fitted) {
    targets.push_back(TargetOf(recording, model_error));
    count += targets.back().count;
  }
  const auto residuals = static_cast<Eigen::Index>(count);
  return {.name = "bench recordings",
          .count = residuals,
          // Neighbouring values take nearly the same steps: forces change by a hundredth of what they err, see
          // kSeriesTolerance.
          .accuracy = 1e-7,
          .evaluate = [damper = BenchDamper(vehicle, data.damper), targets = std::move(targets), residuals](
                          const std::vector<double>& values, const Deadline& deadline) {
            return Evaluate(damper, targets, residuals, values, deadline);
          }};
}

}  // namespace fourpost
