#include "identify/missing_force/weighed_forces.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Kind = ForceMechanism::Kind;

/// Of the fall of squares, for each number that is chosen beside the amount.
constexpr double kPerNumber = 9;

Eigen::VectorXd Stacked(const Eigen::VectorXcd& force) {
  Eigen::VectorXd all(2 * force.size());
  all << force.real(), force.imag();
  return all;
}

/// To the motion that the force stands for, over its standard deviations.
Eigen::MatrixXd WeightOf(const ForceSample& sample) {
  const Eigen::Index n = sample.motion.size();
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(MotionCovariance(sample));
  const Eigen::MatrixXd root =
      pairs.vectors * pairs.values.cwiseInverse().cwiseSqrt().asDiagonal() * pairs.vectors.transpose();
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  both.topLeftCorner(n, n) = root;
  both.bottomRightCorner(n, n) = root;
  return both * LeastNorm(sample.slope).PseudoInverse();
}

/// What the force of a mechanism in the model's own motion needs.
ForceSample OwnOf(const ForceSample& sample) {
  return {.run = sample.run,
          .frequency_Hz = sample.frequency_Hz,
          .amplitude_m = sample.amplitude_m,
          .motion = sample.modelled,
          .overtones = sample.overtones,
          .posts = sample.posts};
}

/// Sum of squares of the force of these amplitudes; `squares` as in Place.
double SquaresOf(const std::vector<Eigen::MatrixXd>& squares, const Eigen::VectorXd& amplitudes) {
  double sum = 0;
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& square : squares) {
    const auto own = amplitudes.segment(next, square.rows());
    sum += own.dot(square * own);
    next += square.rows();
  }
  return sum;
}

}  // namespace

WeighedForces::WeighedForces(const ForceRecord& record) : record_(record) {
  Eigen::Index rows = 0;
  for (const ForceSample& sample : record.samples) rows += 2 * sample.motion.size();
  rest_.resize(rows);
  Eigen::MatrixXd nuisances(rows, record.samples.empty() ? 0 : record.samples.front().nuisance.cols());
  Eigen::Index next = 0;
  for (const ForceSample& sample : record.samples) {
    own_.push_back(OwnOf(sample));
    weights_.push_back(WeightOf(sample));
    const Eigen::Index count = weights_.back().rows();
    rest_.segment(next, count) = weights_.back() * Stacked(sample.force);
    nuisances.middleRows(next, count) = weights_.back() * sample.nuisance;
    degrees_ += 2 * (MotionCovariance(sample) * sample.information).trace();
    next += count;
  }
  FindFree();
  // C^-1 = I - B B' with B = N (I + N' N)^-1/2.
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(nuisances.transpose() * nuisances);
  const Eigen::VectorXd roots = (1 + pairs.values.array().max(0)).rsqrt();
  shared_ = nuisances * (pairs.vectors * roots.asDiagonal());
  degrees_ -= shared_.squaredNorm();
  whole_ = rest_;
}

/// Orthonormal columns: all that changes of free parameters do to the force in the model's own motion.
void WeighedForces::FindFree() {
  const auto parameters = [](const ForceSample& sample) { return sample.by_parameters.cols(); };
  Eigen::Index count = 0;
  for (const ForceSample& sample : record_.samples) count = std::max(count, parameters(sample));
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(rest_.size(), count);
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const ForceSample& sample = record_.samples[i];
    if (parameters(sample) > 0) changes.middleRows(next, weights_[i].rows()) = weights_[i] * sample.by_parameters;
    next += weights_[i].rows();
  }
  for (auto change : changes.colwise())
    if (change.norm() > 0) change.normalize();
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(changes.transpose() * changes);
  constexpr double kNothing = 1e-10;
  const Eigen::Index kept = (pairs.values.array() > kNothing).count();
  free_ = changes * pairs.vectors.rightCols(kept) * pairs.values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

WeighedForces::Place& WeighedForces::PlaceOf(const ForceMechanism& mechanism) {
  const PlaceKey key{mechanism.kind == Kind::kPartOnMounts, mechanism.kind == Kind::kAddedMass, mechanism.lines,
                     mechanism.link};
  const auto [found, is_new] = places_.try_emplace(key);
  Place& place = found->second;
  if (!is_new) return place;
  const Eigen::MatrixXd directions = ForceDirections(mechanism, record_);
  const Eigen::Index n = directions.rows();
  const Eigen::Index k = directions.cols();
  const Eigen::Index all = 2 * k * std::ssize(weights_);
  place.shared.resize(shared_.cols(), all);
  place.free.resize(free_.cols(), all);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Eigen::MatrixXd& weight = weights_[i];
    Eigen::MatrixXd columns(weight.rows(), 2 * k);
    columns << weight.leftCols(n) * directions, weight.rightCols(n) * directions;
    const auto first = 2 * k * static_cast<Eigen::Index>(i);
    place.shared.middleCols(first, 2 * k) = shared_.middleRows(row, weight.rows()).transpose() * columns;
    place.free.middleCols(first, 2 * k) = free_.middleRows(row, weight.rows()).transpose() * columns;
    place.squares.push_back(columns.transpose() * columns);
    place.columns.push_back(std::move(columns));
    row += weight.rows();
  }
  for (const Eigen::VectorXd& direction : directions_) place.along.push_back(ProductsWith(place, direction));
  place.rest = ProductsWith(place, rest_);
  return place;
}

Eigen::VectorXd WeighedForces::Amplitudes(const ForceMechanism& mechanism,
                                          const std::vector<ForceSample>& samples) const {
  Eigen::VectorXd all;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // The model may have no motion there.
    if (samples[i].motion.size() == 0) continue;
    const Eigen::VectorXd amplitudes = Stacked(ForceAmplitudes(mechanism, record_, samples[i]));
    if (all.size() == 0) all.setZero(amplitudes.size() * std::ssize(samples));
    all.segment(amplitudes.size() * static_cast<Eigen::Index>(i), amplitudes.size()) = amplitudes;
  }
  return all;
}

/// The force of these amplitudes, over its noise.
Eigen::VectorXd WeighedForces::Times(const Place& place, const Eigen::VectorXd& amplitudes) const {
  Eigen::VectorXd all(rest_.size());
  Eigen::Index row = 0;
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& columns : place.columns) {
    all.segment(row, columns.rows()) = columns * amplitudes.segment(next, columns.cols());
    row += columns.rows();
    next += columns.cols();
  }
  return all;
}

Eigen::VectorXd WeighedForces::Weighed(const ForceMechanism& mechanism) {
  return Times(PlaceOf(mechanism), Amplitudes(mechanism, record_.samples));
}

Eigen::VectorXd WeighedForces::ProductsWith(const Place& place, const Eigen::VectorXd& weighed) const {
  const Eigen::VectorXd inverse = LessShared(weighed);
  Eigen::VectorXd products(place.shared.cols());
  Eigen::Index row = 0;
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& columns : place.columns) {
    products.segment(next, columns.cols()) = columns.transpose() * inverse.segment(row, columns.rows());
    row += columns.rows();
    next += columns.cols();
  }
  return products;
}

bool WeighedForces::IsFree(const ForceMechanism& mechanism) {
  constexpr double kOwn = 1e-4;
  const Place& place = PlaceOf(mechanism);
  const Eigen::VectorXd amplitudes = Amplitudes(mechanism, own_);
  if (amplitudes.size() == 0) return true;
  const double squares = SquaresOf(place.squares, amplitudes);
  return squares - (place.free * amplitudes).squaredNorm() <= kOwn * squares;
}

TriedForce WeighedForces::Try(const ForceMechanism& mechanism) {
  const Place& place = PlaceOf(mechanism);
  const Eigen::VectorXd amplitudes = Amplitudes(mechanism, record_.samples);
  TriedForce tried{.mechanism = mechanism};
  const double whole = SquaresOf(place.squares, amplitudes) - (place.shared * amplitudes).squaredNorm();
  tried.information = whole;
  for (const Eigen::VectorXd& taken : place.along) tried.information -= std::pow(amplitudes.dot(taken), 2);
  // What rounding leaves of one that others can stand for.
  constexpr double kNothing = 1e-9;
  if (!(tried.information > kNothing * whole)) return tried;
  const double gradient = amplitudes.dot(place.rest);
  tried.amount = gradient / tried.information;
  if (!mechanism.Allows(tried.amount, record_)) return tried;
  tried.fall = gradient * tried.amount - kPerNumber * mechanism.ShapeNumbers();
  return tried;
}

void WeighedForces::TakeOut(const ForceMechanism& mechanism) {
  forces_.push_back(Weighed(mechanism));
  Eigen::VectorXd direction = forces_.back();
  for (const Eigen::VectorXd& taken : directions_) direction -= Product(direction, taken) * taken;
  direction /= std::sqrt(Product(direction, direction));
  rest_ -= Product(direction, rest_) * direction;
  for (auto& [key, place] : places_) {
    place.along.push_back(ProductsWith(place, direction));
    place.rest = ProductsWith(place, rest_);
  }
  directions_.push_back(std::move(direction));
}

std::pair<Eigen::VectorXd, Eigen::MatrixXd> WeighedForces::Amounts() const {
  const auto count = static_cast<Eigen::Index>(forces_.size());
  Eigen::MatrixXd products(count, count);
  Eigen::VectorXd gradient(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    gradient[i] = Product(forces_[static_cast<std::size_t>(i)], whole_);
    for (Eigen::Index j = 0; j < count; ++j)
      products(i, j) = Product(forces_[static_cast<std::size_t>(i)], forces_[static_cast<std::size_t>(j)]);
  }
  const Eigen::MatrixXd covariance = Solved(products, Eigen::MatrixXd(Eigen::MatrixXd::Identity(count, count)));
  return {covariance * gradient, covariance};
}

double WeighedForces::Correlated(const TriedForce& tried) {
  const Eigen::VectorXd rest = LessShared(rest_ - tried.amount * Weighed(tried.mechanism));
  double products = 0;
  double squares = 0;
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Eigen::Index count = weights_[i].rows();
    squares += rest.segment(next, count).squaredNorm();
    if (i + 1 < weights_.size() && record_.samples[i].run == record_.samples[i + 1].run)
      products += rest.segment(next, count).dot(rest.segment(next + count, count));
    next += count;
  }
  constexpr double kMost = 0.95;
  const double correlation = squares > 0 ? std::clamp(products / squares, 0.0, kMost) : 0;
  return (1 + correlation) / (1 - correlation);
}

std::vector<double> WeighedForces::FallBySample(const TriedForce& tried) {
  const Eigen::VectorXd force = tried.amount * Weighed(tried.mechanism);
  const Eigen::VectorXd inverse = LessShared(force);
  const Eigen::VectorXd of_rest = LessShared(rest_);
  std::vector<double> falls;
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& weight : weights_) {
    const Eigen::Index count = weight.rows();
    falls.push_back(2 * force.segment(next, count).dot(of_rest.segment(next, count)) -
                    force.segment(next, count).dot(inverse.segment(next, count)));
    next += count;
  }
  return falls;
}

std::vector<double> WeighedForces::SquaresBySample() const {
  const Eigen::VectorXd inverse = LessShared(rest_);
  std::vector<double> squares;
  Eigen::Index next = 0;
  for (const Eigen::MatrixXd& weight : weights_) {
    squares.push_back(rest_.segment(next, weight.rows()).dot(inverse.segment(next, weight.rows())));
    next += weight.rows();
  }
  return squares;
}

double WeighedForces::Product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  return a.dot(b) - (shared_.transpose() * a).dot(shared_.transpose() * b);
}

Eigen::VectorXd WeighedForces::LessShared(const Eigen::VectorXd& a) const {
  return a - shared_ * (shared_.transpose() * a);
}

}  // namespace fourpost
