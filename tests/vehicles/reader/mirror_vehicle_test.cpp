// A vehicle that is written out on one side and mirrored, against the one that is written out on both.
#include <algorithm>
#include <complex>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/vehicles/mirrored_axle.h"
#include "tests/vehicles/same_model.h"
#include "tests/vehicles/small_vehicle.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::mirror_vehicle_test {
namespace {

std::string NameOf(const Spring& spring) { return spring.Element(); }
std::string NameOf(const auto& element) { return element.name; }

template <typename T>
const T& Named(const std::vector<T>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const T& one) { return NameOf(one) == name; });
  if (found == all.end()) throw std::out_of_range("no '" + name + "'");
  return *found;
}

void ExpectSame(const Scalar& a, const Scalar& b) {
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.parameter, b.parameter);
  EXPECT_EQ(a.factor, b.factor);
}

/// Two vehicles that must hold the same elements, in any order. All numbers are the same text, so equal to the last
/// bit.
class Comparison {
 public:
  Comparison(const Vehicle& a, const Vehicle& b) : a_(a), b_(b) {}

  void Compare() const {
    ForEach(a_.links, b_.links, [](const Link& a, const Link& b) {
      ExpectSame(a.mass, b.mass);
      for (std::size_t i = 0; i < a.com.size(); ++i) ExpectSame(a.com[i], b.com[i]);
      for (std::size_t i = 0; i < a.inertia.size(); ++i) ExpectSame(a.inertia[i], b.inertia[i]);
      ASSERT_EQ(a.visuals.size(), b.visuals.size());
      for (std::size_t i = 0; i < a.visuals.size(); ++i) {
        EXPECT_EQ(a.visuals[i].pose.matrix(), b.visuals[i].pose.matrix());
        EXPECT_EQ(a.visuals[i].size, b.visuals[i].size);
        EXPECT_EQ(a.visuals[i].mesh_file, b.visuals[i].mesh_file);
      }
    });
    ForEach(a_.joints, b_.joints, [&](const Joint& a, const Joint& b) {
      EXPECT_EQ(a.type, b.type);
      EXPECT_EQ(LinkName(a_, a.parent), LinkName(b_, b.parent));
      EXPECT_EQ(LinkName(a_, a.child), LinkName(b_, b.child));
      EXPECT_EQ(a.pose.matrix(), b.pose.matrix());
      EXPECT_EQ(a.axis, b.axis);
    });
    CompareForces();
  }

 private:
  void CompareForces() const {
    ForEach(a_.springs, b_.springs, [&](const Spring& a, const Spring& b) {
      SameLine(a.line, b.line);
      ExpectSame(a.law.stiffness, b.law.stiffness);
    });
    ForEach(a_.dampers, b_.dampers, [&](const Damper& a, const Damper& b) {
      SameLine(a.line, b.line);
      ExpectSame(a.law.rebound, b.law.rebound);
    });
    ForEach(a_.bushings, b_.bushings, [&](const Bushing& a, const Bushing& b) {
      SamePoint(a.parent, b.parent);
      SamePoint(a.child, b.child);
      EXPECT_EQ(a.axes, b.axes);
      ExpectSame(a.stiffness[5], b.stiffness[5]);
    });
    ForEach(a_.tyres, b_.tyres, [&](const Tyre& a, const Tyre& b) {
      SamePoint(a.point, b.point);
      ExpectSame(a.damping, b.damping);
    });
    ForEach(a_.posts, b_.posts,
            [&](const Post& a, const Post& b) { EXPECT_EQ(TyreName(a_, a.tyre), TyreName(b_, b.tyre)); });
    const auto same_ends = [&](const auto& a, const auto& b) {
      SamePoint(a.parent, b.parent);
      SamePoint(a.child, b.child);
    };
    ForEach(a_.rods, b_.rods, same_ends);
    ForEach(a_.balls, b_.balls, same_ends);
    ForEach(a_.sensors, b_.sensors, [&](const Sensor& a, const Sensor& b) {
      EXPECT_EQ(a.type, b.type);
      EXPECT_EQ(a.axis, b.axis);
      SamePoint(a.point, b.point);
      SameLine(a.line, b.line);
      EXPECT_EQ(TyreName(a_, a.tyre), TyreName(b_, b.tyre));
    });
  }

  template <typename T, typename Compare>
  static void ForEach(const std::vector<T>& a, const std::vector<T>& b, Compare compare) {
    ASSERT_EQ(a.size(), b.size());
    for (const T& one : a) {
      SCOPED_TRACE(NameOf(one));
      compare(one, Named(b, NameOf(one)));
    }
  }

  static std::string LinkName(const Vehicle& vehicle, int link) {
    return link < 0 ? "" : vehicle.links.at(static_cast<std::size_t>(link)).name;
  }
  static std::string TyreName(const Vehicle& vehicle, int tyre) {
    return tyre < 0 ? "" : vehicle.tyres.at(static_cast<std::size_t>(tyre)).name;
  }
  void SamePoint(const Point& a, const Point& b) const {
    EXPECT_EQ(LinkName(a_, a.link), LinkName(b_, b.link));
    EXPECT_EQ(a.xyz, b.xyz);
  }
  void SameLine(const ForceLine& a, const ForceLine& b) const {
    SamePoint(a.parent, b.parent);
    SamePoint(a.child, b.child);
    EXPECT_EQ(a.axis, b.axis);
  }

  const Vehicle& a_;
  const Vehicle& b_;
};

class MirrorVehicle : public VehicleFileTest {};

TEST_F(MirrorVehicle, EqualsTheOneWrittenOut) {
  const Vehicle whole = Read(Axle(kLeft | kRight)).value();
  const Vehicle mirrored = Read(Axle(kLeft, kMirror)).value();
  Comparison(whole, mirrored).Compare();
  const CondensedModel a = CondensedVehicle(whole).At(whole.ParameterValues());
  const CondensedModel b = CondensedVehicle(mirrored).At(mirrored.ParameterValues());
  EXPECT_EQ(a.mass.rows(), 4);
  ExpectSameModel(a, b);
}

TEST_F(MirrorVehicle, EqualsTheOneMirroredBack) {
  const Vehicle whole = Read(Axle(kLeft | kRight)).value();
  Comparison(whole, Read(Axle(kRight, R"(<fp:mirror from="_right" to="_left"/>)")).value()).Compare();
}

/// Sensor readings for posts that move as `post` at one frequency, without dampers.
Eigen::VectorXcd Readings(const CondensedModel& model, const Eigen::VectorXcd& post) {
  const std::complex<double> s(0, 30);
  const Eigen::MatrixXcd dynamic = model.mass * (s * s) + model.damping * s + model.stiffness;
  const Eigen::VectorXcd motion = dynamic.lu().solve((model.post_stiffness + model.post_damping * s) * post);
  return (model.on_position + model.on_velocity * s + model.on_acceleration * (s * s)) * motion +
         (model.on_post_height + model.on_post_velocity * s) * post;
}

// What the mirror must do, whatever its rules: both sides move alike when driven alike, and opposite when opposite.
TEST_F(MirrorVehicle, MovesAlikeOnBothSides) {
  const Vehicle vehicle = Read(Axle(kLeft, kMirror)).value();
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const Eigen::VectorXcd heave = Readings(model, Eigen::Vector2cd(1, 1));
  const Eigen::VectorXcd roll = Readings(model, Eigen::Vector2cd(1, -1));
  // Rounding of matrices whose condition is about 1e4.
  constexpr double kRounding = 1e-10;
  EXPECT_LT(std::abs(heave[0] - heave[1]), kRounding * std::abs(heave[1])) << "the body does not roll";
  EXPECT_LT(std::abs(roll[1]), kRounding * std::abs(roll[0])) << "the body does not heave";
  for (std::size_t i = 2; i < vehicle.sensors.size(); i += 2) {
    const auto left = static_cast<Eigen::Index>(i);
    EXPECT_GT(std::abs(heave[left]), 1e-3) << vehicle.sensors[i].name << " tells nothing";
    EXPECT_LT(std::abs(heave[left] - heave[left + 1]), kRounding * std::abs(heave[left])) << vehicle.sensors[i].name;
    EXPECT_LT(std::abs(roll[left] + roll[left + 1]), kRounding * std::abs(roll[left])) << vehicle.sensors[i].name;
  }
}

TEST_F(MirrorVehicle, HasTheLinesOfWhatItMirrors) {
  const std::string text = Axle(kLeft, kMirror);
  const Vehicle vehicle = Read(text).value();
  EXPECT_EQ(Named(vehicle.links, "hub_right").line, LineOf(text, R"(<link name="hub_left")"));
  EXPECT_EQ(vehicle.tyres.at(1).name, "tyre_right");
  EXPECT_EQ(vehicle.tyres.at(1).source_line, LineOf(text, "<fp:tyre"));
}

TEST_F(MirrorVehicle, FollowsNewValues) {
  const std::string text = Axle(kLeft, kMirror);
  const Vehicle vehicle = Read(text).value();
  const std::vector<double> values = {70e3, 12, 0.004, 0.016};
  const std::string rewritten = VehicleTextWithValues(vehicle, values, folder_);
  std::string expected = Replaced(text, R"(value="80 N/mm")", R"(value="70 N/mm")");
  expected = Replaced(expected, R"(value="10 kg")", R"(value="12 kg")");
  expected = Replaced(expected, R"(<mass value="20"/>)", R"(<mass value="24"/>)");
  expected = Replaced(expected, "0.005 kg", "0.004 kg");
  expected = Replaced(expected, R"(ixy="0.01")", R"(ixy="0.008")");
  expected = Replaced(expected, R"(value="15 mm")", R"(value="16 mm")");
  expected = Replaced(expected, R"(<origin xyz="0 0.03 0"/>)", R"(<origin xyz="0 0.032 0"/>)");
  EXPECT_EQ(rewritten, expected);
  const Vehicle again = Read(rewritten).value();
  EXPECT_EQ(again.ParameterValues(), values);
  EXPECT_EQ(Named(again.links, "hub_right").mass.value, 24);
  EXPECT_EQ(Named(again.links, "knuckle_right").inertia[3].value, -0.008);
  EXPECT_EQ(Named(again.links, "knuckle_right").com[1].value, -0.032);
}

TEST_F(MirrorVehicle, TakesAWrittenTwin) {
  const std::string stiff =
      R"(<fp:tyre name="tyre_right" link="hub_right" xyz="0 -0.02 0" stiffness="300 kN/m"/>)" + kMirror;
  const Vehicle vehicle = Read(Axle(kLeft, stiff)).value();
  ASSERT_EQ(vehicle.tyres.size(), 2U);
  EXPECT_EQ(vehicle.tyres[1].law.stiffness.value, 3e5);
  EXPECT_EQ(vehicle.posts.at(1).tyre, 1);
}

}  // namespace
}  // namespace fourpost::mirror_vehicle_test
