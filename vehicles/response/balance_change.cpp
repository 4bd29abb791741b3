#include "vehicles/response/balance_change.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <variant>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/response/cycle_transform.h"
#include "vehicles/response/port_newton.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// What the harmonics that are left out may come to together, see Feedback(), per error of the balance: as much as that
/// error leaves in the derivatives.
constexpr double kLeftOut = 25;
constexpr int kLeast = 3;
/// What a matrix of the ports' harmonics may have.
constexpr Eigen::Index kMostUnknowns = 240;

/// Half of that of the slopes by rate; laws of the extension have no bound.
double SlopeRange(const PortLaw& law) {
  const auto* dashpot = std::get_if<DashpotRemainder>(&law);
  return dashpot ? 0.5 * (dashpot->law.GreatestRate() - dashpot->law.LeastRate())
                 : std::numeric_limits<double>::infinity();
}

/// E_h -> direct E_h + conjugate conj(E_h) = R_l, in a matrix on the real, then the imaginary parts of harmonics 0..H.
void PlaceBlock(Complex direct, Complex conjugate, Eigen::Index l, Eigen::Index h, Eigen::MatrixXd& matrix) {
  const Eigen::Index rows = matrix.rows() / 2;
  matrix(l, h) = direct.real() + conjugate.real();
  matrix(l, rows + h) = conjugate.imag() - direct.imag();
  matrix(rows + l, h) = direct.imag() + conjugate.imag();
  matrix(rows + l, rows + h) = direct.real() - conjugate.real();
}

/// Means are real.
void DropImaginaryMeans(Eigen::MatrixXd& matrix) {
  const Eigen::Index rows = matrix.rows() / 2;
  matrix.row(rows).setZero();
  matrix.col(rows).setZero();
}

/// Two-sided harmonic m of a real signal.
Complex TwoSided(const Eigen::MatrixXcd& harmonics, Eigen::Index column, Eigen::Index m) {
  if (m == 0) return harmonics(0, column).real();
  return 0.5 * (m > 0 ? harmonics(m, column) : std::conj(harmonics(-m, column)));
}

/// Of a memoryless law with harmonics 0..2H of its slopes by extension and by rate in columns; see PortCycle.
Eigen::MatrixXd SlopeMatrix(const Eigen::MatrixXcd& slopes, double omega, Eigen::Index rows) {
  Eigen::MatrixXd matrix(2 * rows, 2 * rows);
  for (Eigen::Index l = 0; l < rows; ++l) {
    const double share = l > 0 ? 1 : 0.5;
    PlaceBlock(2 * share * TwoSided(slopes, 0, l), 0, l, 0, matrix);
    for (Eigen::Index h = 1; h < rows; ++h) {
      const Complex iw(0, static_cast<double>(h) * omega);
      PlaceBlock(share * (TwoSided(slopes, 0, l - h) + iw * TwoSided(slopes, 1, l - h)),
                 share * (TwoSided(slopes, 0, l + h) - iw * TwoSided(slopes, 1, l + h)), l, h, matrix);
    }
  }
  DropImaginaryMeans(matrix);
  return matrix;
}

Eigen::MatrixXd SlopeMatrix(const PortCoupling& coupling) {
  const Eigen::Index rows = coupling.direct.rows();
  Eigen::MatrixXd matrix(2 * rows, 2 * rows);
  for (Eigen::Index h = 0; h < rows; ++h)
    for (Eigen::Index l = 0; l < rows; ++l) PlaceBlock(coupling.direct(l, h), coupling.conjugate(l, h), l, h, matrix);
  DropImaginaryMeans(matrix);
  return matrix;
}

bool ChangesSensors(const ModelChange& change) {
  return change.on_position.size() + change.on_velocity.size() + change.on_acceleration.size() +
             change.on_post_height.size() + change.on_post_velocity.size() + change.on_post_acceleration.size() >
         0;
}

}  // namespace

BalanceChange::BalanceChange(LinearisedCycle& cycle, const CondensedModel& model, const std::vector<double>& shape,
                             const std::vector<ModelChange>& changes, double error)
    : cycle_(cycle),
      model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      changes_(changes),
      left_out_(kLeftOut * error) {
  for (std::size_t p = 0; p < changes.size(); ++p)
    for (const ModelChange::Law& law : changes[p].laws) {
      // Of a tyre that is held.
      if (law.port >= static_cast<int>(cycle.ports().size())) continue;
      laws_.push_back({static_cast<Eigen::Index>(p), &law,
                       law.changed ? KinksOf(law.changed->law) : std::vector<PortKink>{}, 1 / changes[p].step});
    }
  directions_.resize(cycle.vehicle().size(), static_cast<Eigen::Index>(cycle.ports().size()));
  for (std::size_t j = 0; j < cycle.ports().size(); ++j)
    directions_.col(static_cast<Eigen::Index>(j)) = cycle.ports()[j].direction;
  slope_range_.resize(directions_.cols());
  for (Eigen::Index j = 0; j < slope_range_.size(); ++j)
    slope_range_[j] = SlopeRange(cycle.ports()[static_cast<std::size_t>(j)].law);
}

void BalanceChange::Find(double amplitude_m) {
  harmonics_ = FindHarmonics();
  const Eigen::MatrixXcd motion = cycle_.Coordinates(harmonics_);
  motion_.real = motion.real().transpose();
  motion_.imag = motion.imag().transpose();
  cycle_.Compliance(harmonics_, compliance_);
  const auto count = static_cast<Eigen::Index>(changes_.size());
  forces_.resize(static_cast<std::size_t>(harmonics_ + 1));
  for (Eigen::MatrixXcd& forces : forces_) forces.setZero(directions_.rows(), count);
  for (Eigen::MatrixXcd& tensions : tensions_) tensions.setZero(directions_.cols(), count);
  AddLinearForces(amplitude_m);
  AddLawForces(amplitude_m);
  FindSlopes();
  if (!active_.empty()) AddSlopeForces();
  FindReadings(amplitude_m);
}

/// As many as its feedback needs.
int BalanceChange::FindHarmonics() const {
  if (cycle_.ports().empty()) return 2;
  const auto ports = static_cast<Eigen::Index>(cycle_.ports().size());
  const int affordable = static_cast<int>(kMostUnknowns / (2 * ports)) - 1;
  int harmonics = std::max(kLeast, std::min(cycle_.cycle().harmonics(), affordable));
  double sum = 0;
  while (harmonics > kLeast && (sum += Feedback(harmonics)) < left_out_) --harmonics;
  return harmonics;
}

/// What comes back to the first harmonic by way of this one, at most: harmonics of a slope that jumps between its
/// bounds fall with 1 / h, and are passed there and back.
double BalanceChange::Feedback(int h) const {
  const Eigen::Index ports = directions_.cols();
  double largest = 0;
  for (Eigen::Index j = 0; j < ports; ++j) {
    const auto through = cycle_.cycle().receptance().row(h).segment(ports * j, ports);
    largest = std::max(largest, slope_range_[j] * slope_range_[j] * through.cwiseAbs2().maxCoeff());
  }
  return std::sqrt(largest) * cycle_.omega() / h;
}

/// - dZ S.
void BalanceChange::AddLinearForces(double amplitude_m) {
  const Eigen::Index rows = harmonics_ + 1;
  const Eigen::Index n = model_.mass.rows();
  const Eigen::RowVectorXd w = cycle_.omega() * Eigen::RowVectorXd::LinSpaced(rows, 0, harmonics_);
  const Parts rate{-motion_.imag * w.asDiagonal(), motion_.real * w.asDiagonal()};
  Eigen::MatrixXd real(directions_.rows(), rows);
  Eigen::MatrixXd imag(directions_.rows(), rows);
  for (std::size_t p = 0; p < changes_.size(); ++p) {
    const ModelChange& change = changes_[p];
    if (change.stiffness.size() + change.damping.size() + change.mass.size() == 0) continue;
    real.setZero();
    imag.setZero();
    if (change.stiffness.size() > 0) {
      real -= change.stiffness.lazyProduct(motion_.real);
      imag -= change.stiffness.lazyProduct(motion_.imag);
    }
    if (change.damping.size() > 0) {
      real -= change.damping.lazyProduct(rate.real);
      imag -= change.damping.lazyProduct(rate.imag);
    }
    if (change.mass.size() > 0) {
      real.topRows(n) += change.mass.lazyProduct(rate.imag.topRows(n)) * w.asDiagonal();
      imag.topRows(n) -= change.mass.lazyProduct(rate.real.topRows(n)) * w.asDiagonal();
    }
    for (Eigen::Index h = 0; h < rows; ++h) {
      auto column = forces_[static_cast<std::size_t>(h)].col(static_cast<Eigen::Index>(p));
      column.real() = real.col(h);
      column.imag() = imag.col(h);
    }
  }
  AddPostForces(amplitude_m);
}

/// dF.
void BalanceChange::AddPostForces(double amplitude_m) {
  const Eigen::Index n = model_.mass.rows();
  for (std::size_t p = 0; p < changes_.size(); ++p) {
    auto column = forces_[1].col(static_cast<Eigen::Index>(p)).head(n);
    if (changes_[p].post_stiffness.size() > 0) column.real() += amplitude_m * (changes_[p].post_stiffness * shape_);
    if (changes_[p].post_damping.size() > 0)
      column.imag() += amplitude_m * cycle_.omega() * (changes_[p].post_damping * shape_);
  }
}

/// - P dR at the same motion.
void BalanceChange::AddLawForces(double amplitude_m) {
  if (laws_.empty()) return;
  const auto samples = cycle_.cycle().samples();
  law_time_.setZero(samples, static_cast<Eigen::Index>(laws_.size()));
  for (std::size_t i = 0; i < laws_.size(); ++i) FindRemainder(laws_[i], amplitude_m, static_cast<Eigen::Index>(i));
  CycleTransform::Shared(harmonics_, static_cast<int>(samples)).ToHarmonics(law_time_, law_harmonics_);
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const ModelChange::Law& law = *laws_[i].law;
    Eigen::VectorXcd tension = law_harmonics_.col(static_cast<Eigen::Index>(i));
    const Port& port = law.changed ? *law.changed : cycle_.ports()[static_cast<std::size_t>(law.port)];
    if (HasMemory(port.law) && law.port >= 0) {
      tension = -cycle_.cycle().remainder().col(law.port).head(tension.size());
      if (law.changed) tension += cycle_.cycle().RemainderOf(port.law, law.port).head(tension.size());
    }
    for (Eigen::Index h = 0; h <= harmonics_; ++h)
      AddTension(h, port.direction, law.port, laws_[i].change, laws_[i].per_step * tension[h]);
  }
}

void BalanceChange::AddTension(Eigen::Index h, const Eigen::VectorXd& direction, int port, Eigen::Index change,
                               Complex tension) {
  forces_[static_cast<std::size_t>(h)].col(change) -= tension * direction;
  if (h < 3 && port >= 0) tensions_[static_cast<std::size_t>(h)](port, change) += tension;
}

/// How far the changed law departs from the cycle's remainder; of a port of the cycle only where it has no memory.
void BalanceChange::FindRemainder(const LawChange& law, double amplitude_m, Eigen::Index column) {
  const PortCycle& cycle = cycle_.cycle();
  const std::optional<Port>& changed = law.law->changed;
  const Eigen::Index port = law.law->port;
  if (port >= 0 && HasMemory(cycle.ports()[static_cast<std::size_t>(port)].law)) return;
  if (port >= 0) {
    if (changed)
      MendedRemainders(changed->law, law.kinks, Samples(cycle.extension_time(), port), Samples(cycle.rate_time(), port),
                       Room(law_time_, column));
    law_time_.col(column) -= cycle.remainder_time().col(port);
    return;
  }
  Eigen::MatrixXcd extension = cycle_.Coordinates(cycle.harmonics()) * changed->direction;
  if (changed->post >= 0) extension(1, 0) += amplitude_m * shape_[changed->post];
  const Eigen::VectorXcd w =
      Complex(0, cycle_.omega()) * Eigen::VectorXd::LinSpaced(extension.rows(), 0, cycle.harmonics());
  const CycleTransform& transform = CycleTransform::Shared(cycle.harmonics(), static_cast<int>(law_time_.rows()));
  Eigen::MatrixXd extension_time;
  Eigen::MatrixXd rate_time;
  transform.ToTime(extension, extension_time);
  transform.ToTime(w.asDiagonal() * extension, rate_time);
  // Of laws with memory friction alone may be added: a hydraulic damper adds a coordinate.
  if (HasMemory(changed->law))
    CycleRemainders(changed->law, cycle.Period(), Samples(extension_time, 0), Samples(rate_time, 0),
                    Room(law_time_, column));
  else
    MendedRemainders(changed->law, law.kinks, Samples(extension_time, 0), Samples(rate_time, 0),
                     Room(law_time_, column));
}

void BalanceChange::FindSlopes() {
  active_.clear();
  slopes_.clear();
  const PortCycle& cycle = cycle_.cycle();
  Eigen::MatrixXd slopes(cycle.samples(), 2);
  Eigen::MatrixXcd harmonics;
  for (std::size_t j = 0; j < cycle_.ports().size(); ++j) {
    const auto port = static_cast<Eigen::Index>(j);
    const PortLaw& law = cycle_.ports()[j].law;
    if (HasMemory(law)) {
      active_.push_back(port);
      slopes_.push_back(SlopeMatrix(CycleCoupling(cycle, law, port, harmonics_ + 1)));
      continue;
    }
    MendedSlopes(law, cycle.kinks(port), Samples(cycle.extension_time(), port), Samples(cycle.rate_time(), port),
                 Room(slopes, 0), Room(slopes, 1));
    if (slopes.isZero(0)) continue;
    CycleTransform::Shared(2 * harmonics_, static_cast<int>(slopes.rows())).ToHarmonics(slopes, harmonics);
    active_.push_back(port);
    slopes_.push_back(SlopeMatrix(harmonics, cycle_.omega(), harmonics_ + 1));
  }
}

/// - P T de: from de - A T de = P' Z^-1 (the other forces), A = - P' Z^-1 P.
void BalanceChange::AddSlopeForces() {
  const Eigen::Index rows = harmonics_ + 1;
  const Eigen::Index unknowns = 2 * rows;
  const auto active = static_cast<Eigen::Index>(active_.size());
  const Eigen::Index ports = directions_.cols();
  const Eigen::MatrixXcd& receptance = cycle_.cycle().receptance();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(active * unknowns, active * unknowns);
  Eigen::MatrixXd free(active * unknowns, static_cast<Eigen::Index>(changes_.size()));
  for (Eigen::Index q = 0; q < active; ++q) {
    const Eigen::MatrixXd& slopes = slopes_[static_cast<std::size_t>(q)];
    const auto real = slopes.topRows(rows);
    const auto imag = slopes.bottomRows(rows);
    for (Eigen::Index p = 0; p < active; ++p) {
      const auto through =
          receptance.col(active_[static_cast<std::size_t>(p)] + ports * active_[static_cast<std::size_t>(q)])
              .head(rows);
      auto block = matrix.block(p * unknowns, q * unknowns, unknowns, unknowns);
      block.topRows(rows) -= through.real().asDiagonal() * real;
      block.topRows(rows) += through.imag().asDiagonal() * imag;
      block.bottomRows(rows) -= through.real().asDiagonal() * imag;
      block.bottomRows(rows) -= through.imag().asDiagonal() * real;
    }
  }
  const Eigen::MatrixXcd across = directions_(Eigen::all, active_).transpose();
  for (Eigen::Index h = 0; h < rows; ++h) {
    const Eigen::MatrixXcd extension =
        (across * ComplianceOf(h)).eval().lazyProduct(forces_[static_cast<std::size_t>(h)]);
    for (Eigen::Index p = 0; p < active; ++p) {
      free.row(p * unknowns + h) = extension.row(p).real();
      free.row(p * unknowns + rows + h) = extension.row(p).imag();
    }
  }
  const Eigen::MatrixXd changes = Solved(matrix, free);
  for (Eigen::Index q = 0; q < active; ++q) {
    const Eigen::Index port = active_[static_cast<std::size_t>(q)];
    Eigen::MatrixXd slopes(6, unknowns);
    slopes << slopes_[static_cast<std::size_t>(q)].topRows(3), slopes_[static_cast<std::size_t>(q)].middleRows(rows, 3);
    const Eigen::MatrixXd tensions = slopes.lazyProduct(changes.middleRows(q * unknowns, unknowns));
    for (Eigen::Index h = 0; h < 3; ++h) {
      Eigen::RowVectorXcd tension(changes_.size());
      tension.real() = tensions.row(h);
      tension.imag() = tensions.row(3 + h);
      forces_[static_cast<std::size_t>(h)].noalias() -= directions_.col(port) * tension;
      tensions_[static_cast<std::size_t>(h)].row(port) += tension;
    }
  }
}

Eigen::MatrixXcd BalanceChange::ComplianceOf(Eigen::Index h) const {
  return compliance_.row(h).reshaped(directions_.rows(), directions_.rows());
}

/// dy = rows dS + drows S; see LinearisedCycle::Readings.
void BalanceChange::FindReadings(double amplitude_m) {
  const Eigen::Index n = model_.mass.rows();
  for (std::size_t h = 0; h < 3; ++h) {
    const auto column = static_cast<Eigen::Index>(h);
    const double w = static_cast<double>(h) * cycle_.omega();
    const double amplitude = h == 1 ? amplitude_m : 0;
    const Eigen::MatrixXcd motion = ComplianceOf(column).topRows(n).lazyProduct(forces_[h]);
    const Eigen::MatrixXd real = motion.real();
    const Eigen::MatrixXd imag = motion.imag();
    const Eigen::MatrixXd rows = model_.on_position - w * w * model_.on_acceleration;
    Eigen::MatrixXcd& readings = readings_[h];
    readings.resize(rows.rows(), motion.cols());
    readings.real() = rows.lazyProduct(real) - w * model_.on_velocity.lazyProduct(imag);
    readings.imag() = rows.lazyProduct(imag) + w * model_.on_velocity.lazyProduct(real);
    const Eigen::VectorXd s_real = motion_.real.col(column).head(n);
    const Eigen::VectorXd s_imag = motion_.imag.col(column).head(n);
    for (std::size_t p = 0; p < changes_.size(); ++p) {
      const ModelChange& change = changes_[p];
      if (!ChangesSensors(change)) continue;
      auto reading = readings.col(static_cast<Eigen::Index>(p));
      const auto add = [&](const Eigen::MatrixXd& by_motion, const Eigen::MatrixXd& by_post, Complex factor) {
        if (by_motion.size() > 0) reading += factor * (by_motion * s_real + Complex(0, 1) * (by_motion * s_imag));
        if (by_post.size() > 0 && amplitude > 0) reading += factor * amplitude * (by_post * shape_);
      };
      add(change.on_position, change.on_post_height, 1);
      add(change.on_velocity, change.on_post_velocity, Complex(0, w));
      add(change.on_acceleration, change.on_post_acceleration, -w * w);
    }
    for (std::size_t j = 0; j < cycle_.ports().size(); ++j)
      for (const int sensor : cycle_.ports()[j].load_cells)
        readings.row(sensor) += tensions_[h].row(static_cast<Eigen::Index>(j));
  }
}

SensorHarmonics BalanceChange::Sensors(std::size_t change) const {
  SensorHarmonics sensors(readings_[0].rows(), 3);
  for (std::size_t h = 0; h < 3; ++h)
    sensors.col(static_cast<Eigen::Index>(h)) = readings_[h].col(static_cast<Eigen::Index>(change));
  return sensors;
}

}  // namespace fourpost
