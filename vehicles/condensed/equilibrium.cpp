#include "vehicles/condensed/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/enumeration.h"
#include "analysis/text/found.h"
#include "analysis/text/number.h"
#include "vehicles/condensed/findings.h"
#include "vehicles/condensed/preload_map.h"

namespace fourpost {
namespace {

/// The part of a generalised force that no combination of the columns can take.
Eigen::VectorXd Rest(const Eigen::VectorXd& force, const Eigen::MatrixXd& columns) {
  if (columns.size() == 0) return force;
  return force - columns * LeastNorm(columns, kHeldShare).Solve(force);
}

bool IsHeld(const Eigen::VectorXd& direction, const Eigen::MatrixXd& columns) {
  return Rest(direction, columns).norm() <= kHeldShare * direction.norm();
}

/// Whether what the file gives is balanced at the file's values.
bool IsBalanced(const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders) {
  // Preloads may be typed with seven digits: that leaves the vehicle within 1e-6 of its static deflection, decimetres.
  constexpr double kTyped = 1e-6;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(holders.rows());
  double scale = 0;
  for (const GivenForce& force : forces) {
    sum += force.Force();
    scale += force.Force().norm();
  }
  return Rest(sum, holders).norm() <= kTyped * scale;
}

/// To a thousandth of a newton.
std::string RoundedText(double force) { return FormatNumber(std::round(force * 1e3) / 1e3 + 0.0); }

/// To a hundredth of a micrometre, so that what is pasted is balanced.
std::string LengthText(double length) { return FormatNumber(std::round(length * 1e8) / 1e8) + " m"; }

int LineOf(const Vehicle& vehicle, const std::string& link) {
  const auto found =
      std::find_if(vehicle.links.begin(), vehicle.links.end(), [&](const Link& l) { return l.name == link; });
  return found == vehicle.links.end() ? 0 : found->line;
}

/// "a, b and c", each once.
std::string Enumerated(const std::vector<std::string>& items) {
  std::vector<std::string> different;
  for (const std::string& item : items)
    if (std::find(different.begin(), different.end(), item) == different.end()) different.push_back(item);
  return Enumeration(different);
}

std::string EnumeratedLinks(std::vector<std::string> names) {
  for (std::string& name : names) name = "link '" + name + "'";
  return Enumerated(names);
}

/// Of a motion that nothing holds, the finding with the elements that its remedy names.
Found Unheld(const UnheldMotion& unheld, const std::string& what) {
  using Kind = IdleElement::Kind;
  const auto of_kind = [&](Kind kind) {
    std::vector<std::string> elements;
    for (const IdleElement& element : unheld.idle)
      if (element.kind == kind) elements.push_back(element.element);
    return Enumerated(elements);
  };
  if (const std::string bushings = of_kind(Kind::kBushing); !bushings.empty())
    return {bushings.find("'drake_bushing_") == std::string::npos ? &kUnheldBushing : &kUnheldDrakeBushing,
            {what, bushings}};
  if (const std::string dampers = of_kind(Kind::kDamper); !dampers.empty()) return {&kUnheldDamper, {what, dampers}};
  if (const std::string stops = of_kind(Kind::kStop); !stops.empty()) return {&kUnheldStop, {what, stops}};
  return {&kUnheld, {what}};
}

/// Motions that fp:mirror has made of one: its links keep their line.
bool AreTwins(const Vehicle& vehicle, const UnheldMotion& a, const UnheldMotion& b) {
  return a.motion.link != b.motion.link && a.motion.direction == b.motion.direction &&
         LineOf(vehicle, a.motion.link) == LineOf(vehicle, b.motion.link);
}

void Join(UnheldMotion& motion, const UnheldMotion& twin) {
  motion.alike.insert(motion.alike.end(), twin.alike.begin(), twin.alike.end());
  motion.fastest.insert(motion.fastest.end(), twin.fastest.begin(), twin.fastest.end());
  motion.idle.insert(motion.idle.end(), twin.idle.begin(), twin.idle.end());
}

std::vector<UnheldMotion> WithTwinsJoined(const Vehicle& vehicle, const std::vector<UnheldMotion>& motions) {
  std::vector<UnheldMotion> joined;
  for (const UnheldMotion& motion : motions) {
    const auto twin = std::find_if(joined.begin(), joined.end(),
                                   [&](const UnheldMotion& other) { return AreTwins(vehicle, motion, other); });
    if (twin == joined.end()) joined.push_back(motion);
    else Join(*twin, motion);
  }
  return joined;
}

std::string Text(const UnheldMotion& unheld) {
  const std::string what = Word(unheld.motion.direction) + " of " + EnumeratedLinks(unheld.alike);
  const std::vector<std::string>& fastest = unheld.fastest;
  if (std::find(fastest.begin(), fastest.end(), unheld.motion.link) != fastest.end()) return what;
  return what + ", in which " + EnumeratedLinks(fastest) + (fastest.size() > 1 ? " move most" : " moves most");
}

bool AreOfOneLine(const GivenForce& a, const GivenForce& b) {
  return a.kind == GivenForce::Kind::kPreload && b.kind == a.kind && a.line == b.line;
}

/// The size that the given preloads of one line, which mirror partners share, would have to have, the others as they
/// are; nothing where that does not help.
std::optional<double> BalancingSize(const GivenForce& preload, const StaticLoads& loads) {
  std::vector<GivenForce> forces = loads.forces;
  Eigen::VectorXd others = Eigen::VectorXd::Zero(preload.direction.size());
  Eigen::VectorXd together = others;
  for (const GivenForce& force : forces) {
    if (AreOfOneLine(force, preload)) together += force.direction;
    else others += force.Force();
  }
  const Eigen::VectorXd direction = Rest(together, loads.holders);
  const double size = -direction.dot(others) / direction.squaredNorm();
  for (GivenForce& force : forces)
    if (AreOfOneLine(force, preload)) force.size = size;
  if (!IsBalanced(forces, loads.holders)) return std::nullopt;
  return size;
}

/// Elements whose force follows parameter `index`, and that nothing holds.
std::string Followers(int index, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders) {
  std::string names;
  for (const GivenForce& force : forces) {
    const bool follows = std::find(force.parameters.begin(), force.parameters.end(), index) != force.parameters.end();
    if (!follows || IsHeld(force.direction, holders)) continue;
    const bool is_weight = force.kind == GivenForce::Kind::kWeight;
    names +=
        (names.empty() ? "" : " and ") + std::string(is_weight ? "the weight of " : "the preload of ") + force.element;
  }
  return names;
}

/// The first parameter with bounds whose other values would not be balanced; empty without any.
std::string Unbalancing(const Vehicle& vehicle, const StaticLoads& loads) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    if (parameter.lower < parameter.upper && !Followers(static_cast<int>(i), loads.forces, loads.holders).empty())
      return parameter.name;
  }
  return "";
}

Found Imbalance(const Vehicle& vehicle, const GivenForce& preload, const StaticLoads& loads) {
  const std::optional<double> size = BalancingSize(preload, loads);
  std::vector<std::string> words = {preload.element, RoundedText(preload.size) + " N",
                                    size ? ", " + RoundedText(*size) + " N would be" : ""};
  if (!preload.free_spring) return {&kPreloadUnbalanced, words};
  if (const std::string parameter = Unbalancing(vehicle, loads); !parameter.empty()) {
    words.push_back(parameter);
    return {&kFreeLengthFollows, words};
  }
  const std::optional<double> length = size ? preload.free_spring->FreeLengthFor(*size) : std::nullopt;
  if (!length) return {&kFreeLengthUnbalanced, words};
  words.push_back(LengthText(*length));
  return {&kFreeLengthWrong, words};
}

void Add(const Found& found, const Vehicle& vehicle, int line, Diagnostics& faults) {
  faults.Report(*found.kind, {vehicle.file, line}, found.words);
}

/// Motions that nothing holds; if there is none, the given preloads, of which one at least must be wrong.
void ReportImbalance(const Vehicle& vehicle, const StaticLoads& loads, Diagnostics& faults) {
  const std::vector<UnheldMotion> unheld = UnheldMotions(loads);
  for (const UnheldMotion& motion : WithTwinsJoined(vehicle, unheld))
    Add(Unheld(motion, Text(motion)), vehicle, LineOf(vehicle, motion.motion.link), faults);
  if (!unheld.empty()) return;
  // A stop has no preload to correct. Mirror partners share the line, which is reported once.
  std::set<int> reported;
  for (const GivenForce& force : loads.forces)
    if (force.kind == GivenForce::Kind::kPreload && (force.carries || force.size != 0) &&
        !IsHeld(force.direction, loads.holders) && reported.insert(force.line).second)
      Add(Imbalance(vehicle, force, loads), vehicle, force.line, faults);
}

void ReportFreeParameters(const Vehicle& vehicle, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders,
                          Diagnostics& faults) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    if (!(parameter.lower < parameter.upper)) continue;
    const std::string followers = Followers(static_cast<int>(i), forces, holders);
    if (followers.empty()) continue;
    faults.Report(kEquilibriumAtOneValue, {vehicle.file, parameter.line}, {parameter.name, followers});
  }
}

}  // namespace

void CheckEquilibrium(const Vehicle& vehicle, const StaticLoads& loads, Diagnostics& faults) {
  if (IsBalanced(loads.forces, loads.holders)) ReportFreeParameters(vehicle, loads.forces, loads.holders, faults);
  else ReportImbalance(vehicle, loads, faults);
}

}  // namespace fourpost
