#include "identify/suggest/fitted_dampers.h"

#include <tuple>
#include <utility>

namespace fourpost {
namespace {

bool AreSameEnds(const ForceLine& a, const ForceLine& b) {
  constexpr double kNear = 1e-6;
  return a.parent.link == b.parent.link && a.child.link == b.child.link &&
         (a.parent.xyz - b.parent.xyz).norm() < kNear && (a.child.xyz - b.child.xyz).norm() < kNear;
}

bool HasPoints(const DashpotDescription& law) {
  return law.kind == DashpotDescription::Kind::kTable || law.kind == DashpotDescription::Kind::kCurve;
}

/// In bump and rebound; of a curve at the speed at which `check` takes it.
std::pair<double, double> RatesOf(const DashpotDescription& law, const std::vector<double>& values) {
  constexpr double kSpeed = 0.1;
  if (!HasPoints(law)) return {law.compression.At(values), law.rebound.At(values)};
  DashpotDescription bare = law;
  bare.friction.reset();
  const DashpotLaw curve = bare.At(values);
  return {curve.Force(-kSpeed) / -kSpeed, curve.Force(kSpeed) / kSpeed};
}

bool IsFrictionAlone(const DashpotDescription& law) {
  return !HasPoints(law) && law.compression.IsZero() && law.rebound.IsZero();
}

}  // namespace

FittedDampers::FittedDampers(const AdditionSource& source) : source_(source) {
  for (const Damper& damper : source.vehicle().dampers) {
    FittedDamper one{&damper};
    if (!damper.hydraulic) {
      std::tie(one.bump, one.rebound) = RatesOf(damper.law, source.values());
    }
    dampers_.push_back(one);
    lines_.push_back(damper.line);
  }
}

std::vector<std::string> FittedDampers::NamesOf(const AdditionSource::Group& group) const {
  std::vector<std::string> names;
  for (const std::size_t i : group) names.push_back(dampers_[i].damper->name);
  return names;
}

double FittedDampers::RateOf(const AdditionSource::Group& group) const {
  double rate = 0;
  for (const std::size_t i : group) rate += dampers_[i].rate() / static_cast<double>(group.size());
  return rate;
}

const Damper* FittedDampers::FrictionBeside(const FittedDamper& one) const {
  for (const FittedDamper& other : dampers_)
    if (other.damper->law.friction && !other.damper->series && AreSameEnds(one.damper->line, other.damper->line))
      return other.damper;
  return nullptr;
}

bool FittedDampers::PutFrictionInside(const AdditionSource::Group& group, VehicleEdit& edit) const {
  std::vector<std::string> frictions;
  for (const std::size_t i : group) {
    const Damper* friction = FrictionBeside(dampers_[i]);
    if (!friction || friction == dampers_[i].damper || friction->hydraulic || friction->law.Sticks()) return false;
    if (!IsFrictionAlone(friction->law)) return false;
    frictions.push_back(friction->name);
  }
  const std::vector<std::string> dampers = source_.WrittenOf("fp:damper", NamesOf(group));
  const std::vector<std::string> written = source_.WrittenOf("fp:damper", frictions);
  if (dampers.empty() || dampers.size() != written.size()) return false;
  for (const std::size_t i : group) {
    const std::string& damper = dampers_[i].damper->name;
    if (std::find(dampers.begin(), dampers.end(), damper) == dampers.end()) continue;
    const std::string& friction = FrictionBeside(dampers_[i])->name;
    const tinyxml2::XMLElement* element = edit.Find("fp:damper", friction);
    const tinyxml2::XMLElement* law = element ? element->FirstChildElement("friction") : nullptr;
    const tinyxml2::XMLElement* of = edit.Find("fp:damper", damper);
    if (!law || !of) return false;
    edit.AddChild(*of, TextOf(*law));
    edit.Remove(*element);
  }
  return true;
}

void FittedDampers::AddAsChild(Addition addition, const NewParameter& parameter, const std::string& xml,
                               std::vector<Addition>& additions) const {
  const std::vector<std::string> written = source_.WrittenOf("fp:damper", addition.elements);
  if (written.empty()) return;
  VehicleEdit edit = source_.Edit();
  for (const std::string& name : written)
    if (const tinyxml2::XMLElement* element = edit.Find("fp:damper", name)) edit.AddChild(*element, xml);
    else return;
  addition.parameters = {parameter.name};
  edit.Add(parameter, addition.values(addition.first).front());
  addition.vehicle = edit.Text();
  additions.push_back(std::move(addition));
}

std::string TextOf(const tinyxml2::XMLElement& element) {
  tinyxml2::XMLPrinter printer(nullptr, true);
  element.Accept(&printer);
  return printer.CStr();
}

}  // namespace fourpost
