#include "identify/audit/rig_fault.h"

#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "identify/audit/free_wheelpans.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;
using Kind = RigFault::Kind;
using Where = RigFault::Where;

bool HasReadings(const Eigen::MatrixXcd& readings, Eigen::Index row) {
  for (const Complex& value : readings.row(row))
    if (std::isfinite(value.real())) return true;
  return false;
}

bool IsMeasured(const AuditSubject& subject, Where where, std::size_t member) {
  for (const AuditedRun& run : subject.runs)
    if (HasReadings(where == Where::kSensors ? run.motions : run.forces, static_cast<Eigen::Index>(member)))
      return true;
  return false;
}

const char* NameOf(Device device) {
  switch (device) {
    case Device::kAccelerometers: return "accelerometers";
    case Device::kStruts: return "struts";
    case Device::kDisplacements: return "displacements";
    case Device::kGyros: return "gyros";
    case Device::kLoadCells: return "load cells";
  }
  return "";
}

class FaultList {
 public:
  FaultList(const AuditSubject& subject, const RigTolerance& tolerance) : subject_(subject), tolerance_(tolerance) {}

  std::vector<RigFault> Make() {
    std::map<Device, std::vector<std::size_t>> devices;
    for (std::size_t s = 0; s < subject_.car.sensors.size(); ++s)
      if (IsMeasured(subject_, Where::kSensors, s)) devices[subject_.car.sensors[s].device].push_back(s);
    for (const auto& [device, members] : devices) AddDevice(Where::kSensors, NameOf(device), members);
    for (const auto& [device, members] : devices) AddPlaces(members);
    std::vector<std::size_t> cells;
    for (std::size_t t = 0; t < subject_.car.tyres.size(); ++t)
      if (IsMeasured(subject_, Where::kCells, t)) cells.push_back(t);
    AddDevice(Where::kCells, NameOf(Device::kLoadCells), cells);
    AddWheelpans(StatedWheelpans(subject_));
    AddPosts();
    if (!subject_.car.balance || cells.size() < subject_.car.tyres.size()) return std::move(faults_);
    if (subject_.weight)
      Add({.kind = Kind::kScale, .where = Where::kWeight, .name = "loads at rest", .allowed = tolerance_.weight});
    Add({.kind = Kind::kScale, .where = Where::kClock, .name = "frequency", .allowed = tolerance_.frequency});
    return std::move(faults_);
  }

 private:
  void Add(RigFault fault) { faults_.push_back(std::move(fault)); }

  std::string Name(Where where, std::size_t member) const {
    return where == Where::kSensors ? subject_.car.sensors[member].name : subject_.car.tyres[member].cell;
  }

  /// Each member, each pair, and all of them.
  void AddDevice(Where where, const std::string& device, const std::vector<std::size_t>& members) {
    for (const std::size_t member : members) {
      const std::string name = Name(where, member);
      Add({.kind = Kind::kScale, .where = where, .members = {member}, .name = name, .allowed = tolerance_.scale});
      Add({.kind = Kind::kDelay, .where = where, .members = {member}, .name = name, .allowed = tolerance_.delay});
    }
    for (std::size_t a = 0; a < members.size(); ++a)
      for (std::size_t b = a + 1; b < members.size(); ++b)
        Add({.kind = Kind::kExchange,
             .where = where,
             .members = {members[a], members[b]},
             .name = Name(where, members[a]) + " and " + Name(where, members[b])});
    if (members.size() < 2) return;
    const std::string all = "all " + device;
    Add({.kind = Kind::kScale, .where = where, .members = members, .name = all, .allowed = tolerance_.device_scale});
    Add({.kind = Kind::kDelay, .where = where, .members = members, .name = all, .allowed = tolerance_.device_delay});
  }

  void AddPlaces(const std::vector<std::size_t>& members) {
    for (const std::size_t member : members)
      for (int axis = 0; axis < 3; ++axis)
        if (subject_.car.sensors[member].motion_by_place[static_cast<std::size_t>(axis)].size() > 0)
          Add({.kind = Kind::kPlace,
               .where = Where::kSensors,
               .members = {member},
               .axis = axis,
               .name = subject_.car.sensors[member].name,
               .allowed = tolerance_.place});
  }

  /// Each, and the same mass under all; not those that a parameter sets, which are unknown anyway.
  void AddWheelpans(const std::vector<std::size_t>& cells) {
    const auto add = [&](std::vector<std::size_t> members, std::string name) {
      const double in_file = subject_.car.tyres[members.front()].wheelpan;
      Add({.kind = Kind::kWheelpan,
           .where = Where::kCells,
           .members = std::move(members),
           .name = std::move(name),
           .allowed = std::hypot(tolerance_.wheelpan, tolerance_.wheelpan_share * in_file)});
    };
    for (const std::size_t cell : cells) add({cell}, Name(Where::kCells, cell));
    if (cells.size() > 1) add(cells, std::string("all ") + NameOf(Device::kLoadCells));
  }

  void AddPosts() {
    std::vector<std::size_t> posts;
    for (const AuditedTyre& tyre : subject_.car.tyres) posts.push_back(tyre.post);
    Add({.kind = Kind::kScale,
         .where = Where::kPosts,
         .members = posts,
         .name = "posts",
         .allowed = tolerance_.device_scale});
    Add({.kind = Kind::kDelay,
         .where = Where::kPosts,
         .members = posts,
         .name = "posts",
         .allowed = tolerance_.device_delay});
  }

  const AuditSubject& subject_;
  const RigTolerance& tolerance_;
  std::vector<RigFault> faults_;
};

/// The rows of a run that a fault concerns.
Eigen::MatrixXcd& ReadingsOf(AuditedRun& run, Where where) {
  return where == Where::kSensors ? run.motions : where == Where::kCells ? run.forces : run.posts;
}

void Scale(AuditSubject& subject, const RigFault& fault, double value) {
  if (fault.where == Where::kWeight) subject.weight->measured *= 1 + value;
  for (AuditedRun& run : subject.runs) {
    if (fault.where == Where::kClock)
      for (double& frequency : run.frequency_Hz) frequency *= 1 + value;
    if (fault.where == Where::kWeight || fault.where == Where::kClock) continue;
    for (const std::size_t m : fault.members) {
      const auto row = static_cast<Eigen::Index>(m);
      ReadingsOf(run, fault.where).row(row) *= 1 + value;
      if (fault.where == Where::kSensors) run.motion_sd.row(row) *= std::abs(1 + value);
      if (fault.where == Where::kCells) run.force_sd.row(row) *= std::abs(1 + value);
    }
  }
}

void Hasten(AuditSubject& subject, const RigFault& fault, double value) {
  for (AuditedRun& run : subject.runs)
    for (const std::size_t m : fault.members)
      for (std::size_t f = 0; f < run.frequency_Hz.size(); ++f)
        ReadingsOf(run, fault.where)(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(f)) *=
            std::polar(1.0, 2 * std::numbers::pi * run.frequency_Hz[f] * value);
}

void TakeOutWheelpan(AuditSubject& subject, const RigFault& fault, double kg) {
  for (AuditedRun& run : subject.runs)
    for (const std::size_t m : fault.members)
      for (std::size_t f = 0; f < run.frequency_Hz.size(); ++f) {
        const auto at = static_cast<Eigen::Index>(f);
        const auto post = static_cast<Eigen::Index>(subject.car.tyres[m].post);
        run.forces(static_cast<Eigen::Index>(m), at) +=
            kg * std::pow(2 * std::numbers::pi * run.frequency_Hz[f], 2) * run.posts(post, at);
      }
}

void Exchange(AuditSubject& subject, const RigFault& fault) {
  const auto a = static_cast<Eigen::Index>(fault.members[0]);
  const auto b = static_cast<Eigen::Index>(fault.members[1]);
  for (AuditedRun& run : subject.runs) {
    ReadingsOf(run, fault.where).row(a).swap(ReadingsOf(run, fault.where).row(b));
    Eigen::MatrixXd& sd = fault.where == Where::kSensors ? run.motion_sd : run.force_sd;
    sd.row(a).swap(sd.row(b));
  }
}

void LeaveOut(AuditSubject& subject, const RigFault& fault) {
  for (AuditedRun& run : subject.runs)
    ReadingsOf(run, fault.where)
        .row(static_cast<Eigen::Index>(fault.members[0]))
        .setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

std::vector<RigFault> PossibleFaults(const AuditSubject& subject, const RigTolerance& tolerance) {
  return FaultList(subject, tolerance).Make();
}

AuditSubject Corrected(AuditSubject subject, const RigFault& fault, double value) {
  switch (fault.kind) {
    case Kind::kScale: Scale(subject, fault, value); break;
    case Kind::kDelay: Hasten(subject, fault, value); break;
    case Kind::kWheelpan: TakeOutWheelpan(subject, fault, value); break;
    case Kind::kExchange: Exchange(subject, fault); break;
    case Kind::kOther: LeaveOut(subject, fault); break;
    case Kind::kPlace: {
      AuditedSensor& sensor = subject.car.sensors[fault.members[0]];
      sensor.motion += value * sensor.motion_by_place[static_cast<std::size_t>(fault.axis)];
      break;
    }
  }
  return subject;
}

}  // namespace fourpost
