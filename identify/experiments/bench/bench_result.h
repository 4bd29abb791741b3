#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/experiments/bench/bench_data.h"
#include "identify/residuals/history_misfit.h"
#include "identify/residuals/yardstick.h"

namespace fourpost {

/// A bench recording and what the rig would have recorded of the model [N].
struct ModelledRecording {
  BenchRecording recording;
  std::vector<double> force;
};

/// Throws std::runtime_error where a chamber of the damper closes.
ModelledRecording Modelled(const BenchDamper& damper, const BenchRecording& recording,
                           const std::vector<double>& values);

/// Of several.
std::vector<ModelledRecording> ModelledRecordings(const BenchDamper& damper,
                                                  const std::vector<BenchRecording>& recordings,
                                                  const std::vector<double>& values);

/// By how much half the steps and a tenth of the tolerance change a recording's force, as rms over that of its
/// deviations: the error of the integration, or more. Throws std::runtime_error as Modelled().
double IntegrationError(const BenchDamper& damper, const ModelledRecording& modelled,
                        const std::vector<double>& values);

/// Over the samples that are compared.
std::vector<HistoryMisfit> BenchMisfits(const std::vector<ModelledRecording>& recordings);

/// For AddYardsticks(): extension and force of the samples that are compared.
std::vector<YardstickRecord> YardstickRecords(const std::vector<ModelledRecording>& recordings);

/// Of bands of 95 % about a force [N], one per sample that is compared: of the parameters alone, and of a new
/// measurement.
struct HalfWidths {
  Eigen::VectorXd parameters;
  Eigen::VectorXd measured;
};

/// A row per sample compared: recording, time, displacement, speed, measured and modelled force; `about`: half widths
/// of the bands, of one recording alone.
std::string BenchCsv(const std::vector<ModelledRecording>& recordings, const HalfWidths* about = nullptr);

}  // namespace fourpost
