#include "vehicles/ride/pole_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <Eigen/Eigenvalues>

#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/ride/named_modes.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Poles of one model and their shapes, scaled to kinetic energy 1.
struct Spectrum {
  Eigen::VectorXcd poles;
  /// n x poles; and the mass matrix times these.
  Eigen::MatrixXcd shapes;
  Eigen::MatrixXcd momenta;
};

Spectrum SpectrumOf(const CondensedModel& model) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(StateMatrix(model));
  Spectrum spectrum{.poles = solver.eigenvalues(), .shapes = solver.eigenvectors().topRows(model.mass.rows())};
  spectrum.momenta = model.mass * spectrum.shapes;
  for (Eigen::Index i = 0; i < spectrum.poles.size(); ++i) {
    const double size = std::sqrt(std::abs(spectrum.shapes.col(i).dot(spectrum.momenta.col(i))));
    // A series spring alone moves nothing.
    if (size == 0) continue;
    spectrum.shapes.col(i) /= size;
    spectrum.momenta.col(i) /= size;
  }
  return spectrum;
}

/// How unlike two poles are: their distance over their size, and what their shapes do not have in common.
double Unlikeness(const Spectrum& a, Eigen::Index i, const Spectrum& b, Eigen::Index j) {
  const double size = std::abs(a.poles[i]) + std::abs(b.poles[j]) + kSlowestMotion_per_s;
  const double likeness = std::min(1.0, std::norm(a.shapes.col(i).dot(b.momenta.col(j))));
  return std::abs(a.poles[i] - b.poles[j]) / size + 0.25 * (1 - likeness);
}

/// For each pole of `a` that of `b` which continues it; the most alike are paired first.
std::vector<Eigen::Index> Continuation(const Spectrum& a, const Spectrum& b) {
  struct Pair {
    double unlikeness;
    Eigen::Index from;
    Eigen::Index to;
  };
  const Eigen::Index count = a.poles.size();
  std::vector<Pair> pairs;
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) pairs.push_back({Unlikeness(a, i, b, j), i, j});
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.unlikeness < y.unlikeness; });
  std::vector<Eigen::Index> to(static_cast<std::size_t>(count), -1);
  std::vector<bool> taken(static_cast<std::size_t>(count), false);
  for (const Pair& pair : pairs) {
    if (to[static_cast<std::size_t>(pair.from)] >= 0 || taken[static_cast<std::size_t>(pair.to)]) continue;
    to[static_cast<std::size_t>(pair.from)] = pair.to;
    taken[static_cast<std::size_t>(pair.to)] = true;
  }
  return to;
}

/// The vehicle with one parameter free to change.
class Follower {
 public:
  Follower(const Vehicle& vehicle, std::size_t parameter)
      : vehicle_(vehicle), parameter_(parameter), condensed_(vehicle), values_(vehicle.ParameterValues()) {}

  CondensedModel At(double value) {
    values_[parameter_] = value;
    return condensed_.At(values_);
  }

  /// Poles at each value, in the order of those at the first.
  std::vector<Eigen::VectorXcd> Follow(const std::vector<double>& values) {
    // Poles move little in an eighth of a step of a plot.
    constexpr int kSteps = 8;
    Spectrum spectrum = SpectrumOf(At(values.front()));
    std::vector<Eigen::Index> place(static_cast<std::size_t>(spectrum.poles.size()));
    std::iota(place.begin(), place.end(), 0);
    std::vector<Eigen::VectorXcd> poles = {spectrum.poles};
    for (std::size_t v = 1; v < values.size(); ++v) {
      for (int k = 1; k <= kSteps; ++k) {
        Spectrum next = SpectrumOf(At(std::lerp(values[v - 1], values[v], static_cast<double>(k) / kSteps)));
        const std::vector<Eigen::Index> to = Continuation(spectrum, next);
        for (Eigen::Index& p : place) p = to[static_cast<std::size_t>(p)];
        spectrum = std::move(next);
      }
      poles.emplace_back(spectrum.poles(place));
    }
    return poles;
  }

  std::vector<Mode> ModesAt(double value) {
    const CondensedModel model = At(value);
    const Kinematics pose = DesignKinematics(vehicle_);
    return NamedModes(vehicle_, pose, SuspensionOf(vehicle_, pose, values_), model, values_);
  }

 private:
  const Vehicle& vehicle_;
  std::size_t parameter_;
  CondensedVehicle condensed_;
  std::vector<double> values_;
};

std::string NameOf(Complex pole, const std::vector<Mode>& modes) {
  // Rounding of eigenvalues that lie close together.
  constexpr double kSame = 1e-4;
  const Complex upper(pole.real(), std::abs(pole.imag()));
  for (const Mode& mode : modes)
    for (const Complex& own : PolesOf(mode))
      if (mode.kind != Mode::Kind::kFree && std::abs(own - upper) <= kSame * std::abs(upper)) return mode.name;
  return "creep";
}

std::size_t NearestTo(double wanted, const std::vector<double>& values) {
  const auto nearest = std::min_element(
      values.begin(), values.end(), [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
  return static_cast<std::size_t>(nearest - values.begin());
}

}  // namespace

PolePaths FollowPoles(const Vehicle& vehicle, std::size_t parameter, const std::vector<double>& values) {
  if (values.empty()) throw std::invalid_argument("a path of poles needs a value of its parameter");
  Follower follower(vehicle, parameter);
  const std::vector<Eigen::VectorXcd> poles = follower.Follow(values);
  const std::size_t named = NearestTo(vehicle.parameters[parameter].value, values);
  const std::vector<Mode> modes = follower.ModesAt(values[named]);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  PolePaths out{.parameter = parameter, .values = values};
  for (Eigen::Index i = 0; i < poles.front().size(); ++i) {
    PolePath path{.mode = NameOf(poles[named][i], modes)};
    bool held = false;
    bool upper = false;
    for (const Eigen::VectorXcd& at : poles) {
      held = held || std::abs(at[i]) >= kSlowestMotion_per_s;
      upper = upper || at[i].imag() >= 0;
      path.pole.push_back(at[i].imag() >= 0 ? at[i] : Complex(kNone, kNone));
    }
    if (held && upper) out.paths.push_back(std::move(path));
  }
  const auto start = [](const PolePath& path) {
    const auto first =
        std::find_if(path.pole.begin(), path.pole.end(), [](Complex p) { return std::isfinite(p.real()); });
    return std::abs(*first);
  };
  std::stable_sort(out.paths.begin(), out.paths.end(),
                   [&](const PolePath& a, const PolePath& b) { return start(a) < start(b); });
  return out;
}

}  // namespace fourpost
