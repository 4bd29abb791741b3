#include "identify/study/study_audit.h"

#include <gmock/gmock.h>

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

TEST(StudyAudit, UnitIsNamedByItsRatio) {
  LoadedStudy study = ShippedStudy();
  Scale(study, "s_strut_rear", 25.4);
  EXPECT_THAT(Findings(study).Format(), testing::HasSubstr("inches"));
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
