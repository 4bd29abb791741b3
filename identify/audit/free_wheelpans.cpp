#include "identify/audit/free_wheelpans.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace fourpost {
namespace {

bool IsRecorded(const AuditSubject& subject, std::size_t tyre) {
  return std::any_of(subject.runs.begin(), subject.runs.end(), [&](const AuditedRun& run) {
    return run.forces.row(static_cast<Eigen::Index>(tyre)).array().real().isFinite().any();
  });
}

}  // namespace

std::vector<std::size_t> StatedWheelpans(const AuditSubject& subject) {
  std::vector<std::size_t> tyres;
  for (std::size_t t = 0; t < subject.car.tyres.size(); ++t) {
    const Eigen::VectorXd& slope = subject.car.tyres[t].wheelpan_slope;
    if ((slope.size() == 0 || slope.isZero()) && IsRecorded(subject, t)) tyres.push_back(t);
  }
  return tyres;
}

AuditSubject WithFreeWheelpans(AuditSubject subject, const std::vector<std::size_t>& tyres, double reach_kg) {
  AuditedCar& car = subject.car;
  const Eigen::Index first = car.reach.size();
  const Eigen::Index count = first + static_cast<Eigen::Index>(tyres.size());
  const auto lengthened = [&](Eigen::VectorXd& slope) { slope.conservativeResizeLike(Eigen::VectorXd::Zero(count)); };
  car.reach.conservativeResizeLike(Eigen::VectorXd::Constant(count, reach_kg));
  for (AuditedTyre& tyre : car.tyres) lengthened(tyre.wheelpan_slope);
  for (std::size_t i = 0; i < tyres.size(); ++i)
    car.tyres[tyres[i]].wheelpan_slope[first + static_cast<Eigen::Index>(i)] = 1;
  if (car.balance) {
    const Eigen::RowVectorXd none = Eigen::RowVectorXd::Zero(car.coordinates);
    car.balance->inertia_slope.resize(static_cast<std::size_t>(count), none);
    car.balance->gravity_slope.resize(static_cast<std::size_t>(count), none);
  }
  if (subject.weight) lengthened(subject.weight->slope);
  return subject;
}

}  // namespace fourpost
