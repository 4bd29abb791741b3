#include "vehicles/condensed/receptance.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

Eigen::MatrixXd Directions(const std::vector<Port>& ports, Eigen::Index size) {
  Eigen::MatrixXd directions(size, static_cast<Eigen::Index>(ports.size()));
  for (std::size_t j = 0; j < ports.size(); ++j) directions.col(static_cast<Eigen::Index>(j)) = ports[j].direction;
  return directions;
}

/// Of [s, s', x], such that each moved by its own one holds about the same energy: lengths, angles and rates compare,
/// which rounding of poles needs.
Eigen::VectorXd StateUnits(const LinearVehicle& vehicle) {
  const Eigen::Index n = vehicle.mass.rows();
  const Eigen::ArrayXd masses = vehicle.mass.diagonal();
  const double fastest = std::sqrt((vehicle.stiffness.diagonal().head(n).array() / masses).abs().maxCoeff());
  Eigen::VectorXd units(2 * n + vehicle.series());
  units << masses.rsqrt() / (fastest > 0 ? fastest : 1), masses.rsqrt(),
      vehicle.stiffness.diagonal().tail(vehicle.series()).array().rsqrt();
  return units;
}

/// Without the care for overflow that makes the library's division slow.
Complex Inverse(Complex z) { return std::conj(z) * (1 / std::norm(z)); }

/// See Poles: weight of a pole, or of a pair.
Complex PoleWeight(Complex pole, double omega) {
  if (pole.imag() == 0) return Inverse({-pole.real(), omega});
  return Inverse({std::norm(pole) - omega * omega, -2 * omega * pole.real()});
}

/// See Poles.
struct RealResidue {
  RealResidue(Complex pole, Complex residue)
      : alpha(pole.imag() == 0 ? 0 : 2 * residue.real()),
        beta(pole.imag() == 0 ? residue.real() : -2 * (residue * std::conj(pole)).real()) {}
  double alpha;
  double beta;
};

}  // namespace

Receptance::Receptance(const CondensedModel& model, const std::vector<Port>& ports, const std::vector<double>& shape,
                       Coordinates coordinates)
    : vehicle_(model, LinearVehicle::Rates::kCentre),
      coordinates_(coordinates),
      directions_(Directions(ports, vehicle_.size())) {
  const Eigen::Map<const Eigen::VectorXd> posts(shape.data(), static_cast<Eigen::Index>(shape.size()));
  const Eigen::Index n = vehicle_.mass.rows();
  const Eigen::Index count = directions_.cols();
  forces_ = Eigen::MatrixXd::Zero(vehicle_.size(), count + 2);
  forces_.leftCols(count) = -directions_;
  forces_.col(count).head(n) = model.post_stiffness * posts;
  forces_.col(count + 1).head(n) = model.post_damping * posts;
  post_share_ = Eigen::VectorXd::Zero(count);
  for (Eigen::Index j = 0; j < count; ++j)
    if (const int post = ports[static_cast<std::size_t>(j)].post; post >= 0) post_share_[j] = posts[post];
  if (coordinates == Coordinates::kFree) poles_ = FindPoles();
}

std::optional<Receptance::Poles> Receptance::FindPoles() const {
  const Eigen::VectorXd units = StateUnits(vehicle_);
  const Eigen::VectorXd inverse = units.cwiseInverse();
  const Eigenpairs pairs = EigenpairsOf(inverse.asDiagonal() * vehicle_.StateMatrix() * units.asDiagonal());
  if (!pairs.converged) return {};
  const Eigen::MatrixXcd& scaled = pairs.vectors;
  const Eigen::MatrixXcd inputs =
      Solved(scaled, (inverse.asDiagonal() * vehicle_.StateInput(forces_)).cast<Complex>().eval());
  if (!inputs.allFinite()) return {};
  const Eigen::MatrixXcd vectors = units.asDiagonal() * scaled;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < vectors.cols(); ++k)
    if (pairs.values[k].imag() >= 0) kept.push_back(k);
  const Eigen::Index n = vehicle_.mass.rows();
  Poles poles;
  poles.values = pairs.values(kept);
  poles.inputs = inputs(kept, Eigen::all);
  poles.input_sizes = poles.inputs.leftCols(directions_.cols()).cwiseAbs();
  poles.shapes.resize(vehicle_.size(), static_cast<Eigen::Index>(kept.size()));
  poles.shapes << vectors.topRows(n)(Eigen::all, kept), vectors.bottomRows(vehicle_.series())(Eigen::all, kept);
  poles.residues = ResiduesOf(poles, directions_.transpose() * poles.shapes, directions_.cols());
  poles.motion_residues = ResiduesOf(poles, poles.shapes, forces_.cols());
  if (!Reproduces(poles)) return {};
  return poles;
}

/// Of the rows of `shapes` by the first inputs: row i by input j in column i + rows j.
Eigen::MatrixXd Receptance::ResiduesOf(const Poles& poles, const Eigen::MatrixXcd& shapes, Eigen::Index inputs) {
  const Eigen::Index n = poles.values.size();
  Eigen::MatrixXd residues(2 * n, shapes.rows() * inputs);
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index j = 0; j < inputs; ++j)
      for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
        const RealResidue residue(poles.values[k], shapes(i, k) * poles.inputs(k, j));
        residues(k, i + shapes.rows() * j) = residue.alpha;
        residues(n + k, i + shapes.rows() * j) = residue.beta;
      }
  return residues;
}

/// Whether Z times the motion by poles gives the forces back, over the frequencies of a rig and its harmonics.
bool Receptance::Reproduces(const Poles& poles) const {
  // Well-separated poles leave some 1e-13, and the promise of linear models is 1e-9.
  constexpr double kLargest = 1e-10;
  for (const double frequency_Hz : {0.5, 5.0, 50.0}) {
    const double omega = 2 * std::numbers::pi * frequency_Hz;
    const Eigen::MatrixXcd impedance = vehicle_.Impedance(omega);
    for (Eigen::Index j = 0; j < forces_.cols(); ++j) {
      const Eigen::VectorXcd motion = SumOverPoles(poles, omega, Eigen::VectorXcd::Unit(forces_.cols(), j));
      const Eigen::VectorXcd left = impedance * motion - forces_.col(j);
      const double scale = (impedance.cwiseAbs() * motion.cwiseAbs()).maxCoeff();
      if (!(left.cwiseAbs().maxCoeff() <= kLargest * scale)) return false;
    }
  }
  return true;
}

void Receptance::Ports(double omega, int harmonics, Eigen::MatrixXcd& receptance) const {
  const Eigen::Index count = directions_.cols();
  receptance.resize(harmonics + 1, count * count);
  if (coordinates_ == Coordinates::kHeld) return HeldPorts(omega, receptance);
  if (!poles_) {
    for (int h = 0; h <= harmonics; ++h) {
      const Eigen::MatrixXcd across =
          -directions_.transpose() * Solved(vehicle_.Impedance(h * omega), directions_.cast<Complex>().eval());
      receptance.row(h) = across.reshaped().transpose();
    }
    return;
  }
  SumResidues(omega, 0, harmonics, poles_->residues, receptance);
}

/// The block of series springs is diagonal: each has its dashpot.
void Receptance::HeldPorts(double omega, Eigen::MatrixXcd& receptance) const {
  const Eigen::Index series = vehicle_.series();
  const Eigen::MatrixXd on_series = directions_.bottomRows(series);
  for (Eigen::Index h = 0; h < receptance.rows(); ++h) {
    Eigen::VectorXcd impedance(series);
    impedance.real() = vehicle_.stiffness.diagonal().tail(series);
    impedance.imag() = static_cast<double>(h) * omega * vehicle_.damping.diagonal().tail(series);
    const Eigen::MatrixXcd across = -(on_series.transpose() * impedance.cwiseInverse().asDiagonal() * on_series);
    receptance.row(h) = across.reshaped().transpose();
  }
}

void Receptance::SumResidues(double omega, int first, int last, const Eigen::MatrixXd& residues,
                             Eigen::MatrixXcd& sum) const {
  const Eigen::Index n = poles_->values.size();
  const Eigen::Index rows = last - first + 1;
  sum.resize(rows, residues.cols());
  // Real parts above, imaginary ones below.
  Eigen::MatrixXd weights(2 * rows, 2 * n);
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double w = static_cast<double>(first + i) * omega;
      const Complex weight = PoleWeight(poles_->values[k], w);
      weights(i, k) = -w * weight.imag();
      weights(rows + i, k) = w * weight.real();
      weights(i, n + k) = weight.real();
      weights(rows + i, n + k) = weight.imag();
    }
  // Eigen's blocked product is slower than plain sums for so few numbers.
  if (residues.size() < 512) {
    sum.real() = weights.topRows(rows).lazyProduct(residues);
    sum.imag() = weights.bottomRows(rows).lazyProduct(residues);
    return;
  }
  sum.real().noalias() = weights.topRows(rows) * residues;
  sum.imag().noalias() = weights.bottomRows(rows) * residues;
}

void Receptance::Compliance(double omega, int harmonics, Eigen::MatrixXcd& compliance) {
  if (!compliance_residues_) {
    compliance_residues_ = ComplianceResidues();
    if (!Inverts(*compliance_residues_)) compliance_residues_->resize(0, 0);
  }
  if (compliance_residues_->size() > 0) return SumResidues(omega, 0, harmonics, *compliance_residues_, compliance);
  compliance.resize(harmonics + 1, size() * size());
  for (int h = 0; h <= harmonics; ++h)
    compliance.row(h) = vehicle_.Impedance(h * omega).inverse().eval().reshaped().transpose();
}

/// Of a symmetric Z with single poles Z^-1 = sum over poles of u u' / (u' dZ/dl u (i w - l)).
Eigen::MatrixXd Receptance::ComplianceResidues() const {
  if (!poles_) return {};
  const Eigen::Index n = poles_->values.size();
  const Eigen::Index masses = vehicle_.mass.rows();
  Eigen::MatrixXd residues(2 * n, size() * size());
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXcd u = poles_->shapes.col(k);
    Eigen::VectorXcd slope = vehicle_.damping * u;
    slope.head(masses) += 2.0 * poles_->values[k] * (vehicle_.mass * u.head(masses));
    const Complex scale = 1.0 / (u.transpose() * slope).value();
    for (Eigen::Index j = 0; j < size(); ++j)
      for (Eigen::Index i = 0; i < size(); ++i) {
        const RealResidue residue(poles_->values[k], scale * u[i] * u[j]);
        residues(k, i + size() * j) = residue.alpha;
        residues(n + k, i + size() * j) = residue.beta;
      }
  }
  return residues;
}

/// Equal poles need not have the shapes that the residues take for granted.
bool Receptance::Inverts(const Eigen::MatrixXd& residues) const {
  // As Reproduces().
  constexpr double kLargest = 1e-10;
  if (residues.size() == 0) return false;
  Eigen::MatrixXcd rows;
  for (const double frequency_Hz : {0.5, 5.0, 50.0}) {
    const double omega = 2 * std::numbers::pi * frequency_Hz;
    SumResidues(omega, 1, 1, residues, rows);
    const Eigen::MatrixXcd compliance = rows.row(0).reshaped(size(), size());
    const Eigen::MatrixXcd impedance = vehicle_.Impedance(omega);
    const Eigen::MatrixXd scale = impedance.cwiseAbs() * compliance.cwiseAbs();
    const Eigen::MatrixXd left = (impedance * compliance - Eigen::MatrixXcd::Identity(size(), size())).cwiseAbs();
    if (!(left.array() <= kLargest * scale.maxCoeff()).all()) return false;
  }
  return true;
}

Eigen::MatrixXcd Receptance::UnitMotions(double omega) const {
  const Eigen::Index count = directions_.cols();
  Eigen::MatrixXcd motions;
  if (poles_) {
    Eigen::MatrixXcd row;
    SumResidues(omega, 1, 1, poles_->motion_residues, row);
    motions = row.row(0).reshaped(size(), count + 2);
  } else {
    motions = Solved(vehicle_.Impedance(omega), forces_.cast<Complex>().eval());
  }
  // Posts act by height and velocity.
  motions.col(count) += Complex(0, omega) * motions.col(count + 1);
  motions.conservativeResize(Eigen::NoChange, count + 1);
  return motions;
}

Eigen::MatrixXd Receptance::ModalSizes(const Eigen::MatrixXd& rows) const {
  return (rows.cast<Complex>() * poles_->shapes).cwiseAbs();
}

/// Harmonic by harmonic up to the eighth; of the others by the nearest that i w may come to a pole l from W on,
///   |i w - l| >= W - |l|, or |Re l| where W < |l|,   w / |i w - l| <= W / (W - |l|), or |l| / |Re l|
/// and |i w - conj l| >= |l|, w / |i w - conj l| <= 1 of the other one of a pair.
Eigen::MatrixX2d Receptance::ModalReach(double omega, const Eigen::MatrixXd& sizes) const {
  constexpr Eigen::Index kSingle = 8;
  const Eigen::Index last = std::min(kSingle, sizes.rows() - 1);
  const Eigen::Index rest = sizes.rows() - 1 - last;
  Eigen::MatrixXd forces(last, sizes.cols());
  forces << sizes.middleRows(2, last - 1), sizes.bottomRows(rest).colwise().sum();
  const Eigen::MatrixXd modal = forces.lazyProduct(poles_->input_sizes.transpose());
  const double beyond = static_cast<double>(last + 1) * omega;
  Eigen::MatrixX2d reach(pole_count(), 2);
  for (Eigen::Index k = 0; k < pole_count(); ++k) {
    const Complex pole = poles_->values[k];
    const double size = std::abs(pole);
    const bool is_pair = pole.imag() != 0;
    const bool is_below = size < beyond;
    const double nearest = is_below ? beyond - size : std::abs(pole.real());
    const double tail = modal(last - 1, k);
    reach(k, 0) = tail * (1 / nearest + (is_pair ? 1 / size : 0));
    reach(k, 1) = tail * ((is_below ? beyond : size) / nearest + (is_pair ? 1 : 0));
    for (Eigen::Index h = 2; h <= last; ++h) {
      const double w = static_cast<double>(h) * omega;
      double weight = 1 / std::sqrt(std::norm(Complex(0, w) - pole));
      if (is_pair) weight += 1 / std::sqrt(std::norm(Complex(0, w) - std::conj(pole)));
      reach(k, 0) += weight * modal(h - 2, k);
      reach(k, 1) += w * weight * modal(h - 2, k);
    }
  }
  return reach;
}

Eigen::VectorXcd Receptance::Driven(const Eigen::VectorXcd& motion) const {
  return directions_.transpose() * motion + post_share_;
}

Eigen::VectorXcd Receptance::Inputs(double omega, const Eigen::VectorXcd& tensions, double post_amplitude) const {
  Eigen::VectorXcd inputs(tensions.size() + 2);
  inputs << tensions, post_amplitude, Complex(0, omega * post_amplitude);
  return inputs;
}

Eigen::VectorXcd Receptance::SumOverPoles(const Poles& poles, double omega, const Eigen::VectorXcd& inputs) {
  const Complex iw(0, omega);
  // Of real inputs a pair's two amplitudes would be conjugate; of complex ones the other is that of the conjugates.
  Eigen::VectorXcd amplitudes = poles.inputs * inputs;
  Eigen::VectorXcd conjugates = poles.inputs.conjugate() * inputs;
  for (Eigen::Index k = 0; k < poles.values.size(); ++k) {
    amplitudes[k] *= Inverse(iw - poles.values[k]);
    conjugates[k] *= poles.values[k].imag() == 0 ? 0.0 : Inverse(iw - std::conj(poles.values[k]));
  }
  return poles.shapes * amplitudes + poles.shapes.conjugate() * conjugates;
}

Eigen::MatrixXcd Receptance::MotionBy(double omega, const Eigen::MatrixXcd& forces) const {
  Eigen::MatrixXcd motion(forces.rows(), forces.cols());
  for (Eigen::Index h = 0; h < forces.rows(); ++h)
    motion.row(h) =
        Solved(vehicle_.Impedance(static_cast<double>(h) * omega), Eigen::VectorXcd(forces.row(h).transpose()))
            .transpose();
  return motion;
}

Eigen::VectorXcd Receptance::Motion(double omega, const Eigen::VectorXcd& tensions, double post_amplitude) const {
  const Eigen::VectorXcd inputs = Inputs(omega, tensions, post_amplitude);
  if (poles_) return SumOverPoles(*poles_, omega, inputs);
  return Solved(vehicle_.Impedance(omega), Eigen::VectorXcd(forces_ * inputs));
}

}  // namespace fourpost
