#include "identify/experiments/bench/bench_residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "analysis/signals/deviation.h"
#include "identify/experiments/bench/force_memory.h"

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

/// Rebound positive.
double SpeedAt(const BenchRecording& recording, std::size_t sample) {
  return recording.motion.rate[sample * recording.motion.steps];
}

Target TargetOf(const BenchRecording& recording, double model_error) {
  Target target{.recording = recording, .stride = ResidualStride(recording)};
  target.count = (recording.end - recording.first + target.stride - 1) / target.stride;
  target.weight = 1 / (model_error * DeviationOfForce(recording));
  return target;
}

Evaluation Evaluate(const BenchDamper& damper, const std::vector<Target>& targets, ForceMemory& memory,
                    Eigen::Index count, const std::vector<double>& values, const Deadline& deadline) {
  Evaluation evaluation;
  evaluation.residuals.resize(count);
  double* out = evaluation.residuals.data();
  for (std::size_t t = 0; t < targets.size(); ++t) {
    deadline.Check();
    const Target& target = targets[t];
    const BenchRecording& recording = target.recording;
    const auto modelled = memory.Of(t, damper, recording, values);
    const std::vector<double>& force = *modelled;
    if (force.empty()) return Infeasible(1, "a chamber of the damper closes in '" + recording.name + "'");
    for (std::size_t k = recording.first; k < recording.end; k += target.stride)
      *out++ = recording.IsUnknown(k) ? 0 : target.weight * (force[k] - recording.force[k]);
  }
  return evaluation;
}

Eigen::Index UnmeasuredOf(const Target& target) {
  Eigen::Index count = 0;
  for (std::size_t k = target.recording.first; k < target.recording.end; k += target.stride)
    count += target.recording.IsUnknown(k) ? 1 : 0;
  return count;
}

/// Bump and rebound have rates of their own, each in three classes of speed of equal size.
class SpeedClasses {
 public:
  explicit SpeedClasses(const std::vector<Target>& targets) {
    for (const Target& target : targets)
      for (std::size_t k = target.recording.first; k < target.recording.end; k += target.stride) {
        const double speed = SpeedAt(target.recording, k);
        speeds_[speed > 0].push_back(std::abs(speed));
      }
    for (std::vector<double>& of_side : speeds_) std::sort(of_side.begin(), of_side.end());
  }

  std::string NameOf(double speed) const {
    const std::vector<double>& of_side = speeds_[speed > 0];
    const auto place = std::lower_bound(of_side.begin(), of_side.end(), std::abs(speed)) - of_side.begin();
    const char* size = kSizes[static_cast<std::size_t>(place) * kSizes.size() / of_side.size()];
    return size + std::string(speed > 0 ? " rebound" : " bump");
  }

 private:
  static constexpr std::array<const char*, 3> kSizes = {"slow", "medium", "fast"};
  /// Of bump and of rebound.
  std::array<std::vector<double>, 2> speeds_;
};

/// Recordings, classes of speed, and the order of samples.
ResidualStructure StructureOf(const std::vector<Target>& targets) {
  ResidualPartition classes = {"damper speeds", {}, {}};
  ResidualStructure structure;
  const SpeedClasses speeds(targets);
  Eigen::Index next = 0;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const Target& target = targets[t];
    for (std::size_t i = 0; i < target.count; ++i)
      classes.Add(speeds.NameOf(SpeedAt(target.recording, target.recording.first + i * target.stride)), 1);
    const auto count = static_cast<Eigen::Index>(target.count);
    structure.recordings.Add(target.recording.name, count);
    structure.series.push_back({.first = next,
                                .count = count,
                                .step = 1,
                                .is_over_time = true,
                                .record = static_cast<int>(t),
                                .start_s = target.recording.time_s(target.recording.first),
                                .interval_s = target.recording.sample_s * static_cast<double>(target.stride),
                                .unmeasured = UnmeasuredOf(target)});
    next += count;
  }
  structure.partitions = {std::move(classes)};
  return structure;
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
  ResidualStructure structure = StructureOf(targets);
  return {.name = "bench recordings",
          .count = residuals,
          // Neighbouring values take nearly the same steps: forces change by a hundredth of what they err, see
          // kSeriesTolerance.
          .accuracy = 1e-7,
          .evaluate =
              [damper = BenchDamper(vehicle, data.damper), targets = std::move(targets),
               memory = std::make_shared<ForceMemory>(vehicle, data.fitted),
               residuals](const std::vector<double>& values, const Deadline& deadline) {
                return Evaluate(damper, targets, *memory, residuals, values, deadline);
              },
          .structure = std::move(structure)};
}

}  // namespace fourpost
