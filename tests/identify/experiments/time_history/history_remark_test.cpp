#include "identify/experiments/time_history/history_remark.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_residuals.h"
#include "tests/findings.h"

namespace fourpost::history_remark_test {
namespace {

using testing::Not;

constexpr double kRate_Hz = 200;

/// A sweep from 1 to 6 Hz.
double Model(double t) { return std::sin(2 * std::numbers::pi * (1 + 0.25 * t) * t); }

/// What is reported of a channel 'a' that was measured `factor` times the model, `delay_s` late, and is taken from
/// `source`.
Diagnostics Remarks(double factor, double delay_s, const SourceChannel& source = {"a"},
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
  Diagnostics remarks;
  for (const HistoryRemark& remark :
       RemarksOn(HistoryMisfits(histories, models), 1 / kRate_Hz, RemediedErrors(histories, models)))
    remarks.Report(*remark.found.kind, {}, remark.found.words);
  return remarks;
}

/// The error with the remedy, the last percentage of the one remark.
double Promised(const Diagnostics& remarks) {
  if (remarks.items().size() != 1) return NAN;
  const std::string& message = remarks.items()[0].message;
  const std::size_t sign = message.rfind(" %");
  if (sign == std::string::npos) return NAN;
  const std::size_t blank = message.rfind(' ', sign - 1);
  return std::stod(message.substr(blank + 1));
}

/// Of interpolation, of a hundred samples a period and three digits of a scale.
constexpr double kNothing_percent = 0.1;

TEST(HistoryRemark, SaysNothingOfWhatFits) {
  EXPECT_EQ(Remarks(1, 0).Format(), "");
  EXPECT_EQ(Remarks(1.2, 0).Format(), "");
}

TEST(HistoryRemark, TurnsASignAlone) {
  const Diagnostics remarks = Remarks(-1, 0);
  EXPECT_THAT(remarks, Reports(kChannelInverted, 0, {"'a'", "'sweep'", "'a: {channel: a, sign: -1}'"}));
  EXPECT_LT(Promised(remarks), kNothing_percent);
}

// What the sign alone leaves: (1 - 1/1.15)^2 of the channel's square.
TEST(HistoryRemark, PromisesWhatTheSignAloneGives) {
  const Diagnostics remarks = Remarks(-1.15, 0);
  EXPECT_THAT(remarks, Reports(kChannelInverted, 0, {"'a: {channel: a, sign: -1}'"}));
  EXPECT_NEAR(Promised(remarks), 100 * std::pow(1 - 1 / 1.15, 2), 0.05);  // two digits
}

// The sign alone would leave (1 - 1/0.4)^2, 225 %.
TEST(HistoryRemark, GivesAScaleWithTheSign) {
  const Diagnostics remarks = Remarks(-0.4, 0);
  EXPECT_THAT(remarks, Reports(kChannelInverted, 0, {"'a: {channel: a, sign: -1, scale: 2.5}'"}));
  EXPECT_LT(Promised(remarks), kNothing_percent);
}

TEST(HistoryRemark, GivesADelayWithTheSign) {
  const Diagnostics remarks = Remarks(-1, 0.03);
  EXPECT_THAT(remarks, Reports(kChannelInverted, 0, {"'a: {channel: a, sign: -1, delay: 30 ms}'"}));
  EXPECT_LT(Promised(remarks), kNothing_percent);
}

TEST(HistoryRemark, GivesAScaleWithTheDelay) {
  const Diagnostics late = Remarks(1, 0.03);
  EXPECT_THAT(late, Reports(kChannelLateOfModel, 0, {"30 ms later", "'a: {channel: a, delay: 30 ms}'"}));
  EXPECT_LT(Promised(late), kNothing_percent);
  const Diagnostics small = Remarks(0.4, 0.03);
  EXPECT_THAT(small, Reports(kChannelLateOfModel, 0, {"'a: {channel: a, scale: 2.5, delay: 30 ms}'"}));
  EXPECT_LT(Promised(small), kNothing_percent);
}

/// Three channels that all come 30 ms later than the model, of a vehicle that `tension` moves beside its posts.
Diagnostics RemarksOfLateChannels(const std::vector<double>& tension) {
  Eigen::MatrixXd modelled(2000, 3);
  MeasuredHistory history{
      .name = "sweep", .rate_Hz = kRate_Hz, .posts = {}, .tensions = {tension}, .filter = {}, .count = 2000};
  for (const std::string name : {"a", "b", "c"}) {
    Eigen::VectorXd measured(2000);
    for (Eigen::Index k = 0; k < 2000; ++k) {
      const double t = static_cast<double>(k) / kRate_Hz;
      modelled.row(k).setConstant(Model(t));
      measured[k] = Model(t - 0.03);
    }
    history.signals.push_back({.name = name, .unit = "m", .values = measured, .source = {.channels = {{name}}}});
  }
  const std::vector<MeasuredHistory> histories = {history};
  const std::vector<Eigen::MatrixXd> models = {modelled};
  Diagnostics remarks;
  for (const HistoryRemark& remark :
       RemarksOn(HistoryMisfits(histories, models), 1 / kRate_Hz, RemediedErrors(histories, models)))
    remarks.Report(*remark.found.kind, {}, remark.found.words);
  return remarks;
}

// Mirrored, a release is one as well.
TEST(HistoryRemark, NamesBothSignsOfARelease) {
  Eigen::MatrixXd modelled(2000, 2);
  for (Eigen::Index k = 0; k < 2000; ++k) {
    const double t = static_cast<double>(k) / kRate_Hz;
    modelled(k, 0) = 0.045 * std::exp(-t) * std::cos(9 * t);
    modelled(k, 1) = -81 * modelled(k, 0);
  }
  const std::vector<MeasuredHistory> histories = {
      {.name = "drop",
       .rate_Hz = kRate_Hz,
       .posts = {},
       .filter = {},
       .release = Release(),
       .count = 2000,
       .signals = {{.name = "z", .unit = "m", .values = -modelled.col(0), .source = {.channels = {{"z"}}}},
                   {.name = "a", .unit = "m/s^2", .values = modelled.col(1), .source = {.channels = {{"a"}}}}}}};
  const std::vector<Eigen::MatrixXd> models = {modelled};
  Diagnostics remarks;
  for (const HistoryRemark& remark :
       RemarksOn(HistoryMisfits(histories, models), 1 / kRate_Hz, RemediedErrors(histories, models)))
    remarks.Report(*remark.found.kind, {}, remark.found.words);
  EXPECT_THAT(remarks, ReportsOnly(kReleaseSignsDisagree, 0,
                                   {"'z: {channel: z, sign: -1}' in the study if the vehicle was let go from 45",
                                    "mm above rest, 'a: {channel: a, sign: -1}' if from 45", "mm below rest"}));
}

// An actuator moves channels by more than posts do: what they have in common says nothing of the posts.
TEST(HistoryRemark, SuspectsPostsOnlyWhereTheyAloneMove) {
  EXPECT_THAT(RemarksOfLateChannels({5, 5, 5}), Reports(kPostsNotSynchronised, 0, {"30 ms later", "delay: -30 ms"}));
  EXPECT_THAT(RemarksOfLateChannels({5, -5, 5}), Not(Reports(kPostsNotSynchronised)));
}

// A model that another channel drew away by millions: what a scale leaves is the whole channel.
TEST(HistoryRemark, GivesNoScaleThatExplainsNothing) {
  Eigen::MatrixXd modelled(2000, 1);
  Eigen::VectorXd measured(2000);
  for (Eigen::Index k = 0; k < measured.size(); ++k) {
    const double t = static_cast<double>(k) / kRate_Hz;
    measured[k] = Model(t);
    modelled(k, 0) = 3e6 * std::sin(2 * std::numbers::pi * 17 * t);
  }
  const std::vector<MeasuredHistory> histories = {
      {.name = "sweep",
       .rate_Hz = kRate_Hz,
       .posts = {},
       .filter = {},
       .count = measured.size(),
       .signals = {{.name = "a", .unit = "m/s^2", .values = measured, .source = {.channels = {{"a"}}}}}}};
  const std::vector<Eigen::MatrixXd> models = {modelled};
  EXPECT_TRUE(RemarksOn(HistoryMisfits(histories, models), 1 / kRate_Hz, RemediedErrors(histories, models)).empty());
}

TEST(HistoryRemark, NamesAUnit) {
  EXPECT_THAT(Remarks(1 / 9.80665, 0),
              Reports(kChannelUnitMistaken, 0, {"in g ", "m/s^2", "'a: {channel: a, unit: g}'"}));
  EXPECT_LT(Promised(Remarks(1 / 9.80665, 0)), kNothing_percent);
  EXPECT_THAT(Remarks(-1000, 0, {"a"}, "m"),
              Reports(kChannelUnitMistaken, 0, {"'a: {channel: a, unit: mm, sign: -1}'"}));
}

SourceChannel Source(const std::string& unit, double factor) {
  SourceChannel channel("a");
  channel.unit = unit;
  channel.factor = factor;
  return channel;
}

TEST(HistoryRemark, TakesBackTheUnitOfTheStudy) {
  const Diagnostics remarks = Remarks(1e-3, 0, Source("mm", 1), "m");
  EXPECT_THAT(remarks, Reports(kChannelUnitMistaken, 0, {"in m ", " mm", "unit: m}'"}));
  EXPECT_LT(Promised(remarks), kNothing_percent);
}

// Twice the same conversion: a unit on top of the study's scale would change nothing.
TEST(HistoryRemark, TakesBackTheScaleOfTheStudy) {
  for (const std::string unit : {"m", "mm", ""})
    for (const double scale : {1e-3, 1e3}) {
      const Diagnostics remarks = Remarks(scale, 0, Source(unit, scale), "m");
      EXPECT_THAT(remarks,
                  Reports(kChannelScaledTwice, 0, {unit.empty() ? "'a: a'" : "'a: {channel: a, unit: " + unit + "}'"}));
      EXPECT_THAT(remarks, Not(Reports(kChannelScaledTwice, 0, {"scale: "})));
      EXPECT_LT(Promised(remarks), kNothing_percent);
    }
}

// A factor that no unit explains.
TEST(HistoryRemark, GivesAScale) {
  EXPECT_THAT(Remarks(50, 0), Reports(kChannelUnitDoubtful, 0, {"factor of 50", "'a: {channel: a, scale: 0.02}'"}));
  EXPECT_LT(Promised(Remarks(50, 0)), kNothing_percent);
}

}  // namespace
}  // namespace fourpost::history_remark_test
