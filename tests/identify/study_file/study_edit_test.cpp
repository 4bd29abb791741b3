#include "identify/study_file/study_edit.h"

#include <gmock/gmock.h>

namespace fourpost::study_edit_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kStudy = R"(# a study
vehicle: car.urdf   # the car
recordings:
  - {file: 'rig/heave.csv', posts: heave}
channels:
  a_body: {mean: [left, {channel: right, sign: -1}]}
  F: load
free: [k, c]
)";

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(StudyEdit, LeavesAllElseAsItIs) { EXPECT_EQ(StudyEdit(kStudy).Text(), kStudy); }

TEST(StudyEdit, NamesFilesFromAnotherFolder) {
  StudyEdit edit(kStudy);
  edit.Rebase({"/data/rig/heave.csv"}, "/data", "/data/out/one");
  edit.SetVehicle("vehicle.urdf");
  EXPECT_EQ(edit.Text(),
            Replaced(Replaced(kStudy, "'rig/heave.csv'", "\"../../rig/heave.csv\""), "car.urdf", "vehicle.urdf"));
}

TEST(StudyEdit, FreesParametersWhereAListNamesThem) {
  StudyEdit edit(kStudy);
  edit.AddFree({"f", "k_mount"});
  EXPECT_EQ(edit.Text(), Replaced(kStudy, "[k, c]", "[k, c, f, k_mount]"));
  StudyEdit lines("free:\n  - k\n  - c\n");
  lines.AddFree({"f"});
  EXPECT_EQ(lines.Text(), "free:\n  - k\n  - c\n  - f\n");
  StudyEdit all("vehicle: a.urdf\n");
  all.AddFree({"f"});
  EXPECT_EQ(all.Text(), "vehicle: a.urdf\n");
}

TEST(StudyEdit, NamesTheDamperOfABenchThatNamesNone) {
  const auto named = [](const std::string& text) {
    StudyEdit edit(text);
    edit.NameDamper("front");
    return edit.Text();
  };
  EXPECT_EQ(named("vehicle: a\nbench:\n  # One.\n  recordings: [b]\n  force: f\n"),
            "vehicle: a\nbench:\n  # One.\n  damper: \"front\"\n  recordings: [b]\n  force: f\n");
  EXPECT_EQ(named("bench: {recordings: [b]}\n"), "bench: {damper: \"front\", recordings: [b]}\n");
  EXPECT_EQ(named("bench: {damper: d, recordings: [b]}\n"), "bench: {damper: d, recordings: [b]}\n");
  EXPECT_EQ(named(kStudy), kStudy);
}

TEST(StudyEdit, CorrectsAllChannelsOfASensor) {
  StudyEdit edit(kStudy);
  EXPECT_TRUE(edit.CorrectChannels({"a_body", "F"}, "delay", "2 ms"));
  EXPECT_THAT(edit.Text(),
              HasSubstr("{mean: [{channel: left, delay: 2 ms}, {channel: right, delay: 2 ms, sign: -1}]}"));
  EXPECT_THAT(edit.Text(), HasSubstr("F: {channel: load, delay: 2 ms}"));
  StudyEdit twice(kStudy);
  EXPECT_FALSE(twice.CorrectChannels({"a_body"}, "sign", "1"));
  EXPECT_EQ(twice.Text(), kStudy);
}

TEST(StudyEdit, AddsToWhatIsStated) {
  const std::string study =
      "channels:\n  a: {channel: left, delay: 2 ms}\n  b:\n    channel: right\n    scale: 1.1\n  c: pot\n";
  StudyEdit delays(study);
  EXPECT_TRUE(delays.CorrectChannels({"a", "b"}, "delay", "-0.5 ms"));
  EXPECT_EQ(delays.Text(), Replaced(Replaced(study, "2 ms", "1.5 ms"), "right\n", "right\n    delay: -0.5 ms\n"));
  StudyEdit scales(study);
  EXPECT_TRUE(scales.CorrectChannels({"b", "c"}, "scale", "0.9"));
  EXPECT_EQ(scales.Text(), Replaced(Replaced(study, "1.1", "0.99"), "pot", "{channel: pot, scale: 0.9}"));
  StudyEdit unlisted(study);
  EXPECT_FALSE(unlisted.CorrectChannels({"d"}, "delay", "1 ms"));
}

TEST(StudyEdit, ScalesNoiseThatIsStated) {
  const std::string study = "histories:\n  - file: a.csv\n    noise: {F: 20.6 N, a: 0.1 m/s^2}\n";
  StudyEdit edit(study);
  edit.ScaleNoise({"F", "s"}, 0.5);
  EXPECT_EQ(edit.Text(), Replaced(study, "20.6 N", "10.3 N"));
}

TEST(StudyEdit, KnowsMeasuredSensors) { EXPECT_THAT(MeasuredSensors(kStudy), ElementsAre("a_body", "F")); }

}  // namespace
}  // namespace fourpost::study_edit_test
