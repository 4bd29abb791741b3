#include "identify/study/study_context.h"

#include <gtest/gtest.h>

#include "analysis/files/sha256.h"
#include "tests/identify/shipped_study.h"
#include "tests/temporary_folder.h"
#include "vehicles/requests/versions.h"

namespace fourpost::study_context_test {
namespace {

class StudyContext : public testing::Test {
 protected:
  /// Which parts differ from those of the shipped study.
  std::string Changed(const LoadedStudy& study) const {
    const EvaluationContext context = ContextOf(study);
    std::string changed;
    if (context.vehicle != shipped_.vehicle) changed += " vehicle";
    if (context.data != shipped_.data) changed += " data";
    if (context.settings != shipped_.settings) changed += " settings";
    if (context.version != shipped_.version) changed += " version";
    return changed;
  }

  LoadedStudy study_ = ShippedStudy();
  EvaluationContext shipped_ = ContextOf(study_);
};

TEST_F(StudyContext, IsTheSameForTheSameStudy) { EXPECT_EQ(Changed(ShippedStudy()), ""); }

TEST_F(StudyContext, DoesNotDependOnWhichPointsAreAskedFor) {
  study_.study.search.seed = 17;
  study_.study.search.evaluations = 5000;
  study_.study.search.population = 99;
  study_.study.search.starts = 1;
  study_.study.search.generations = 3;
  study_.study.target_cost = 1;
  EXPECT_EQ(Changed(study_), "");
}

TEST_F(StudyContext, ForgetsCommentsAndBlankSpaceOfTheVehicle) {
  const std::size_t link = study_.vehicle.text.find("<link");
  study_.vehicle.text.insert(link, "<!-- a remark: <link mass=\"1\"/> -->\n\n   ");
  EXPECT_EQ(Changed(study_), "");
}

TEST_F(StudyContext, FollowsTheVehicle) {
  LoadedStudy changed = study_;
  changed.vehicle.text = Replace(changed.vehicle.text, "value=\"1725 kg\"", "value=\"1726 kg\"");
  EXPECT_EQ(Changed(changed), " vehicle");
  // As another mesh does.
  changed = study_;
  changed.vehicle.links.back().inertia[1].value += 1e-9;
  EXPECT_EQ(Changed(changed), " vehicle");
}

TEST_F(StudyContext, FollowsTheData) {
  LoadedStudy changed = study_;
  Sines(changed).plan.band_upper_Hz -= 1;
  EXPECT_EQ(Changed(changed), " data");
  changed = study_;
  MeasuredChannel& channel = Sines(changed).runs[1].channels.back();
  channel.response[40] *= 1 + 1e-15;
  EXPECT_EQ(Changed(changed), " data");
  changed = study_;
  Sines(changed).runs[0].channels[3].tangential_sd[33] += 1e-9;
  EXPECT_EQ(Changed(changed), " data");
  changed = study_;
  std::swap(Sines(changed).runs[0].channels[0].sensor, Sines(changed).runs[0].channels[1].sensor);
  EXPECT_EQ(Changed(changed), " data");
  changed = study_;
  Sines(changed).runs[0].excitation.shape[0] = -1;
  EXPECT_EQ(Changed(changed), " data");
  changed = study_;
  Rest(changed).loads[0].sd_N *= 2;
  EXPECT_EQ(Changed(changed), " data");
}

TEST_F(StudyContext, FollowsTheSettingsOfResiduals) {
  LoadedStudy changed = study_;
  changed.free.pop_back();
  EXPECT_EQ(Changed(changed), " settings");
  changed = study_;
  Sines(changed).plan.model_error.mean_m *= 2;
  EXPECT_EQ(Changed(changed), " settings");
  changed = study_;
  changed.study.search.deadline_s = 20;
  EXPECT_EQ(Changed(changed), " settings");
}

TEST_F(StudyContext, TellsTestProblemsApart) {
  EXPECT_EQ(ContextOfProblem("gear_train", 10), ContextOfProblem("gear_train", 10));
  EXPECT_NE(ContextOfProblem("gear_train", 10).vehicle, ContextOfProblem("half_car", 10).vehicle);
  EXPECT_NE(ContextOfProblem("gear_train", 10).settings, ContextOfProblem("gear_train", 5).settings);
}

TEST(BuildId, IsThatOfTheProgram) {
  // 8 bytes are the shortest that linkers make.
  EXPECT_GE(BuildId().size(), 16u);
  EXPECT_EQ(BuildId().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(BuildId(), BuildId());
}

TEST(BuildId, HasTheProgramsFileToGoByWhereTheLinkerLeftNone) {
  Sha256 digest;
  digest.Add(ReadText("/proc/self/exe"));
  EXPECT_EQ(ProgramDigest(), digest.Hex());
}

}  // namespace
}  // namespace fourpost::study_context_test
