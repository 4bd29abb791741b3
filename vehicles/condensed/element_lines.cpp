#include "vehicles/condensed/element_lines.h"

#include <algorithm>
#include <array>
#include <utility>

#include "vehicles/loops/chart.h"
#include "vehicles/multibody/kinematics.h"
#include "vehicles/multibody/multibody.h"

namespace fourpost {
namespace {

bool ActsAlike(const ElementLine& a, const ElementLine& b) {
  constexpr double kSame = 1e-9;
  return a.kind == b.kind && a.post == b.post && (a.direction - b.direction).norm() <= kSame * a.direction.norm();
}

void AddLine(ElementLine line, std::vector<ElementLine>& lines) {
  if (line.direction.isZero(0)) return;
  const auto same = std::find_if(lines.begin(), lines.end(), [&](const auto& other) { return ActsAlike(line, other); });
  if (same == lines.end()) lines.push_back(std::move(line));
}

std::string CalledLine(const char* noun, const std::string& name) { return std::string(noun) + " '" + name + "'"; }

void AddTyreLines(const Vehicle& vehicle, const Kinematics& pose, std::vector<ElementLine>& lines) {
  for (std::size_t t = 0; t < vehicle.tyres.size(); ++t) {
    const Tyre& tyre = vehicle.tyres[t];
    ElementLine line{.kind = ElementLine::Kind::kTyre,
                     .name = tyre.name,
                     .called = CalledLine("tyre", tyre.name),
                     .direction = pose.FootPosition(tyre, -Eigen::Vector3d::UnitZ()).gradient};
    for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
      if (vehicle.posts[p].tyre == static_cast<int>(t)) line.post = static_cast<int>(p);
    AddLine(std::move(line), lines);
  }
}

void AddBushingLines(const Vehicle& vehicle, const Kinematics& pose, std::vector<ElementLine>& lines) {
  constexpr std::array kAxes = {"x", "y", "z"};
  for (const Bushing& bushing : vehicle.bushings) {
    const std::array<Coordinate, 6> place = pose.BushingPlace(bushing, pose.ChildAxes(bushing));
    for (std::size_t k = 0; k < kAxes.size(); ++k)
      AddLine({.kind = ElementLine::Kind::kBushing,
               .name = bushing.name,
               .called = CalledLine("bushing", bushing.name) + " along " + kAxes[k],
               .direction = place[k].gradient},
              lines);
  }
}

}  // namespace

std::vector<ElementLine> ElementLines(const Vehicle& vehicle) {
  Multibody multibody(vehicle);
  Chart chart(multibody);
  const Kinematics pose(multibody, chart.MoveTo(Eigen::VectorXd::Zero(chart.size())));
  std::vector<ElementLine> lines;
  for (const Damper& damper : vehicle.dampers)
    AddLine({.name = damper.name,
             .called = CalledLine("damper", damper.name),
             .direction = pose.LineLength(damper.line).gradient},
            lines);
  for (const Spring& spring : vehicle.springs)
    AddLine({.name = spring.name,
             .called = CalledLine("spring", spring.name),
             .direction = pose.LineLength(spring.line).gradient},
            lines);
  AddTyreLines(vehicle, pose, lines);
  for (const AntiRollBar& bar : vehicle.antiroll_bars)
    AddLine({.kind = ElementLine::Kind::kBar,
             .name = bar.name,
             .called = CalledLine("anti-roll bar", bar.name),
             .direction = pose.Twist(bar).gradient},
            lines);
  AddBushingLines(vehicle, pose, lines);
  return lines;
}

}  // namespace fourpost
