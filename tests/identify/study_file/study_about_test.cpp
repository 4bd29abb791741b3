#include "identify/study_file/study_about.h"

#include <gtest/gtest.h>

#include "identify/study_file/study_yaml.h"

namespace fourpost::study_about_test {
namespace {

TEST(StudyAbout, IsWhatTheStudyStates) {
  const StudyAbout about = StudyAboutOf(
      "vehicle: car.urdf\nabout: {car: Land Rover 110, rig: four-post 2, date: 2024-05-17, operator: A. Miller}\n");
  EXPECT_EQ(about.car, "Land Rover 110");
  EXPECT_EQ(about.rig, "four-post 2");
  EXPECT_EQ(about.date, "2024-05-17");
  EXPECT_EQ(about.operated_by, "A. Miller");
}

TEST(StudyAbout, RefusesWhatNoReportShows) {
  Diagnostics faults;
  const auto root = ReadYaml("about: {car: one, colour: red}", "study.yaml", faults);
  ASSERT_TRUE(root);
  ReadStudyAbout(StrictMap(*root, "the study", {"about"}, "study.yaml", faults));
  ASSERT_EQ(faults.items().size(), 1u);
  EXPECT_NE(faults.items()[0].message.find("colour"), std::string::npos);
}

TEST(StudyAbout, IsEmptyWhereNothingIsStatedOrNothingCanBeRead) {
  EXPECT_EQ(StudyAboutOf("vehicle: car.urdf\n").car, "");
  EXPECT_EQ(StudyAboutOf("about: {rig: one}").car, "");
  EXPECT_EQ(StudyAboutOf("[").rig, "");
}

}  // namespace
}  // namespace fourpost::study_about_test
