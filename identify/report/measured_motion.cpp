#include "identify/report/measured_motion.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Combinations of coordinates that sensors see less than that beside others are left to the model: noise would move
/// them.
constexpr double kSeen = 0.03;

/// What a reading is divided by to become a length or an angle, per metre of the reference post: accelerometers' are
/// that already.
Complex ScaleOf(Sensor::Type type, double omega) {
  return type == Sensor::Type::kGyro ? Complex(0, omega) : Complex(1, 0);
}

/// A sensor's length or angle by coordinates.
Eigen::RowVectorXcd RowOf(const CondensedModel& model, Eigen::Index sensor, Sensor::Type type, double omega) {
  const Complex iw(0, omega);
  const Eigen::RowVectorXcd row =
      model.on_position.row(sensor) + iw * model.on_velocity.row(sensor) + iw * iw * model.on_acceleration.row(sensor);
  return row / (type == Sensor::Type::kAccelerometer ? iw * iw : ScaleOf(type, omega));
}

/// Real parts above imaginary ones.
Eigen::VectorXd Change(const Eigen::MatrixXcd& rows, const Eigen::VectorXcd& differences) {
  Eigen::MatrixXd whole(2 * rows.rows(), 2 * rows.cols());
  whole << rows.real(), -rows.imag(), rows.imag(), rows.real();
  Eigen::VectorXd wanted(2 * rows.rows());
  wanted << differences.real(), differences.imag();
  return LeastNorm(whole, kSeen).Solve(wanted);
}

}  // namespace

Eigen::MatrixXcd MeasuredMotion(const Vehicle& vehicle, const CondensedModel& model, const RecordedMotion& motion,
                                const Eigen::MatrixXcd& modelled) {
  const Eigen::Index n = modelled.cols();
  Eigen::MatrixXcd measured = modelled;
  bool is_seen = false;
  for (Eigen::Index f = 0; f < modelled.rows(); ++f) {
    const auto place = static_cast<std::size_t>(f);
    const double omega = 2 * std::numbers::pi * motion.excitation.frequency_Hz[place];
    Eigen::MatrixXcd rows(static_cast<Eigen::Index>(motion.differences.size()), n);
    Eigen::VectorXcd differences(rows.rows());
    Eigen::Index count = 0;
    for (const ReadingDifference& reading : motion.differences) {
      const Sensor::Type type = vehicle.sensors[reading.sensor].type;
      const Complex difference = reading.difference[place];
      if (type == Sensor::Type::kLoadCell || !std::isfinite(std::abs(difference))) continue;
      rows.row(count) = RowOf(model, static_cast<Eigen::Index>(reading.sensor), type, omega);
      differences[count++] = difference / ScaleOf(type, omega);
    }
    if (count == 0) continue;
    is_seen = true;
    const Eigen::VectorXd change = Change(rows.topRows(count), differences.head(count));
    measured.row(f).real() += change.head(n).transpose();
    measured.row(f).imag() += change.tail(n).transpose();
  }
  return is_seen ? measured : Eigen::MatrixXcd();
}

}  // namespace fourpost
