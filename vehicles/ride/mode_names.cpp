#include "vehicles/ride/mode_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "vehicles/loops/motion_name.h"

namespace fourpost {
namespace {

using Names = std::array<const char*, 6>;
using Energy = Eigen::Matrix<double, 6, 1>;

constexpr Names kBodyNames = {"fore-aft", "lateral", "heave", "roll", "pitch", "yaw"};
constexpr Names kAxleNames = {"fore-aft", "lateral", "hop", "tramp", "wind-up", "steer"};
/// Of the wheels of an axle, alike and against each other.
constexpr Names kAlikeNames = {"fore-aft", "lateral", "hop", "camber", "wind-up", "steer"};
constexpr Names kAgainstNames = {"fore-aft opposed", "track", "tramp", "camber opposed", "wind-up opposed", "toe"};
/// From here on one side of an axle moves for itself.
constexpr double kOneSide = 0.9;

/// Where a body belongs.
struct Role {
  enum class Kind { kChassis, kAxle, kWheel, kOther } kind = Kind::kOther;
  std::size_t axle = 0;
  /// Of a body that moves with one wheel: +1 left, -1 right.
  int side = 0;
};

double Lift(const BodyMotion& body, const std::optional<WheelTravel>& travel) {
  return travel ? (body.com_jacobian * travel->motion).norm() : 0;
}

/// How far the wheels of one side lift the body, each moved alone.
double LiftBySide(const BodyMotion& body, const Suspension& suspension, const HeldChassis& held, const Axle& axle,
                  int side) {
  double most = 0;
  for (const std::size_t i : axle.wheels)
    if (suspension.wheels[i].side == side) most = std::max(most, Lift(body, held.MoveOne(i)));
  return most;
}

int SideOf(const BodyMotion& body, const Suspension& suspension, const HeldChassis& held, const Axle& axle) {
  // A beam axle's middle follows both wheels by a half.
  constexpr double kLittle = 0.2;
  const double left = LiftBySide(body, suspension, held, axle, 1);
  const double right = LiftBySide(body, suspension, held, axle, -1);
  return right < kLittle * left ? 1 : left < kLittle * right ? -1 : 0;
}

Role RoleOf(std::size_t index, const Suspension& suspension, const HeldChassis& held) {
  if (static_cast<int>(index) == suspension.chassis) return {.kind = Role::Kind::kChassis};
  constexpr double kFollows = 0.1;
  const BodyMotion& body = suspension.bodies[index];
  Role role;
  double most = kFollows;
  for (std::size_t a = 0; a < suspension.axles.size(); ++a) {
    const double lift = Lift(body, held.MoveTogether(suspension.axles[a]));
    if (lift < most) continue;
    most = lift;
    role = {.kind = Role::Kind::kAxle, .axle = a};
  }
  if (role.kind == Role::Kind::kAxle && suspension.axles[role.axle].HasTwoSides(suspension.wheels)) {
    role.side = SideOf(body, suspension, held, suspension.axles[role.axle]);
    if (role.side != 0) role.kind = Role::Kind::kWheel;
  }
  return role;
}

/// How the wheels of an axle share a motion.
struct Sides {
  /// Share of the squared speed that they have in common.
  double alike = 1;
  /// Share of the left one.
  double left = 0.5;
};

Sides SidesOf(const Suspension& suspension, const Axle& axle, Eigen::Index direction, const Eigen::VectorXcd& shape) {
  std::complex<double> left = 0;
  std::complex<double> right = 0;
  for (const std::size_t i : axle.wheels) {
    const Wheel& wheel = suspension.wheels[i];
    const std::complex<double> speed = (wheel.jacobian.row(direction) * shape).value();
    if (wheel.side > 0) left += speed;
    if (wheel.side < 0) right += speed;
  }
  const double both = std::norm(left) + std::norm(right);
  if (both == 0) return {};
  return {std::norm(left + right) / (2 * both), std::norm(left) / both};
}

class Naming {
 public:
  Naming(const Suspension& suspension, const HeldChassis& held) : suspension_(suspension) {
    for (std::size_t i = 0; i < suspension.bodies.size(); ++i) roles_.push_back(RoleOf(i, suspension, held));
  }

  void Name(Mode& mode) const {
    std::map<std::string, double> chassis;
    std::map<std::string, double> others;
    for (std::size_t i = 0; i < roles_.size(); ++i)
      Add(i, mode.shape, roles_[i].kind == Role::Kind::kChassis ? chassis : others);
    const double of_chassis = Sum(chassis);
    const double total = of_chassis + Sum(others);
    const std::map<std::string, double>& leading = of_chassis >= 0.5 * total ? chassis : others;
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto most = std::max_element(leading.begin(), leading.end(), less);
    mode.name = most == leading.end() ? "motion" : most->first;
    mode.energy.clear();
    for (const auto* part : {&chassis, &others})
      for (const auto& [motion, energy] : *part)
        if (energy > 0) mode.energy.push_back({motion, energy / total});
    std::stable_sort(mode.energy.begin(), mode.energy.end(),
                     [](const MotionShare& a, const MotionShare& b) { return a.share > b.share; });
  }

 private:
  static double Sum(const std::map<std::string, double>& energies) {
    double sum = 0;
    for (const auto& [motion, energy] : energies) sum += energy;
    return sum;
  }

  void Add(std::size_t index, const Eigen::VectorXcd& shape, std::map<std::string, double>& energies) const {
    const Energy energy = EnergyByDirection(suspension_.bodies[index], shape);
    const Role& role = roles_[index];
    for (Eigen::Index d = 0; d < energy.size(); ++d) {
      const auto i = static_cast<std::size_t>(d);
      switch (role.kind) {
        case Role::Kind::kChassis: energies[kBodyNames[i]] += energy[d]; break;
        case Role::Kind::kAxle: energies[suspension_.axles[role.axle].name + " " + kAxleNames[i]] += energy[d]; break;
        case Role::Kind::kWheel: AddWheel(role, d, shape, energy[d], energies); break;
        case Role::Kind::kOther: energies[suspension_.bodies[index].name + " " + kBodyNames[i]] += energy[d]; break;
      }
    }
  }

  void AddWheel(const Role& role, Eigen::Index direction, const Eigen::VectorXcd& shape, double energy,
                std::map<std::string, double>& energies) const {
    const Axle& axle = suspension_.axles[role.axle];
    const Sides sides = SidesOf(suspension_, axle, direction, shape);
    const auto i = static_cast<std::size_t>(direction);
    if (std::max(sides.left, 1 - sides.left) > kOneSide) {
      energies[axle.name + (role.side > 0 ? " left " : " right ") + kAlikeNames[i]] += energy;
      return;
    }
    energies[axle.name + " " + kAlikeNames[i]] += sides.alike * energy;
    energies[axle.name + " " + kAgainstNames[i]] += (1 - sides.alike) * energy;
  }

  const Suspension& suspension_;
  std::vector<Role> roles_;
};

/// Turns free motions among each other until each is one motion of one link, as far as that can be.
void TellApart(const Vehicle& vehicle, const Kinematics& pose, std::vector<Mode>& modes) {
  std::vector<Mode*> free_modes;
  for (Mode& mode : modes)
    if (mode.kind == Mode::Kind::kFree) free_modes.push_back(&mode);
  if (free_modes.size() < 2) return;
  Eigen::MatrixXd basis(free_modes.front()->shape.size(), static_cast<Eigen::Index>(free_modes.size()));
  for (std::size_t i = 0; i < free_modes.size(); ++i)
    basis.col(static_cast<Eigen::Index>(i)) = free_modes[i]->shape.real();
  const std::vector<NamedMotion> motions = NameMotions(LinkMotionsOf(vehicle, pose), basis);
  for (std::size_t i = 0; i < std::min(motions.size(), free_modes.size()); ++i) free_modes[i]->shape = motions[i].shape;
}

void NumberNames(std::vector<Mode>& modes) {
  std::map<std::string, int> seen;
  for (Mode& mode : modes)
    if (const int count = ++seen[mode.name]; count > 1) mode.name += " " + std::to_string(count);
}

}  // namespace

void NameModes(const Vehicle& vehicle, const Kinematics& pose, const Suspension& suspension, const HeldChassis& held,
               std::vector<Mode>& modes) {
  TellApart(vehicle, pose, modes);
  const Naming naming(suspension, held);
  for (Mode& mode : modes) naming.Name(mode);
  NumberNames(modes);
}

}  // namespace fourpost
