#include "vehicles/bench/bench_damper.h"

#include <cmath>

#include "vehicles/bench/series_history.h"
#include "vehicles/description/design_poses.h"
#include "vehicles/simulation/hydraulic_step.h"

namespace fourpost {
namespace {

bool IsSame(const Point& a, const Point& b) { return a.link == b.link && a.xyz == b.xyz; }

bool IsSame(const ForceLine& a, const ForceLine& b) {
  return IsSame(a.parent, b.parent) && IsSame(a.child, b.child) && a.axis == b.axis;
}

/// Adds what a dashpot alone does, of rates at the samples.
void AddDashpot(const DashpotLaw& law, const BenchMotion& motion, std::vector<double>& tensions) {
  for (std::size_t k = 0; k < tensions.size(); ++k) tensions[k] += law.Force(motion.rate[k * motion.steps]);
}

void Add(const std::vector<double>& forces, std::vector<double>& tensions) {
  for (std::size_t k = 0; k < tensions.size(); ++k) tensions[k] += forces[k];
}

/// Adds friction that sticks, from rest at the first sample.
void AddFriction(const DahlFriction& law, const BenchMotion& motion, std::vector<double>& tensions) {
  double force = 0;
  for (std::size_t k = 1; k < motion.extension.size(); ++k) {
    force = law.After(force, motion.extension[k] - motion.extension[k - 1]).force;
    if (k % motion.steps == 0) tensions[k / motion.steps] += force;
  }
}

/// Whether no chamber closes.
bool AddHydraulic(const MountedHydraulicDamper& law, const BenchMotion& motion, std::vector<double>& tensions) {
  HydraulicStep step({.law = law, .share = {}}, motion.step_s);
  std::vector<double> forces(tensions.size());
  for (std::size_t k = 1; k < motion.extension.size(); ++k) {
    const double tension = step.Remainder(motion.extension[k], 0);
    if (!std::isfinite(tension)) return false;
    if (k % motion.steps == 0) forces[k / motion.steps] = tension;
    step.Advance();
  }
  Add(forces, tensions);
  const DashpotLaw friction = DashpotLaw().WithFriction(law.damper.friction, law.damper.friction_speed);
  AddDashpot(friction, motion, tensions);
  return true;
}

/// Whether no chamber closes.
bool AddDamper(const Damper& damper, const BenchMotion& motion, std::span<const double> values, double tolerance,
               std::vector<double>& tensions) {
  if (const std::optional<DahlFriction> friction = damper.law.StickingAt(values))
    AddFriction(*friction, motion, tensions);
  const SpringLaw series = damper.series ? damper.series->At(values) : SpringLaw{};
  if (damper.hydraulic) return AddHydraulic({damper.HydraulicAt(values), series}, motion, tensions);
  if (damper.series) Add(SeriesForces({damper.law.At(values), series}, motion, tolerance), tensions);
  else AddDashpot(damper.law.At(values), motion, tensions);
  return true;
}

void AddSpring(const Spring& spring, const BenchMotion& motion, std::span<const double> values,
               std::vector<double>& tensions) {
  const SpringLaw law = spring.law.At(values);
  const double preload = spring.preload ? spring.preload->At(values) : 0;
  for (std::size_t k = 0; k < tensions.size(); ++k)
    tensions[k] += preload + law.Force(motion.extension[k * motion.steps]);
}

}  // namespace

BenchDamper::BenchDamper(const Vehicle& vehicle, std::size_t damper) {
  const ForceLine& line = vehicle.dampers[damper].line;
  const std::vector<Eigen::Isometry3d> poses = DesignPoses(vehicle);
  length_m_ = (PlaceOf(line.parent, poses) - PlaceOf(line.child, poses)).norm();
  for (const Damper& other : vehicle.dampers)
    if (IsSame(other.line, line)) dampers_.push_back(other);
  for (const Spring& spring : vehicle.springs)
    if (IsSame(spring.line, line)) springs_.push_back(spring);
}

std::vector<double> BenchDamper::Tensions(const BenchMotion& motion, std::span<const double> values) const {
  return Tensions(motion, values, kSeriesTolerance);
}

std::vector<double> BenchDamper::FinerTensions(const BenchMotion& motion, std::span<const double> values) const {
  return Tensions(WithHalfTheStep(motion), values, kSeriesTolerance / 10);
}

std::vector<double> BenchDamper::Tensions(const BenchMotion& motion, std::span<const double> values,
                                          double tolerance) const {
  std::vector<double> tensions(motion.samples());
  for (const Damper& damper : dampers_)
    if (!AddDamper(damper, motion, values, tolerance, tensions)) return {};
  for (const Spring& spring : springs_) AddSpring(spring, motion, values, tensions);
  return tensions;
}

}  // namespace fourpost
