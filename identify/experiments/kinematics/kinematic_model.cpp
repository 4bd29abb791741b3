#include "identify/experiments/kinematics/kinematic_model.h"

#include <algorithm>
#include <cmath>

#include "vehicles/description/moved_points.h"

namespace fourpost {
namespace {

using Refusal = KinematicAnswer::Refusal;

StationWants WantsOf(const KinematicSweep& sweep) {
  StationWants wants{.rates = false, .roll_centre = false};
  for (const KinematicCurve& curve : sweep.curves) {
    wants.rates = wants.rates || curve.quantity->wants.rates;
    wants.roll_centre = wants.roll_centre || curve.quantity->wants.roll_centre;
  }
  return wants;
}

class RigAnswer {
 public:
  RigAnswer(const Vehicle& vehicle, std::span<const KinematicSweep> sweeps, const std::vector<double>& values,
            const Deadline& deadline)
      : sweeps_(sweeps),
        values_(values),
        deadline_(deadline),
        vehicle_(WithPointsAt(vehicle, values)),
        rig_(vehicle_, values) {}

  KinematicAnswer Answer() {
    for (std::size_t s = 0; s < sweeps_.size() && !answer_.refusal; ++s) {
      deadline_.Check();
      answer_.sweeps.push_back(sweeps_[s].load ? Loaded(s) : Moved(s));
    }
    return std::move(answer_);
  }

 private:
  std::vector<Eigen::VectorXd> Refuse(Refusal refusal) {
    answer_.refusal = refusal;
    return {};
  }

  std::vector<Eigen::VectorXd> Moved(std::size_t s) {
    const KinematicSweep& sweep = sweeps_[s];
    const std::vector<std::optional<AxleStation>> stations =
        StationsAt(rig_, sweep.axle, values_, sweep.travel, sweep.positions, WantsOf(sweep));
    std::vector<Eigen::VectorXd> curves;
    for (const KinematicCurve& curve : sweep.curves) {
      Eigen::VectorXd points(std::ssize(curve.places));
      for (std::size_t i = 0; i < curve.places.size(); ++i) {
        const std::optional<AxleStation>& station = stations[curve.places[i]];
        if (!station)
          return Refuse({.kind = Refusal::Kind::kNotReached, .sweep = s, .position = sweep.positions[curve.places[i]]});
        const double point = curve.quantity->at_station(*station, curve.of);
        if (std::isnan(point)) return Refuse({.kind = Refusal::Kind::kNotThere, .sweep = s, .curve = &curve});
        points[static_cast<Eigen::Index>(i)] = point;
      }
      curves.push_back(std::move(points));
    }
    return curves;
  }

  std::vector<Eigen::VectorXd> Loaded(std::size_t s) {
    const KinematicSweep& sweep = sweeps_[s];
    if (compliance_.empty() || compliance_axle_ != sweep.axle) {
      compliance_ = ComplianceOf(rig_, sweep.axle, values_);
      compliance_axle_ = sweep.axle;
    }
    const auto found = std::find_if(compliance_.begin(), compliance_.end(), [&](const AxleCompliance& one) {
      return one.load == sweep.load->kind && one.is_opposed == sweep.load->is_opposed;
    });
    if (found == compliance_.end()) return Refuse({.kind = Refusal::Kind::kRigid, .sweep = s});
    std::vector<Eigen::VectorXd> curves;
    for (const KinematicCurve& curve : sweep.curves) {
      const double slope = curve.quantity->per_load(found->wheels[curve.of]);
      Eigen::VectorXd points(std::ssize(curve.places));
      for (std::size_t i = 0; i < curve.places.size(); ++i)
        points[static_cast<Eigen::Index>(i)] = slope * sweep.positions[curve.places[i]];
      curves.push_back(std::move(points));
    }
    return curves;
  }

  std::span<const KinematicSweep> sweeps_;
  const std::vector<double>& values_;
  const Deadline& deadline_;
  Vehicle vehicle_;
  SuspensionRig rig_;
  std::vector<AxleCompliance> compliance_;
  std::size_t compliance_axle_ = 0;
  KinematicAnswer answer_;
};

}  // namespace

KinematicAnswer AnswerKinematics(const Vehicle& vehicle, std::span<const KinematicSweep> sweeps,
                                 const std::vector<double>& values, const Deadline& deadline) {
  if (sweeps.empty()) return {};
  return RigAnswer(vehicle, sweeps, values, deadline).Answer();
}

double FittedOffset(const KinematicCurve& curve, const Eigen::VectorXd& modelled) {
  if (!curve.has_free_offset) return 0;
  const Eigen::Map<const Eigen::VectorXd> measured(curve.measured.data(), std::ssize(curve.measured));
  return (measured - modelled).mean();
}

}  // namespace fourpost
