#include "identify/experiments/time_history/history_remark.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "identify/experiments/time_history/history_residuals.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kRate_Hz = 200;

/// A sweep from 1 to 6 Hz.
double Model(double t) { return std::sin(2 * std::numbers::pi * (1 + 0.25 * t) * t); }

/// What is told of a channel 'a' that was measured `factor` times the model, `delay_s` late, and is taken from
/// `source`.
std::string Told(double factor, double delay_s, const SourceChannel& source = {"a"},
                 const std::string& unit = "m/s^2") {
  Eigen::MatrixXd modelled(2000, 1);
  Eigen::VectorXd measured(2000);
  for (Eigen::Index k = 0; k < measured.size(); ++k) {
    const double t = static_cast<double>(k) / kRate_Hz;
    modelled(k, 0) = Model(t);
    measured[k] = factor * Model(t - delay_s);
  }
  const std::vector<MeasuredHistory> histories = {
      {.name = "sweep",
       .rate_Hz = kRate_Hz,
       .posts = {},
       .filter = {},
       .count = measured.size(),
       .signals = {{.name = "a", .unit = unit, .values = measured, .source = {.channels = {source}}}}}};
  const std::vector<Eigen::MatrixXd> models = {modelled};
  std::string told;
  for (const HistoryRemark& remark :
       RemarksOn(HistoryMisfits(histories, models), 1 / kRate_Hz, RemediedErrors(histories, models)))
    told += remark.message + '\n';
  return told;
}

/// As a number, from "its error would be X %".
double Promised(const std::string& told) {
  const std::string before = "its error would be ";
  const std::size_t at = told.find(before);
  return at == std::string::npos ? NAN : std::stod(told.substr(at + before.size()));
}

/// Of interpolation, of a hundred samples a period and three digits of a scale.
constexpr double kNothing_percent = 0.1;

TEST(HistoryRemark, SaysNothingOfWhatFits) {
  EXPECT_EQ(Told(1, 0), "");
  EXPECT_EQ(Told(1.2, 0), "");
}

TEST(HistoryRemark, TurnsASignAlone) {
  const std::string told = Told(-1, 0);
  EXPECT_THAT(told, AllOf(HasSubstr("as if its sign were wrong"), HasSubstr("'a: {channel: a, sign: -1}'")));
  EXPECT_LT(Promised(told), kNothing_percent);
}

// What the sign alone leaves is told: (1 - 1/1.15)^2 of the channel's square.
TEST(HistoryRemark, PromisesWhatTheSignAloneGives) {
  const std::string told = Told(-1.15, 0);
  EXPECT_THAT(told, HasSubstr("'a: {channel: a, sign: -1}'"));
  EXPECT_NEAR(Promised(told), 100 * std::pow(1 - 1 / 1.15, 2), 0.05);  // two digits
}

// The sign alone would leave (1 - 1/0.4)^2, 225 %.
TEST(HistoryRemark, TellsAScaleWithTheSign) {
  const std::string told = Told(-0.4, 0);
  EXPECT_THAT(told, HasSubstr("'a: {channel: a, sign: -1, scale: 2.5}'"));
  EXPECT_LT(Promised(told), kNothing_percent);
}

TEST(HistoryRemark, TellsADelayWithTheSign) {
  const std::string told = Told(-1, 0.03);
  EXPECT_THAT(told, HasSubstr("'a: {channel: a, sign: -1, delay: 30 ms}'"));
  EXPECT_LT(Promised(told), kNothing_percent);
}

TEST(HistoryRemark, TellsAScaleWithTheDelay) {
  const std::string late = Told(1, 0.03);
  EXPECT_THAT(late, AllOf(HasSubstr("comes 30 ms later"), HasSubstr("'a: {channel: a, delay: 30 ms}'")));
  EXPECT_LT(Promised(late), kNothing_percent);
  const std::string small = Told(0.4, 0.03);
  EXPECT_THAT(small, HasSubstr("'a: {channel: a, scale: 2.5, delay: 30 ms}'"));
  EXPECT_LT(Promised(small), kNothing_percent);
}

TEST(HistoryRemark, TellsAUnit) {
  EXPECT_THAT(Told(1 / 9.80665, 0), HasSubstr("(g told as m/s^2)"));
  EXPECT_THAT(Told(1 / 9.80665, 0), HasSubstr("'a: {channel: a, unit: g}'"));
  EXPECT_LT(Promised(Told(1 / 9.80665, 0)), kNothing_percent);
  EXPECT_THAT(Told(-1000, 0, {"a"}, "m"), HasSubstr("'a: {channel: a, unit: mm, sign: -1}'"));
}

SourceChannel Source(const std::string& unit, double factor) {
  SourceChannel channel("a");
  channel.unit = unit;
  channel.factor = factor;
  return channel;
}

TEST(HistoryRemark, TakesBackTheUnitThatTheStudyTells) {
  EXPECT_THAT(Told(1e-3, 0, Source("mm", 1), "m"), AllOf(HasSubstr("(m told as mm)"), HasSubstr("unit: m}'")));
  EXPECT_LT(Promised(Told(1e-3, 0, Source("mm", 1), "m")), kNothing_percent);
}

// Twice the same conversion: a unit on top of the study's scale would change nothing.
TEST(HistoryRemark, TakesBackTheScaleThatTheStudyTells) {
  for (const std::string unit : {"m", "mm", ""})
    for (const double scale : {1e-3, 1e3}) {
      const std::string told = Told(scale, 0, Source(unit, scale), "m");
      EXPECT_THAT(told, AllOf(HasSubstr("as if the scale of the study were in it already"), Not(HasSubstr("scale: "))));
      EXPECT_THAT(told, HasSubstr(unit.empty() ? "'a: a'" : "'a: {channel: a, unit: " + unit + "}'"));
      EXPECT_LT(Promised(told), kNothing_percent);
    }
}

// A factor that no unit explains.
TEST(HistoryRemark, TellsAScale) {
  EXPECT_THAT(Told(50, 0), HasSubstr("'a: {channel: a, scale: 0.02}'"));
  EXPECT_LT(Promised(Told(50, 0)), kNothing_percent);
}

}  // namespace
}  // namespace fourpost
