#include "identify/study/study_audit.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "identify/experiments/four_post/findings.h"
#include "identify/study/audit_text.h"
#include "identify/study/findings.h"
#include "tests/findings.h"
#include "tests/identify/shipped_study.h"

namespace fourpost::study_audit_test {
namespace {

MeasuredChannel& Channel(MeasuredRun& run, const LoadedStudy& study, const std::string& name) {
  for (MeasuredChannel& channel : run.channels)
    if (study.vehicle.sensors[channel.sensor].name == name) return channel;
  throw std::invalid_argument("no channel " + name);
}

Diagnostics Findings(const LoadedStudy& study, Severity certain = Severity::kWarning) {
  Diagnostics found;
  ReportAudit(study, AuditStudy(study).value(), certain, found);
  return found;
}

void Scale(LoadedStudy& study, const std::string& name, double factor) {
  for (MeasuredRun& run : Sines(study).runs)
    for (std::complex<double>& response : Channel(run, study, name).response) response *= factor;
}

TEST(StudyAudit, ShippedStudiesAreWiredRightly) {
  for (const char* name : {"model1", "model2", "model3", "full_one_body"})
    EXPECT_EQ(Findings(ShippedStudy(name)).Format(), "") << name;
}

TEST(StudyAudit, WrongSignIsAnErrorAtItsLine) {
  LoadedStudy study = ShippedStudy();
  Scale(study, "a_cg", -1);
  const Diagnostics found = Findings(study, Severity::kError);
  EXPECT_THAT(found, Reports(kRigSign, Sines(study).plan.channels[4].second.line));
  EXPECT_TRUE(found.HasErrors());
  EXPECT_FALSE(Findings(study).HasErrors());
}

// Without forces the sign of a strut is as good as that of all accelerometers: one of them is wrong.
TEST(StudyAudit, WrongSignIsAnErrorWhereAllElseThatExplainsItIsOne) {
  const LoadedStudy study = ShippedStudy();
  Audit audit = AuditStudy(study).value();
  const auto scale = [](const char* name, std::vector<std::size_t> members) {
    return RigFault{.kind = RigFault::Kind::kScale, .members = std::move(members), .name = name};
  };
  const RigFault exchange = {.kind = RigFault::Kind::kExchange, .members = {4, 5}, .name = "a_cg and a_tow_point"};
  audit.suspicions = {{.fault = scale("s_strut_front", {7}),
                       .size = -2,
                       .sd = 0.004,
                       .score = 1e5,
                       .rivals = {{scale("all accelerometers", {0, 1}), -2, 1e5}, {exchange, 0, 1e5}},
                       .next_score = 3e4}};
  const auto has_errors = [&] {
    Diagnostics found;
    ReportAudit(study, audit, Severity::kError, found);
    EXPECT_THAT(found, Reports(kRigSign, Sines(study).plan.channels[7].second.line));
    return found.HasErrors();
  };
  EXPECT_TRUE(has_errors());
  // A harmless explanation is left.
  audit.suspicions[0].rivals.push_back({scale("a_cg", {4}), 0.05, 1e5});
  EXPECT_FALSE(has_errors());
}

TEST(StudyAudit, ScaleIsAWarning) {
  LoadedStudy study = ShippedStudy();
  Scale(study, "s_strut_front", 1.05);
  const Diagnostics found = Findings(study, Severity::kError);
  EXPECT_FALSE(found.HasErrors());
  EXPECT_THAT(found, Reports(kRigScale, Sines(study).plan.channels[7].second.line));
}

// The fit then knows of it, and says itself when it is further off than stated.
TEST(StudyAudit, IsSilentOfWhatACalibrationAllowsFor) {
  LoadedStudy study = ShippedStudy();
  const auto& channels = Sines(study).plan.channels;
  for (const auto& [name, source] : channels)
    if (name.starts_with("a_")) Scale(study, name, 1.03);
  ASSERT_THAT(Findings(study), Reports(kRigScale));
  study.study.calibrations = {{.kind = Calibration::Kind::kGain, .of = "accelerometers", .sd = 0.02}};
  EXPECT_EQ(Findings(study).Format(), "");
  study.study.calibrations[0].sd = 0.005;
  EXPECT_THAT(Findings(study), Reports(kRigScale));
  study.study.calibrations = {{.kind = Calibration::Kind::kGain, .of = "struts", .sd = 0.02}};
  EXPECT_THAT(Findings(study), Reports(kRigScale));
}

/// Mass between a load cell and its tyre in the recordings.
void AddWheelpan(LoadedStudy& study, const std::string& name, double kg, std::size_t post) {
  for (MeasuredRun& run : Sines(study).runs) {
    std::vector<std::complex<double>>& response = Channel(run, study, name).response;
    for (std::size_t i = 0; i < response.size(); ++i)
      response[i] -=
          kg * std::pow(2 * std::numbers::pi * run.excitation.frequency_Hz[i], 2) * run.excitation.shape[post];
  }
}

TEST(StudyAudit, NamesAWheelpanOfAnotherMassThanStated) {
  LoadedStudy study = ShippedStudy("model1");
  for (Sensor& sensor : study.vehicle.sensors)
    if (sensor.name == "F_tyre_rear") sensor.wheelpan = {.value = 30};
  AddWheelpan(study, "F_tyre_rear", 42, 1);
  const Diagnostics found = Findings(study);
  EXPECT_THAT(found, Reports(kRigWheelpan));
  EXPECT_THAT(found.Format(), testing::ContainsRegex("wheelpan of 'F_tyre_rear': about 4[0-4][^,]*, 30 kg in the"));
}

TEST(StudyAudit, UnitIsNamedByItsRatio) {
  LoadedStudy study = ShippedStudy();
  Scale(study, "s_strut_rear", 25.4);
  EXPECT_THAT(Findings(study).Format(), testing::HasSubstr("inches"));
}

TEST(StudyAudit, SaysWhichConditionItLacks) {
  LoadedStudy study = ShippedStudy();
  Diagnostics found;
  found.Report(kPostsMoveOtherwise, {}, {"bounce", "heave", "3", "pitch", "0.9", "0.1"});
  EXPECT_THAT(NoAuditText(study, found), testing::HasSubstr("correct [posts-move-otherwise] first"));
  Sines(study).runs.clear();
  EXPECT_FALSE(AuditStudy(study));
  EXPECT_THAT(NoAuditText(study, {}), testing::HasSubstr("this study fits neither"));
}

TEST(StudyAudit, PrintsNoSizeThatIsNotSeen) {
  Audit audit = AuditStudy(ShippedStudy()).value();
  for (Resolution& resolution : audit.resolutions)
    if (resolution.fault.name == "a_cg") resolution.sd = std::numeric_limits<double>::infinity();
  for (ChannelRest& channel : audit.channels)
    if (channel.name == "a_cg") channel.share = 1e-7;
  // "a_cg  -  0.4  -  -": no share of rounding either.
  EXPECT_THAT(AuditText(audit), testing::ContainsRegex("\na_cg +- +[0-9.]+ +- +- +-"));
}

TEST(StudyAudit, JsonHasWhatTheTableHas) {
  const Audit audit = AuditStudy(ShippedStudy()).value();
  const nlohmann::ordered_json json = AuditJson(audit);
  EXPECT_EQ(json["channels"].size(), audit.channels.size());
  EXPECT_EQ(json["resolutions"].size(), audit.resolutions.size());
  EXPECT_THAT(AuditText(audit), testing::HasSubstr("a_tow_point"));
}

}  // namespace
}  // namespace fourpost::study_audit_test
