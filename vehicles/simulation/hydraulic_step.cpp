#include "vehicles/simulation/hydraulic_step.h"

#include <cmath>
#include <limits>

namespace fourpost {

HydraulicStep::HydraulicStep(const HydraulicRemainder& port, double step_s)
    : oil_(port.law), share_(port.share), step_s_(step_s) {
  Rest();
}

void HydraulicStep::Rest() {
  now_ = oil_.Rest();
  extension_ = earlier_ = last_ = 0;
}

double HydraulicStep::Remainder(double extension, double lag) {
  const double area = oil_.law().damper.annulus_area;
  const double held = 1.5 / step_s_;
  const double past = (2 * last_ - 0.5 * earlier_) / step_s_;
  const HydraulicOil::State found = oil_.Find(extension, held, 1, held * area * extension + past, now_);
  if (!std::isfinite(found.tension) || !std::isfinite(found.surplus)) return std::numeric_limits<double>::quiet_NaN();
  now_ = found;
  extension_ = extension;
  const HydraulicOil::Slopes slopes = oil_.SlopesAt(extension, now_);
  const double surplus_by = (held * area - slopes.flow_by_extension) / (held + slopes.flow_by_surplus);
  by_extension_ = slopes.tension_by_extension + slopes.tension_by_surplus * surplus_by - share_.stiffness;
  return now_.tension - share_.stiffness * extension - share_.series * lag;
}

std::array<double, 2> HydraulicStep::PressuresAboveRest() const {
  const std::array<double, 2> rest = oil_.Rest().pressures;
  return {now_.pressures[0] - rest[0], now_.pressures[1] - rest[1]};
}

void HydraulicStep::Advance() {
  earlier_ = last_;
  last_ = now_.surplus - oil_.law().damper.annulus_area * extension_;
}

double HydraulicStep::Size() const { return oil_.law().damper.gas_pressure * oil_.law().damper.piston_area; }

}  // namespace fourpost
