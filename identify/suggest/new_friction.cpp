#include "identify/suggest/new_friction.h"

#include <vector>

namespace fourpost {

NewFriction::NewFriction(const AdditionSource& source, const Addition& addition, const std::string& name)
    : force_{.name = source.ParameterName(name, addition.elements),
             .dimension = kForce,
             .lower = 0,
             .upper = addition.greatest,
             .source = "suggested: " + addition.words},
      speed_{.name = source.ParameterName("v_" + name, addition.elements),
             .dimension = kVelocity,
             .lower = kLeastSpeed_mps,
             .upper = kMostSpeed_mps,
             .source = force_.source} {}

std::string NewFriction::Text() const {
  return "<friction force=\"$" + force_.name + "\" speed=\"$" + speed_.name + "\"/>";
}

void NewFriction::Finish(Addition& addition, VehicleEdit& edit) const {
  addition.parameters = {force_.name, speed_.name};
  addition.values = [](double force) { return std::vector{force, kFirstSpeed_mps}; };
  addition.count = 2;
  edit.Add(force_, addition.first);
  edit.Add(speed_, kFirstSpeed_mps);
  addition.vehicle = edit.Text();
}

}  // namespace fourpost
