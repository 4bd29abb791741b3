// Forces that are planted, by their own formulas, into the motion of a quarter car: each is named, and nothing else is.
#include "identify/missing_force/force_explanation.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <Eigen/LU>

#include "identify/missing_force/force_parts.h"
#include "identify/missing_force/joint_amounts.h"
#include "identify/search/draws.h"

namespace fourpost::force_explanation_test {
namespace {

using Complex = std::complex<double>;
using Kind = ForceMechanism::Kind;
using std::numbers::pi;

constexpr double kBody = 300;     // kg
constexpr double kWheel = 40;     // kg
constexpr double kSpring = 20e3;  // N/m
constexpr double kDamper = 1500;  // N s/m
constexpr double kTyre = 200e3;   // N/m
/// Of each coordinate, real and imaginary part.
constexpr double kNoise_m = 2e-6;

/// A missing force on body and wheel by their motion and the frequency in rad/s.
using Planted = std::function<Eigen::Vector2cd(const Eigen::Vector2cd&, double)>;

Eigen::Matrix2cd Impedance(double w) {
  const Complex strut(kSpring, w * kDamper);
  Eigen::Matrix2cd impedance;
  impedance << strut - w * w * kBody, -strut, -strut, strut + kTyre - w * w * kWheel;
  return impedance;
}

Eigen::VectorXd Stacked(const Eigen::VectorXcd& force) {
  Eigen::VectorXd all(2 * force.size());
  all << force.real(), force.imag();
  return all;
}

LinkMotion LinkOf(const char* name, double mass, Eigen::Index coordinate) {
  LinkMotion link{.name = name, .mass = mass, .inertia = {}, .com = Eigen::Vector3d::Zero()};
  link.com_jacobian = link.spin_jacobian = Eigen::MatrixXd::Zero(3, 2);
  link.com_jacobian(2, coordinate) = 1;
  return link;
}

/// The tyre's rate is free: what a spring beside it would do, the fit has found already.
ForceRecord RecordOf(const Planted& planted, double noise_m = kNoise_m) {
  ForceRecord record{
      .runs = {"heave"}, .coordinates = {}, .lines = {}, .links = {}, .samples = {}, .not_measured = {{}}};
  record.coordinates = {{.name = "body", .shape = Eigen::Vector2d(1, 0)},
                        {.name = "wheel", .shape = Eigen::Vector2d(0, 1)}};
  record.lines = {{.name = "damper", .called = "damper 'damper'", .direction = Eigen::Vector2d(1, -1)},
                  {.kind = ElementLine::Kind::kTyre,
                   .name = "tyre",
                   .called = "tyre 'tyre'",
                   .direction = Eigen::Vector2d(0, -1),
                   .post = 0}};
  record.links = {LinkOf("body", kBody, 0), LinkOf("wheel", kWheel, 1)};
  Draws draws(1, DrawPurpose::kNoise, 0, 0);
  const auto noise = [&] { return Complex(noise_m * draws.Normal(), noise_m * draws.Normal()); };
  for (int k = 0; k < 40; ++k) {
    ForceSample sample{.frequency_Hz = 0.6 * std::pow(30.0, k / 39.0)};
    const double w = sample.omega();
    sample.amplitude_m = std::min({0.012, 0.15 / w, 6 / (w * w)});
    sample.posts = Eigen::VectorXcd::Constant(1, sample.amplitude_m);
    const Eigen::Matrix2cd impedance = Impedance(w);
    const Eigen::Vector2cd motion = impedance.inverse() * Eigen::Vector2cd(0, kTyre * sample.amplitude_m);
    const Eigen::Vector2cd off(noise(), noise());
    sample.motion = motion + off;
    sample.modelled = motion;
    sample.overtones = Eigen::MatrixXcd::Zero(3, 2);
    sample.force = planted(motion, w) + impedance * off;
    sample.slope.resize(4, 4);
    sample.slope << impedance.real(), -impedance.imag(), impedance.imag(), impedance.real();
    sample.information = Eigen::Matrix2d::Identity() / (noise_m * noise_m);
    const double percent = 0.01 * kTyre;
    sample.by_parameters = Stacked(Eigen::Vector2cd(0, percent * (sample.amplitude_m - motion[1])));
    sample.nuisance = sample.by_parameters;
    record.samples.push_back(std::move(sample));
  }
  return record;
}

Complex Extension(const Eigen::Vector2cd& motion) { return motion[0] - motion[1]; }

/// A tension of the strut, positive where it pulls its ends together.
Eigen::Vector2cd ByTension(Complex tension) { return Eigen::Vector2cd(-1, 1) * tension; }

ForceExplanation OnlyOne(const Planted& planted) {
  const ForceExplanations explained = ExplainForce(RecordOf(planted));
  EXPECT_EQ(explained.found.size(), 1U);
  return explained.found.empty() ? ForceExplanation() : explained.found.front();
}

/// Three standard deviations, and this share of it.
void ExpectNear(const ForceExplanation& one, double planted, double share = 0) {
  EXPECT_NEAR(one.amount, planted, 3 * one.sd + share * planted);
  EXPECT_LT(one.sd, 0.1 * planted);
}

void ExpectAmount(const ForceExplanation& one, double planted, double share = 0) {
  ExpectNear(one, planted, share);
  EXPECT_GT(one.share, 0.9);
}

TEST(ForceExplanation, IsNoneOfNoise) {
  const ForceExplanations explained =
      ExplainForce(RecordOf([](const Eigen::Vector2cd&, double) { return Eigen::Vector2cd(0, 0); }));
  EXPECT_TRUE(explained.found.empty());
  // The root mean square of 160 normal numbers is within three standard deviations, 3 / sqrt(320), of one.
  EXPECT_NEAR(explained.misfit, 1, 0.17);
}

TEST(ForceExplanation, NamesStiffness) {
  const ForceExplanation one =
      OnlyOne([](const Eigen::Vector2cd& motion, double) { return ByTension(3e3 * Extension(motion)); });
  EXPECT_EQ(one.mechanism.kind, Kind::kSpring);
  EXPECT_EQ(one.mechanism.lines, std::vector<std::size_t>{0});
  ExpectAmount(one, 3e3);
}

TEST(ForceExplanation, NamesDamping) {
  const ForceExplanation one = OnlyOne(
      [](const Eigen::Vector2cd& motion, double w) { return ByTension(Complex(0, 200 * w) * Extension(motion)); });
  EXPECT_EQ(one.mechanism.kind, Kind::kDamper);
  ExpectAmount(one, 200);
}

// The first harmonic of a rectangle of height 1 is 4 / pi.
TEST(ForceExplanation, NamesFriction) {
  const ForceExplanation one = OnlyOne([](const Eigen::Vector2cd& motion, double) {
    return ByTension(Complex(0, 4 / pi * 80) * Extension(motion) / std::abs(Extension(motion)));
  });
  EXPECT_EQ(one.mechanism.kind, Kind::kFriction);
  EXPECT_EQ(one.mechanism.lines, std::vector<std::size_t>{0});
  // Its step is 2 mm/s wide, of rates of some 100 mm/s.
  ExpectAmount(one, 80, 0.02);
}

// What a damper with a knee at 20 mm/s has above one without: at the rig's speeds nearly a constant force.
TEST(ForceExplanation, CallsDigressionAtSmallSpeedsFriction) {
  constexpr double kKnee = 0.02;
  constexpr double kRate = 3000;
  const ForceExplanation one = OnlyOne([](const Eigen::Vector2cd& motion, double w) {
    const double speed = w * std::abs(Extension(motion));
    // First harmonic of a saturated sine.
    const double s = std::min(1.0, kKnee / speed);
    const double gain = 2 / pi * (std::asin(s) + s * std::sqrt(1 - s * s));
    return ByTension(Complex(0, kRate * gain * w) * Extension(motion));
  });
  EXPECT_EQ(one.mechanism.kind, Kind::kFriction);
  ExpectAmount(one, kRate * kKnee, 0.1);
}

TEST(ForceExplanation, NamesMass) {
  const ForceExplanation one =
      OnlyOne([](const Eigen::Vector2cd& motion, double w) { return Eigen::Vector2cd(20 * w * w * motion[0], 0); });
  EXPECT_EQ(one.mechanism.kind, Kind::kAddedMass);
  EXPECT_EQ(one.mechanism.link, 0U);
  ExpectAmount(one, 20);
}

TEST(ForceExplanation, NamesAPartOnMounts) {
  const ForceExplanation one = OnlyOne([](const Eigen::Vector2cd& motion, double w) {
    const double r = w / (2 * pi * 9);
    const Complex loss(0, 2 * 0.1 * r);
    return Eigen::Vector2cd(40 * w * w * motion[0] * (1.0 + loss) / (1 - r * r + loss), 0);
  });
  EXPECT_EQ(one.mechanism.kind, Kind::kPartOnMounts);
  EXPECT_NEAR(one.mechanism.frequency_Hz, 9, 0.1);
  EXPECT_NEAR(one.mechanism.damping_ratio, 0.1, 0.02);
  ExpectAmount(one, 40, 0.02);
}

// One wrong reading looks best like a part that resonates there.
TEST(ForceExplanation, NamesNothingByOneFrequencyButSaysWhereItIs) {
  ForceRecord record = RecordOf([](const Eigen::Vector2cd&, double) { return Eigen::Vector2cd(0, 0); });
  ForceSample& wrong = record.samples[25];
  wrong.force += Eigen::Vector2cd(Complex(300, -200), Complex(0, 100));
  const ForceExplanations explained = ExplainForce(record);
  EXPECT_TRUE(explained.found.empty());
  ASSERT_TRUE(explained.left.has_value());
  EXPECT_EQ(explained.left->frequency_Hz, wrong.frequency_Hz);
  EXPECT_EQ(explained.left->lower_Hz, wrong.frequency_Hz);
  EXPECT_EQ(explained.left->upper_Hz, wrong.frequency_Hz);
}

/// What is named of a part of this mass on mounts in the body, at a twentieth of the noise.
std::vector<ForceExplanation> NamedOfPart(double mass) {
  const auto planted = [mass](const Eigen::Vector2cd& motion, double w) {
    const double r = w / (2 * pi * 9);
    const Complex loss(0, 2 * 0.1 * r);
    return Eigen::Vector2cd(mass * w * w * motion[0] * (1.0 + loss) / (1 - r * r + loss), 0);
  };
  return ExplainForce(RecordOf(planted, kNoise_m / 20)).found;
}

// A reading's gain may be off by a mass of the same size.
TEST(ForceExplanation, NamesNoPartThatIsNothingBesideItsBody) {
  constexpr double kLeast = kLeastShareOfMass * kBody;
  const std::vector<ForceExplanation> heavier = NamedOfPart(2 * kLeast);
  ASSERT_EQ(heavier.size(), 1U);
  EXPECT_EQ(heavier[0].mechanism.kind, Kind::kPartOnMounts);
  ExpectAmount(heavier[0], 2 * kLeast, 0.02);
  for (const ForceExplanation& one : NamedOfPart(0.7 * kLeast))
    EXPECT_FALSE(one.mechanism.kind == Kind::kPartOnMounts && one.mechanism.link == 0) << one.amount << " kg";
}

TEST(ForceExplanation, IsNoneOfWhatAFreeParameterCanDo) {
  const ForceExplanations explained = ExplainForce(RecordOf([](const Eigen::Vector2cd& motion, double w) {
    const double amplitude = std::min({0.012, 0.15 / w, 6 / (w * w)});
    return Eigen::Vector2cd(0, 0.01 * kTyre * (amplitude - motion[1]));
  }));
  EXPECT_TRUE(explained.found.empty());
}

// A car cannot lack less than nothing.
TEST(ForceExplanation, IsNoneOfTooMuchStiffness) {
  for (const ForceExplanation& one : ExplainForce(RecordOf([](const Eigen::Vector2cd&motion, double) {
                                       return ByTension(-3e3 * Extension(motion));
                                     })).found)
    EXPECT_NE(one.mechanism.kind, Kind::kSpring);
}

/// Springs at two places along nearly the same line, of which there is one.
TEST(JointAmounts, KeepOneOfTwoThatDoTheSame) {
  ForceRecord record =
      RecordOf([](const Eigen::Vector2cd& motion, double) { return ByTension(3e3 * Extension(motion)); });
  record.lines.push_back({.name = "other", .called = "damper 'other'", .direction = Eigen::Vector2d(1, -1.0001)});
  const auto spring = [](std::size_t line) {
    return ForceExplanation{.mechanism = {.kind = Kind::kSpring, .lines = {line}}};
  };
  WeighedForces both(record);
  for (const std::size_t line : {0, 2}) both.TakeOut(spring(line).mechanism);
  const auto [amounts, covariance] = both.Amounts();
  // Beside each other both are below three standard deviations.
  for (const Eigen::Index i : {0, 1}) ASSERT_LT(amounts[i], 3 * std::sqrt(covariance(i, i)));

  std::vector<ForceExplanation> found = {spring(0), spring(2)};
  const WeighedForces rest = EstimateTogether(record, found);
  ASSERT_EQ(found.size(), 1U);
  ExpectNear(found.front(), 3e3);
  // As of noise, see IsNoneOfNoise.
  EXPECT_NEAR(std::sqrt(rest.Squares() / rest.degrees()), 1, 0.17);
}

TEST(ForceParts, AreThoseOfEachElement) {
  const double w = 2 * pi * 3;
  ForceCurve curve{.of = "damper 'damper'", .is_line = true, .frequency_Hz = {3}, .force_sd = {1}};
  curve.motion = {std::polar(2e-3, 0.7)};
  curve.force = {5e3 * curve.motion[0] + Complex(0, 400 * w) * curve.motion[0]};
  const ForceParts parts = PartsOf(curve, 0);
  // Rounding.
  EXPECT_NEAR(parts.stiffness, 5e3, 1e-9);
  EXPECT_NEAR(parts.damping, 400, 1e-10);
  EXPECT_NEAR(parts.friction, pi / 4 * 400 * w * 2e-3, 1e-12);
  EXPECT_NEAR(parts.mass, -5e3 / (w * w), 1e-11);
}

}  // namespace
}  // namespace fourpost::force_explanation_test
