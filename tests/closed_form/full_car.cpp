#include "tests/closed_form/full_car.h"

namespace fourpost {
namespace {

using Vector7d = Eigen::Vector<double, 7>;

Vector7d Inertias(const FullCar& car) {
  return {car.sprung_mass,        car.roll_inertia, car.pitch_inertia,    car.front.mass,
          car.front.roll_inertia, car.rear.mass,    car.rear.roll_inertia};
}

/// What a corner knows of its axle.
struct Corner {
  Corner(const FullCar& car, int index)
      : axle(index < 2 ? car.front : car.rear), heave(index < 2 ? 3 : 5), side(index % 2 == 0 ? 1 : -1) {}

  const FullCar::Axle& axle;
  int heave;    // index in q of the axle's heave; its roll follows
  double side;  // 1 left, -1 right
};

/// Derivative by q of the extension of a strut at this station.
Vector7d StrutDirection(const FullCar& car, const Corner& corner, double station) {
  const double y = corner.side * station;
  Vector7d direction = Vector7d::Zero();
  direction.head<3>() << 1, y - car.offset, -corner.axle.x;
  direction.segment<2>(corner.heave) << -1, -(y - corner.axle.offset);
  return direction;
}

/// Derivative by q of the tyre's height.
Vector7d TyreDirection(const Corner& corner) {
  Vector7d direction = Vector7d::Zero();
  direction.segment<2>(corner.heave) << 1, corner.side * corner.axle.tyre_station - corner.axle.offset;
  return direction;
}

}  // namespace

CondensedModel FullCar::Model() const {
  CondensedModel model;
  model.mass = Inertias(*this).asDiagonal();
  model.damping = Eigen::MatrixXd::Zero(7, 7);
  model.stiffness = Eigen::MatrixXd::Zero(7, 7);
  model.post_stiffness = Eigen::MatrixXd::Zero(7, 4);
  model.post_damping = Eigen::MatrixXd::Zero(7, 4);
  for (int i = 0; i < 4; ++i) {
    const Corner corner(*this, i);
    const auto at = static_cast<std::size_t>(i);
    const Vector7d spring = StrutDirection(*this, corner, corner.axle.spring_station);
    const Vector7d tyre = TyreDirection(corner);
    model.stiffness += stiffness[at] * spring * spring.transpose() + tyre_stiffness[at] * tyre * tyre.transpose();
    model.post_stiffness.col(i) = tyre_stiffness[at] * tyre;
    model.dashpots.push_back({StrutDirection(*this, corner, corner.axle.damper_station), corner.axle.damper, {}});
  }
  return model;
}

Eigen::Vector<double, 7> FullCar::Acceleration(const Eigen::Vector<double, 7>& q, const Eigen::Vector<double, 7>& rate,
                                               const Eigen::Vector4d& ground) const {
  Vector7d force = Vector7d::Zero();
  for (int i = 0; i < 4; ++i) {
    const Corner corner(*this, i);
    const Axle& axle = corner.axle;
    const int z = corner.heave;
    const int phi = corner.heave + 1;
    const double s = corner.side * axle.spring_station;
    const double d = corner.side * axle.damper_station;
    const double t = corner.side * axle.tyre_station;
    const double extension = q[0] + (s - offset) * q[1] - axle.x * q[2] - q[z] - (s - axle.offset) * q[phi];
    const double extension_rate =
        rate[0] + (d - offset) * rate[1] - axle.x * rate[2] - rate[z] - (d - axle.offset) * rate[phi];
    const double spring = stiffness[static_cast<std::size_t>(i)] * extension;
    const double damper = axle.damper.Force(extension_rate);
    const double tyre = tyre_stiffness[static_cast<std::size_t>(i)] * (q[z] + (t - axle.offset) * q[phi] - ground[i]);
    force[0] -= spring + damper;
    force[1] -= (s - offset) * spring + (d - offset) * damper;
    force[2] += axle.x * (spring + damper);
    force[z] += spring + damper - tyre;
    force[phi] += (s - axle.offset) * spring + (d - axle.offset) * damper - (t - axle.offset) * tyre;
  }
  return force.cwiseQuotient(Inertias(*this));
}

}  // namespace fourpost
