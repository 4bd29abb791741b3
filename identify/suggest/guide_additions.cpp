#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/suggest/addition_source.h"
#include "identify/suggest/new_friction.h"

namespace fourpost {

/// Dry friction of the guides of a rig: sliding joints on the ground.
void AddGuideAdditions(const AdditionSource& source, std::vector<Addition>& additions) {
  constexpr double kFirst_N_per_kg = 0.1;
  constexpr double kMost_N_per_kg = 5;
  constexpr int kDigits = 9;
  const Vehicle& vehicle = source.vehicle();
  for (const Joint& joint : vehicle.joints) {
    if (joint.type != Joint::Type::kPrismatic || joint.parent != 0) continue;
    if (!source.FrictionBetween(joint.parent, joint.child).empty()) continue;
    const double mass = vehicle.links[static_cast<std::size_t>(joint.child)].mass.At(source.values());
    if (!(mass > 0)) continue;
    Addition addition{.mechanism = "guide_friction", .elements = {joint.name}};
    addition.words = "dry friction in the guide '" + joint.name + "'";
    addition.first = kFirst_N_per_kg * mass;
    addition.greatest = kMost_N_per_kg * mass;
    const NewFriction friction(source, addition);
    const Eigen::Vector3d axis = joint.pose.linear() * joint.axis;
    std::string direction;
    for (const double part : axis) direction += (direction.empty() ? "" : " ") + FormatNumber(AtDigits(part, kDigits));
    VehicleEdit edit = source.Edit();
    edit.Add("<fp:damper name=\"" + source.ElementName("friction", joint.name, false) + "\" parent=\"" +
             vehicle.links[static_cast<std::size_t>(joint.parent)].name + "\" child=\"" +
             vehicle.links[static_cast<std::size_t>(joint.child)].name + "\" axis=\"" + direction +
             "\"><linear rate=\"0 N*s/m\"/>" + friction.Text() + "</fp:damper>");
    friction.Finish(addition, edit);
    additions.push_back(std::move(addition));
  }
}

}  // namespace fourpost
