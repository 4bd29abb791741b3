#include "identify/missing_force/force_mechanism.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "vehicles/description/mirror_partner.h"
#include "vehicles/laws/dashpot_law.h"
#include "vehicles/response/cycle_transform.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;
using Kind = ForceMechanism::Kind;

/// First harmonic of the force of friction of 1 N in this motion of its line.
Complex FrictionOf(const ElementLine& line, const ForceSample& sample) {
  constexpr double kSpeed_mps = 2e-3;
  constexpr int kSamples = 1024;
  const Eigen::Index rows = std::max<Eigen::Index>(2, sample.overtones.rows());
  Eigen::MatrixXcd rate = Eigen::MatrixXcd::Zero(rows, 1);
  for (Eigen::Index h = 2; h < sample.overtones.rows(); ++h)
    rate(h, 0) = Complex(0, static_cast<double>(h) * sample.omega()) *
                 (sample.overtones.row(h) * line.direction.cast<Complex>())(0);
  rate(1, 0) = Complex(0, sample.omega()) * ExtensionOf(line, sample);
  const CycleTransform& transform = CycleTransform::Shared(static_cast<int>(rows - 1), kSamples);
  Eigen::MatrixXd rates;
  transform.ToTime(rate, rates);
  Eigen::MatrixXd forces(rates.rows(), 1);
  static const DashpotLaw law = DashpotLaw().WithFriction(1, kSpeed_mps);
  law.Forces(Samples(rates, 0), Room(forces, 0));
  Eigen::MatrixXcd harmonics;
  transform.ToHarmonics(forces, harmonics);
  return harmonics(1, 0);
}

Complex TensionOf(Kind kind, const ElementLine& line, const ForceSample& sample) {
  if (kind == Kind::kFriction) return FrictionOf(line, sample);
  const Complex extension = ExtensionOf(line, sample);
  return kind == Kind::kDamper ? Complex(0, sample.omega()) * extension : extension;
}

/// Vertical motion, per unit of the coordinates, of a link's centre of mass, and of a point per metre along x from it.
Eigen::MatrixXd HeightsOf(const LinkMotion& link) {
  Eigen::MatrixXd heights(2, link.com_jacobian.cols());
  heights << link.com_jacobian.row(2), -link.spin_jacobian.row(1);
  return heights;
}

Eigen::VectorXcd PartOnMounts(const ForceMechanism& mechanism, const LinkMotion& link, const ForceSample& sample) {
  const double r = sample.frequency_Hz / mechanism.frequency_Hz;
  const Complex loss(0, 2 * mechanism.damping_ratio * r);
  const Eigen::Vector2d place(1, mechanism.place_m);
  const Complex moves = (place.transpose() * HeightsOf(link)).cast<Complex>() * sample.motion;
  return place.cast<Complex>() * (std::pow(sample.omega(), 2) * moves * (1.0 + loss) / (1 - r * r + loss));
}

bool AreMirrorPartners(const ElementLine& a, const ElementLine& b) {
  const std::vector<std::string> partners = MirrorPartners(a.name);
  return a.kind == b.kind && std::find(partners.begin(), partners.end(), b.name) != partners.end();
}

/// Each line alone, and pairs.
std::vector<std::vector<std::size_t>> Groups(const ForceRecord& record) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < record.lines.size(); ++i) groups.push_back({i});
  for (std::size_t i = 0; i < record.lines.size(); ++i)
    for (std::size_t j = 0; j < record.lines.size(); ++j)
      if (i != j && AreMirrorPartners(record.lines[i], record.lines[j])) groups.push_back({i, j});
  return groups;
}

/// Beyond its own centre of mass, as far as the car's axles are from there and a little more.
std::vector<double> Places(const LinkMotion& link, const ForceRecord& record) {
  constexpr int kSteps = 8;
  constexpr double kBeyond = 0.2;
  if (link.spin_jacobian.row(1).isZero(1e-9)) return {0};
  double least = 0;
  double most = 0;
  for (const LinkMotion& other : record.links) {
    least = std::min(least, (1 + kBeyond) * (other.com.x() - link.com.x()));
    most = std::max(most, (1 + kBeyond) * (other.com.x() - link.com.x()));
  }
  if (!(most > least)) return {0};
  std::vector<double> places;
  for (int i = 0; i <= kSteps; ++i) places.push_back(least + (most - least) * i / kSteps);
  return places;
}

void AddParts(const ForceRecord& record, std::size_t link, std::vector<ForceMechanism>& all) {
  constexpr int kFrequencies = 20;
  double lowest = record.samples.front().frequency_Hz;
  double highest = lowest;
  for (const ForceSample& sample : record.samples) {
    lowest = std::min(lowest, sample.frequency_Hz);
    highest = std::max(highest, sample.frequency_Hz);
  }
  for (const double place : Places(record.links[link], record))
    for (int i = 1; i < kFrequencies; ++i)
      for (const double ratio : {0.03, 0.1, 0.3})
        all.push_back({.kind = Kind::kPartOnMounts,
                       .link = link,
                       .place_m = place,
                       .frequency_Hz = lowest * std::pow(highest / lowest, static_cast<double>(i) / kFrequencies),
                       .damping_ratio = ratio});
}

}  // namespace

bool ForceMechanism::Allows(double amount, const ForceRecord& record) const {
  if (!lines.empty()) return amount >= 0;
  const double mass = record.links[link].mass;
  return amount >= kLeastShareOfMass * mass && amount <= mass;
}

Eigen::MatrixXd ForceDirections(const ForceMechanism& mechanism, const ForceRecord& record) {
  if (mechanism.kind == Kind::kPartOnMounts) return HeightsOf(record.links[mechanism.link]).transpose();
  if (mechanism.kind == Kind::kAddedMass) return record.links[mechanism.link].com_jacobian.transpose();
  Eigen::MatrixXd directions(record.lines[mechanism.lines.front()].direction.size(), std::ssize(mechanism.lines));
  for (std::size_t i = 0; i < mechanism.lines.size(); ++i)
    directions.col(static_cast<Eigen::Index>(i)) = -record.lines[mechanism.lines[i]].direction;
  return directions;
}

Eigen::VectorXcd ForceAmplitudes(const ForceMechanism& mechanism, const ForceRecord& record,
                                 const ForceSample& sample) {
  if (mechanism.kind == Kind::kPartOnMounts) return PartOnMounts(mechanism, record.links[mechanism.link], sample);
  if (mechanism.kind == Kind::kAddedMass)
    return std::pow(sample.omega(), 2) * (record.links[mechanism.link].com_jacobian.cast<Complex>() * sample.motion);
  Eigen::VectorXcd tensions(std::ssize(mechanism.lines));
  for (std::size_t i = 0; i < mechanism.lines.size(); ++i)
    tensions[static_cast<Eigen::Index>(i)] = TensionOf(mechanism.kind, record.lines[mechanism.lines[i]], sample);
  return tensions;
}

Eigen::VectorXcd ForceOf(const ForceMechanism& mechanism, const ForceRecord& record, const ForceSample& sample) {
  return ForceDirections(mechanism, record).cast<Complex>() * ForceAmplitudes(mechanism, record, sample);
}

std::vector<ForceMechanism> PossibleMechanisms(const ForceRecord& record) {
  std::vector<ForceMechanism> all;
  for (const std::vector<std::size_t>& group : Groups(record))
    for (const Kind kind : {Kind::kSpring, Kind::kDamper, Kind::kFriction}) {
      // Tyres roll or stand, they do not rub along their squeeze.
      if (kind == Kind::kFriction && record.lines[group.front()].kind == ElementLine::Kind::kTyre) continue;
      all.push_back({.kind = kind, .lines = group});
    }
  for (std::size_t i = 0; i < record.links.size(); ++i) {
    all.push_back({.kind = Kind::kAddedMass, .link = i});
    if (!record.samples.empty()) AddParts(record, i, all);
  }
  return all;
}

std::string MechanismName(Kind kind) {
  switch (kind) {
    case Kind::kSpring: return "stiffness";
    case Kind::kDamper: return "damping";
    case Kind::kFriction: return "friction";
    case Kind::kAddedMass: return "mass";
    case Kind::kPartOnMounts: return "part_on_mounts";
  }
  return "";
}

std::string PlaceName(const ForceMechanism& mechanism, const ForceRecord& record) {
  std::string text;
  for (const std::size_t line : mechanism.lines) text += (text.empty() ? "" : " and ") + record.lines[line].called;
  return mechanism.lines.empty() ? "link '" + record.links[mechanism.link].name + "'" : text;
}

std::vector<std::string> ElementNames(const ForceMechanism& mechanism, const ForceRecord& record) {
  if (mechanism.lines.empty()) return {record.links[mechanism.link].name};
  std::vector<std::string> names;
  for (const std::size_t line : mechanism.lines) names.push_back(record.lines[line].name);
  return names;
}

}  // namespace fourpost
