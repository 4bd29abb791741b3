#include "vehicles/condensed/modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {
namespace {

struct RealPole {
  double value = 0;
  Eigen::VectorXd shape;
};

Eigen::VectorXcd Normalised(const Eigen::VectorXcd& shape) {
  Eigen::Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  return shape / shape[largest];
}

Mode Oscillating(std::complex<double> pole, const Eigen::VectorXcd& shape) {
  return {.kind = Mode::Kind::kOscillating,
          .frequency_Hz = std::abs(pole) / (2 * std::numbers::pi),
          .damping_ratio = -pole.real() / std::abs(pole),
          .pole = pole,
          .shape = Normalised(shape)};
}

/// Of the two poles of one motion.
Mode WithoutOscillation(const RealPole& one, const RealPole& other) {
  const RealPole& high = one.value > other.value ? one : other;
  const RealPole& low = one.value > other.value ? other : one;
  if (high.value > 0) return {.kind = Mode::Kind::kDiverging, .pole = high.value, .shape = Normalised(high.shape)};
  const double natural = std::sqrt(high.value * low.value);
  return {.kind = Mode::Kind::kOverdamped,
          .frequency_Hz = natural / (2 * std::numbers::pi),
          .damping_ratio = -(high.value + low.value) / (2 * natural),
          .pole = high.value,
          .shape = Normalised(low.shape)};
}

/// Motions that nothing holds: K shape = w^2 M shape with |w| next to zero.
std::vector<Mode> FreeModes(const CondensedModel& model) {
  const Eigen::MatrixXd stiffness = 0.5 * (model.stiffness + model.stiffness.transpose());
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(stiffness, model.mass);
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i)
    if (std::abs(pairs.values[i]) < kSlowestMotion_per_s * kSlowestMotion_per_s)
      modes.push_back({.kind = Mode::Kind::kFree, .shape = Normalised(pairs.vectors.col(i))});
  return modes;
}

/// How alike two shapes are: 1 for one motion, 0 for two that are orthogonal (modal assurance criterion, by mass).
double Likeness(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::MatrixXd& mass) {
  const double product = a.dot(mass * b);
  return product * product / (a.dot(mass * a) * b.dot(mass * b));
}

/// Takes the two poles whose shapes are most alike.
std::pair<RealPole, RealPole> TakePair(std::vector<RealPole>& poles, const Eigen::MatrixXd& mass) {
  std::size_t first = 0;
  std::size_t second = 1;
  double best = -1;
  for (std::size_t i = 0; i < poles.size(); ++i)
    for (std::size_t j = i + 1; j < poles.size(); ++j) {
      const double likeness = Likeness(poles[i].shape, poles[j].shape, mass);
      if (!(likeness > best)) continue;
      best = likeness;
      first = i;
      second = j;
    }
  std::pair<RealPole, RealPole> pair(std::move(poles[first]), std::move(poles[second]));
  poles.erase(poles.begin() + static_cast<std::ptrdiff_t>(second));
  poles.erase(poles.begin() + static_cast<std::ptrdiff_t>(first));
  return pair;
}

/// Leaves out the poles of free motions: one at zero each, and another where nothing damps it.
void DropFree(std::size_t free_modes, std::vector<RealPole>& poles) {
  std::sort(poles.begin(), poles.end(),
            [](const RealPole& a, const RealPole& b) { return std::abs(a.value) < std::abs(b.value); });
  std::size_t drop = 0;
  while (drop < std::min(2 * free_modes, poles.size()) && std::abs(poles[drop].value) < kSlowestMotion_per_s) ++drop;
  poles.erase(poles.begin(), poles.begin() + static_cast<std::ptrdiff_t>(drop));
}

}  // namespace

const char* KindName(Mode::Kind kind) {
  switch (kind) {
    case Mode::Kind::kOscillating: return "oscillating";
    case Mode::Kind::kOverdamped: return "overdamped";
    case Mode::Kind::kFree: return "free";
    case Mode::Kind::kDiverging: return "diverging";
  }
  return "";
}

Eigen::MatrixXd StateMatrix(const CondensedModel& model) {
  return LinearVehicle(model, LinearVehicle::Rates::kMean).StateMatrix();
}

std::vector<Mode> ModesOf(const CondensedModel& model) {
  const Eigen::Index n = model.mass.rows();
  const Eigenpairs pairs = EigenpairsOf(StateMatrix(model));
  std::vector<Mode> modes = FreeModes(model);
  std::vector<RealPole> real;
  const std::size_t free_modes = modes.size();
  for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
    const std::complex<double> pole = pairs.values[i];
    const Eigen::VectorXcd shape = pairs.vectors.col(i).head(n);
    const bool is_slow = std::abs(pole) < kSlowestMotion_per_s;
    if (pole.imag() == 0 || is_slow) real.push_back({pole.real(), shape.real()});
    else if (pole.imag() > 0) modes.push_back(Oscillating(pole, shape));
  }
  DropFree(free_modes, real);
  while (modes.size() < static_cast<std::size_t>(n) && real.size() >= 2) {
    const auto [one, other] = TakePair(real, model.mass);
    modes.push_back(WithoutOscillation(one, other));
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; });
  return modes;
}

}  // namespace fourpost
