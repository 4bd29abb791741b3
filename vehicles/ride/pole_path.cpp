#include "vehicles/ride/pole_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
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
  const Eigenpairs pairs = EigenpairsOf(StateMatrix(model));
  Spectrum spectrum{.poles = pairs.values, .shapes = pairs.vectors.topRows(model.mass.rows())};
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

std::size_t NearestTo(double wanted, const std::vector<double>& values) {
  const auto nearest = std::min_element(
      values.begin(), values.end(), [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
  return static_cast<std::size_t>(nearest - values.begin());
}

/// The vehicle with one parameter free to change.
class Follower {
 public:
  Follower(const Vehicle& vehicle, std::size_t parameter)
      : vehicle_(vehicle),
        parameter_(parameter),
        own_(vehicle.parameters[parameter].value),
        condensed_(vehicle),
        values_(vehicle.ParameterValues()) {}

  CondensedModel At(double value) {
    values_[parameter_] = value;
    return condensed_.At(values_);
  }

  /// Poles at each value, in the order of those of the first spectrum: outward from where that belongs, in both
  /// directions.
  std::vector<Eigen::VectorXcd> Follow(const std::vector<double>& values) {
    const std::size_t nearest = NearestTo(own_, values);
    const double step = StepOf(values);
    Walk start{.at = own_, .spectrum = SpectrumOf(At(own_))};
    start.place.resize(static_cast<std::size_t>(start.spectrum.poles.size()));
    std::iota(start.place.begin(), start.place.end(), 0);
    GoTo(values[nearest], step, start);
    std::vector<Eigen::VectorXcd> poles(values.size());
    for (const bool up : {true, false}) {
      Walk walk = start;
      for (std::size_t v = nearest; v < values.size(); up ? ++v : --v) {
        GoTo(values[v], step, walk);
        poles[v] = walk.spectrum.poles(walk.place);
      }
    }
    return poles;
  }

  /// At the file's value, in the order of Follow().
  Eigen::VectorXcd OwnPoles() { return SpectrumOf(At(own_)).poles; }

  std::vector<Mode> OwnModes() {
    const CondensedModel model = At(own_);
    const Kinematics pose = DesignKinematics(vehicle_);
    return NamedModes(vehicle_, pose, SuspensionOf(vehicle_, pose, values_), model, values_);
  }

 private:
  /// Where a walk is: its pole i is the spectrum's number place[i].
  struct Walk {
    double at = 0;
    Spectrum spectrum;
    std::vector<Eigen::Index> place;
  };

  /// Of a plot's values the mean distance.
  static double StepOf(const std::vector<double>& values) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return (*greatest - *least) / std::max<double>(1, static_cast<double>(values.size()) - 1);
  }

  /// In steps in which poles move little: an eighth of a plot's.
  void GoTo(double value, double plot_step, Walk& walk) {
    constexpr double kPerStep = 8;
    // A file's value may lie far from all of the plot's.
    constexpr double kMost = 1000;
    if (value == walk.at) return;
    const double wanted = plot_step > 0 ? kPerStep * std::abs(value - walk.at) / plot_step : kPerStep;
    const int steps = static_cast<int>(std::clamp(std::ceil(wanted - 1e-9), 1.0, kMost));
    const double from = walk.at;
    for (int k = 1; k <= steps; ++k) {
      walk.at = k == steps ? value : std::lerp(from, value, static_cast<double>(k) / steps);
      Spectrum next = SpectrumOf(At(walk.at));
      const std::vector<Eigen::Index> to = Continuation(walk.spectrum, next);
      for (Eigen::Index& place : walk.place) place = to[static_cast<std::size_t>(place)];
      walk.spectrum = std::move(next);
    }
  }

  const Vehicle& vehicle_;
  std::size_t parameter_;
  /// The file's value.
  double own_;
  CondensedVehicle condensed_;
  std::vector<double> values_;
};

/// "heave" of the mode's pole number i, on or above the real axis.
std::string NameOfPole(const Mode& mode, std::size_t i, bool is_conjugate) {
  if (mode.kind == Mode::Kind::kOverdamped) return mode.name + (i == 0 ? ", slow pole" : ", fast pole");
  return mode.name + (is_conjugate ? ", conjugate pole" : "");
}

std::string NameOf(Complex pole, const std::vector<Mode>& modes) {
  const Complex upper(pole.real(), std::abs(pole.imag()));
  // Rounding of eigenvalues that lie close together.
  double nearest = 1e-4 * std::abs(upper);
  std::string name = "creep";
  for (const Mode& mode : modes) {
    if (mode.kind == Mode::Kind::kFree) continue;
    const std::vector<Complex> own = PolesOf(mode);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (std::abs(own[i] - upper) > nearest) continue;
      nearest = std::abs(own[i] - upper);
      name = NameOfPole(mode, i, pole.imag() < 0);
    }
  }
  return name;
}

void NumberNames(std::vector<PolePath>& paths) {
  std::map<std::string, int> seen;
  for (PolePath& path : paths)
    if (const int count = ++seen[path.mode]; count > 1) path.mode += " " + std::to_string(count);
}

}  // namespace

PolePaths FollowPoles(const Vehicle& vehicle, std::size_t parameter, const std::vector<double>& values) {
  if (values.empty()) throw std::invalid_argument("a path of poles needs a value of its parameter");
  Follower follower(vehicle, parameter);
  const std::vector<Eigen::VectorXcd> poles = follower.Follow(values);
  const Eigen::VectorXcd own = follower.OwnPoles();
  const std::vector<Mode> modes = follower.OwnModes();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  PolePaths out{.parameter = parameter, .values = values};
  for (Eigen::Index i = 0; i < poles.front().size(); ++i) {
    PolePath path{.mode = NameOf(own[i], modes)};
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
  NumberNames(out.paths);
  return out;
}

}  // namespace fourpost
