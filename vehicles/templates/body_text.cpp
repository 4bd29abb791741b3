#include "vehicles/templates/body_text.h"

#include <algorithm>

#include "analysis/text/number.h"
#include "vehicles/templates/axle_writer.h"
#include "vehicles/templates/written_xml.h"

namespace fourpost {
namespace {

/// Of the centre of mass of a passenger car with two people, above the ground.
constexpr double kBodyHeight = 0.55;

/// A body of a model, with its source. Its yaw inertia follows the one in pitch. Bounds keep it a possible body, whose
/// largest moment is at most the sum of the others: with r = |I_yaw - I_pitch| / I_roll, a = (1 + r) / 2 of I_roll and
/// b = (3 - r) / 2 of I_pitch at the other's bound, a - b r = (1 - r)^2 / 2.
std::string KnownBodyText(const KnownBody& body, const std::string& source) {
  const auto bounded = [&](const char* name, double value, double lower, double upper, const char* unit,
                           const char* what) {
    return Text({.name = name,
                 .value = value,
                 .lower = lower * value,
                 .upper = upper * value,
                 .precision = 0.1,
                 .unit = unit,
                 .source = source + ": " + what});
  };
  std::string text = bounded("m_body", body.mass, 0.7, 1.3, "kg", "chassis with all that is fixed to it");
  const double x = std::round(1e4 * body.com.x()) * 0.1;
  text += Text({.name = "x_body",
                .value = x,
                .lower = x - 300,
                .upper = x + 300,
                .precision = 0.1,
                .unit = "mm",
                .source = source + ": centre of mass"});
  const double r = std::min(0.9, std::abs(body.inertia(2, 2) - body.inertia(1, 1)) / body.inertia(0, 0));
  text += bounded("I_pitch", body.inertia(1, 1), 0.6, 0.5 * (3 - r), "kg*m^2", "chassis; the yaw inertia follows it");
  return text + bounded("I_roll", body.inertia(0, 0), 0.5 * (1 + r), 1.5, "kg*m^2", "chassis");
}

/// Of the body as the tree states it.
struct BodyNumbers {
  double wheelbase = 0;
  double track = 0;
  double mass = 0;
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  double pitch = 0;
  double roll = 0;
};

BodyNumbers NumbersOf(const CarPoints& car, const BodyGuess& body) {
  const Eigen::Vector3d front = car[0].At("wheel_centre");
  const Eigen::Vector3d rear = car[1].At("wheel_centre");
  const double guessed_z = 0.5 * (car[0].At("contact").z() + car[1].At("contact").z()) + kBodyHeight;
  BodyNumbers numbers{.wheelbase = front.x() - rear.x(),
                      .track = front.y() + rear.y(),
                      .mass = std::round(10 * body.mass) * 0.1,
                      .com = {std::round(1e4 * body.x) * 1e-4, body.known ? body.known->com.y() : 0,
                              std::round(1e3 * (body.known ? body.known->com.z() : guessed_z)) * 1e-3}};
  // Dynamic index 0.9; radius of gyration in roll 0.38 of the mean track.
  const double x = numbers.com.x();
  numbers.pitch = std::round(0.9 * numbers.mass * (front.x() - x) * (x - rear.x()));
  numbers.roll = std::round(numbers.mass * 0.38 * 0.38 * numbers.track * numbers.track);
  return numbers;
}

/// Attributes of the inertia beside those in roll and pitch.
std::string OtherMoments(const std::optional<KnownBody>& known) {
  if (!known) return "izz=\"$I_pitch\" ixy=\"0\" ixz=\"0\" iyz=\"0\"";
  return "izz=\"" + Fixed(known->inertia(2, 2) / known->inertia(1, 1), 6) + "*$I_pitch\" ixy=\"" +
         Fixed(known->inertia(0, 1), 2) + "\" ixz=\"" + Fixed(known->inertia(0, 2), 2) + "\" iyz=\"" +
         Fixed(known->inertia(1, 2), 2) + "\"";
}

std::string LinkText(const BodyNumbers& numbers, const BodyGuess& body) {
  const std::string y = body.known ? Fixed(numbers.com.y(), 4) : "0";
  const double z = numbers.com.z();
  const std::string head = body.known
                               ? "\n  <!-- Body; its axes and origin are those of the model. -->\n"
                               : "\n  <!-- Body with engine and two people; its axes and origin are those of the "
                                 "drawing. -->\n";
  return head + "  <link name=\"ground\"/>\n  <link name=\"body\">\n    <inertial>\n      <origin xyz=\"$x_body " + y +
         " " + Fixed(z, 3) + "\"/>\n      <mass value=\"$m_body\"/>\n      <inertia ixx=\"$I_roll\" iyy=\"$I_pitch\" " +
         OtherMoments(body.known) + "/>\n    </inertial>\n    <visual>\n      <origin xyz=\"" +
         XyzText({numbers.com.x(), 0, z + 0.05}) + "\"/>\n      <geometry><box size=\"" +
         Fixed(numbers.wheelbase + 1, 2) + " " + Fixed(0.5 * numbers.track, 2) +
         " 0.4\"/></geometry>\n    </visual>\n  </link>\n";
}

std::string JointText(const GroundPose& ground) {
  return "  <joint name=\"body\" type=\"floating\">\n    <parent link=\"ground\"/><child link=\"body\"/><origin "
         "xyz=\"0 0 " +
         Fixed(ground.rise, 9) + "\"" +
         (std::abs(ground.pitch) > 1e-9 ? " rpy=\"0 " + Fixed(ground.pitch, 9) + " 0\"" : "") + "/>\n  </joint>\n";
}

std::string GuessedMassText(const BodyNumbers& numbers, bool is_weighed) {
  std::string text =
      Text({.name = "m_body",
            .value = numbers.mass,
            .lower = std::round((is_weighed ? 0.95 : 0.6) * numbers.mass),
            .upper = std::round((is_weighed ? 1.05 : 2) * numbers.mass),
            .precision = 0.1,
            .unit = "kg",
            .source = is_weighed ? "loads of the axles, less an estimate of wheels and axles"
                                 : "estimate, of a passenger car: body with engine and two people; --load "
                                   "makes it of axle loads"});
  const double x = numbers.com.x();
  const double spread = std::round((is_weighed ? 30 : 150) * numbers.wheelbase);
  return text + Text({.name = "x_body",
                      .value = 1e3 * x,
                      .lower = std::round(1e3 * x - spread),
                      .upper = std::round(1e3 * x + spread),
                      .precision = 0.1,
                      .unit = "mm",
                      .source = is_weighed ? "centre of mass by the loads of the axles"
                                           : "estimate: centre of mass midway between the axles"});
}

std::string GuessedInertiaText(const BodyNumbers& numbers) {
  return Text({.name = "I_pitch",
               .value = numbers.pitch,
               .lower = std::round(0.5 * numbers.pitch),
               .upper = std::round(2 * numbers.pitch),
               .precision = 1,
               .unit = "kg*m^2",
               .source = "estimate: dynamic index 0.9, I / (m a b); the yaw inertia is as large"}) +
         Text({.name = "I_roll",
               .value = numbers.roll,
               .lower = std::round(0.5 * numbers.roll),
               .upper = std::round(1.8 * numbers.roll),
               .precision = 1,
               .unit = "kg*m^2",
               .source = "estimate: radius of gyration 0.38 of the track"});
}

}  // namespace

std::string Fixed(double value, int decimals) {
  return FormatNumber(std::round(value * std::pow(10, decimals)) + 0.0, -decimals);
}

std::string BodyText(const CarPoints& car, const BodyGuess& body, const GroundPose& ground, const std::string& origin) {
  const BodyNumbers numbers = NumbersOf(car, body);
  const std::string tree = LinkText(numbers, body) + JointText(ground);
  if (body.known) return tree + KnownBodyText(*body.known, origin);
  return tree + GuessedMassText(numbers, body.is_weighed) + GuessedInertiaText(numbers);
}

}  // namespace fourpost
