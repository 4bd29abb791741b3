#include "identify/experiments/kinematics/kinematic_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "vehicles/description/moved_points.h"
#include "vehicles/loops/design_kinematics.h"
#include "vehicles/poses/suspension_rig.h"

namespace fourpost {
namespace {

using Refusal = KinematicAnswer::Refusal;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

StationWants WantsOf(const KinematicSweep& sweep) {
  StationWants wants{.rates = false, .roll_centre = false};
  for (const KinematicCurve& curve : sweep.curves) {
    wants.rates = wants.rates || curve.quantity->wants.rates;
    wants.roll_centre = wants.roll_centre || curve.quantity->wants.roll_centre;
  }
  return wants;
}

/// The distance to the other axle needs that one, too.
bool NeedsWhole(const std::vector<KinematicSweep>& sweeps) {
  return std::any_of(sweeps.begin(), sweeps.end(), [](const KinematicSweep& sweep) {
    return std::any_of(sweep.curves.begin(), sweep.curves.end(),
                       [](const KinematicCurve& curve) { return curve.quantity->name == "wheelbase"; });
  });
}

OneAxle Whole(const Vehicle& vehicle) {
  OneAxle all{.vehicle = vehicle, .springs = {}, .bushings = {}};
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) all.springs.push_back(i);
  for (std::size_t i = 0; i < vehicle.bushings.size(); ++i) all.bushings.push_back(i);
  return all;
}

/// Of what a curve measures: place of its wheel, or of its strut among these.
std::size_t PlaceOf(const KinematicCurve& curve, const std::vector<AxleStrut>& struts) {
  if (curve.quantity->of != KinematicQuantity::Of::kStrut) return curve.of;
  const auto found = std::find_if(struts.begin(), struts.end(), [&](const AxleStrut& one) {
    return one.kind == curve.strut_kind && one.name == curve.of_name;
  });
  return found == struts.end() ? kNone : static_cast<std::size_t>(found - struts.begin());
}

}  // namespace

/// The model at one set of values.
class KinematicModel::Evaluation {
 public:
  Evaluation(const KinematicModel& model, const std::vector<double>& values, const Deadline& deadline)
      : model_(model), values_(values), deadline_(deadline), preloads_(model.PreloadsAt(values)) {}

  KinematicAnswer Answer() {
    for (std::size_t s = 0; s < model_.sweeps_.size() && !answer_.refusal; ++s) {
      deadline_.Check();
      answer_.sweeps.push_back(model_.sweeps_[s].load ? Loaded(s) : Moved(s));
    }
    return std::move(answer_);
  }

 private:
  struct Rig {
    Rig(const OneAxle& axle, const std::vector<double>& values, const Preloads& whole)
        : vehicle(WithPointsAt(axle.vehicle, values)), rig(vehicle, values, axle.PreloadsOf(whole)) {}
    Vehicle vehicle;
    SuspensionRig rig;
    std::optional<std::vector<AxleCompliance>> compliance;
  };

  Rig& RigOf(std::size_t axle) {
    std::unique_ptr<Rig>& rig = rigs_[axle];
    if (!rig) rig = std::make_unique<Rig>(model_.axles_.at(axle), values_, preloads_);
    return *rig;
  }

  std::vector<Eigen::VectorXd> Refuse(Refusal refusal) {
    answer_.refusal = refusal;
    return {};
  }

  std::vector<Eigen::VectorXd> Moved(std::size_t s) {
    const KinematicSweep& sweep = model_.sweeps_[s];
    const std::vector<std::optional<AxleStation>> stations = StationsAt(
        RigOf(sweep.axle).rig, model_.place_in_.at(sweep.axle), values_, sweep.travel, sweep.positions, WantsOf(sweep));
    std::vector<Eigen::VectorXd> curves;
    for (std::size_t c = 0; c < sweep.curves.size(); ++c) {
      const KinematicCurve& curve = sweep.curves[c];
      Eigen::VectorXd points(std::ssize(curve.places));
      for (std::size_t i = 0; i < curve.places.size(); ++i) {
        const std::optional<AxleStation>& station = stations[curve.places[i]];
        if (!station)
          return Refuse({.kind = Refusal::Kind::kNotReached, .sweep = s, .position = sweep.positions[curve.places[i]]});
        const std::size_t of = model_.of_[s][c];
        const double point = of == kNone ? NAN : curve.quantity->at_station(*station, of);
        if (std::isnan(point)) return Refuse({.kind = Refusal::Kind::kNotThere, .sweep = s, .curve = c});
        points[static_cast<Eigen::Index>(i)] = point;
      }
      curves.push_back(std::move(points));
    }
    return curves;
  }

  std::vector<Eigen::VectorXd> Loaded(std::size_t s) {
    const KinematicSweep& sweep = model_.sweeps_[s];
    Rig& rig = RigOf(sweep.axle);
    if (!rig.compliance) rig.compliance = ComplianceOf(rig.rig, model_.place_in_.at(sweep.axle), values_);
    const auto found = std::find_if(rig.compliance->begin(), rig.compliance->end(), [&](const AxleCompliance& one) {
      return one.load == sweep.load->kind && one.is_opposed == sweep.load->is_opposed;
    });
    if (found == rig.compliance->end()) return Refuse({.kind = Refusal::Kind::kRigid, .sweep = s});
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

  const KinematicModel& model_;
  const std::vector<double>& values_;
  const Deadline& deadline_;
  Preloads preloads_;
  std::map<std::size_t, std::unique_ptr<Rig>> rigs_;
  KinematicAnswer answer_;
};

KinematicModel::KinematicModel(const Vehicle& vehicle, std::vector<KinematicSweep> sweeps)
    : vehicle_(vehicle), sweeps_(std::move(sweeps)) {
  if (sweeps_.empty()) return;
  const Suspension suspension = SuspensionOf(vehicle, DesignKinematics(vehicle), vehicle.ParameterValues());
  const bool needs_whole = NeedsWhole(sweeps_) || suspension.chassis < 0;
  for (const KinematicSweep& sweep : sweeps_) {
    if (!axles_.contains(sweep.axle)) {
      axles_[sweep.axle] = needs_whole ? Whole(vehicle) : OneAxleOf(vehicle, suspension, sweep.axle);
      place_in_[sweep.axle] = needs_whole ? sweep.axle : 0;
    }
    const std::vector<AxleStrut> struts = StrutsOf(axles_[sweep.axle].vehicle);
    of_.emplace_back();
    for (const KinematicCurve& curve : sweep.curves) of_.back().push_back(PlaceOf(curve, struts));
  }
  const std::vector<bool> moves = MovePoints(vehicle);
  if (std::none_of(moves.begin(), moves.end(), [](bool one) { return one; }))
    condensed_ = std::make_shared<const CondensedVehicle>(vehicle);
}

Preloads KinematicModel::PreloadsAt(const std::vector<double>& values) const {
  if (condensed_) return condensed_->PreloadsAt(values);
  return CondensedVehicle(WithPointsAt(vehicle_, values)).PreloadsAt(values);
}

KinematicAnswer KinematicModel::At(const std::vector<double>& values, const Deadline& deadline) const {
  if (sweeps_.empty()) return {};
  return Evaluation(*this, values, deadline).Answer();
}

double FittedOffset(const KinematicCurve& curve, const Eigen::VectorXd& modelled) {
  if (!curve.has_free_offset) return 0;
  const Eigen::Map<const Eigen::VectorXd> measured(curve.measured.data(), std::ssize(curve.measured));
  return (measured - modelled).mean();
}

}  // namespace fourpost
