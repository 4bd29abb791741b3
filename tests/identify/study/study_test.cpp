#include "identify/study/study.h"

#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/static_loads/static_loads.h"
#include "identify/experiments/time_history/time_histories.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/study/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::study_test {
namespace {

constexpr const char* kGood = R"(vehicle: car.urdf
recordings:
  - name: bounce
    file: bounce.csv
    posts: {front: 1, rear: -0.5}
channels:
  a_body: {mean: [a_left, a_right]}
  a_axle: a_axle
static_loads:
  file: static.csv
  tyres:
    tyre: {sum: [load_left, load_right]}
free: [k, c]
band: [0.5 Hz, 12 Hz]
model_error:
  gain_dB: 0.5
  phase: 3 deg
  mean: 0.2 mm
search:
  seed: 7
  evaluations: 400
  population: 30
  starts: 3
  deadline: 250 ms
refine: {loss: cauchy, scale: 3}
)";

class StudyTest : public testing::Test {
 protected:
  /// Reads the good text with `what` replaced; "" replaces nothing.
  std::optional<Study> Read(const std::string& what = "", const std::string& with = "") {
    std::string text = kGood;
    if (!what.empty()) {
      const std::size_t at = text.find(what);
      EXPECT_NE(at, std::string::npos) << what;
      text.replace(at, what.size(), with);
    }
    std::ofstream(file_) << text;
    return ReadStudy(file_, diagnostics_);
  }

  /// The one fault of the good text with `what` replaced.
  Diagnostics Fault(const std::string& what, const std::string& with) {
    diagnostics_ = {};
    EXPECT_FALSE(Read(what, with).has_value());
    EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
    for (const Diagnostic& item : diagnostics_.items()) EXPECT_EQ(item.place.file, file_.string());
    return diagnostics_;
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
  std::filesystem::path file_ = folder_ / "study.yaml";
  Diagnostics diagnostics_;
};

TEST_F(StudyTest, IsOneDocument) { EXPECT_THAT(Fault("refine:", "---\nrefine:"), Reports(kStudyTwoDocuments, 25)); }

TEST_F(StudyTest, HasNoTags) {
  EXPECT_TRUE(Read("vehicle: car.urdf", "vehicle: 'car.urdf'"));
  EXPECT_THAT(Fault("seed: 7", "seed: !!int 7"), Reports(kStudyTag, 20, {"'tag:yaml.org,2002:int'"}));
  EXPECT_THAT(Fault("free: [k, c]", "free: !!python/object:os.system [k, c]"), Reports(kStudyTag, 13));
}

TEST_F(StudyTest, MayUseAliasesWithinReason) {
  ASSERT_TRUE(Read("a_axle: a_axle", "a_axle: &axle a_axle\n  a_other: *axle")) << diagnostics_.Format();
  std::string laughs = "free: &a0 [k, c]\n";
  for (int i = 1; i < 20; ++i) {
    laughs += "x" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) laughs += (k == 0 ? "*a" : ", *a") + std::to_string(i - 1);
    laughs += "]\n";
  }
  const Diagnostics laughed = Fault("free: [k, c]\n", laughs);
  EXPECT_THAT(laughed, Reports(kStudyTooManyValues, laughed.items().at(0).place.line, {"5000"}));
  EXPECT_THAT(Fault("free: [k, c]", "free: &a [k, *a]"), Reports(kStudyAliasOfItself, 13));
}

TEST_F(StudyTest, IsNoMebibyte) {
  EXPECT_THAT(Fault("name: bounce", "name: " + std::string(1 << 20, 'x')), Reports(kStudyTooLong, 0));
}

TEST_F(StudyTest, ReadsEveryKey) {
  const std::optional<Study> study = Read();
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->vehicle, folder_ / "car.urdf");
  ASSERT_EQ(study->experiments.Find<FourPost>()->plan.recordings.size(), 1u);
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.recordings[0].name, "bounce");
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.recordings[0].file, folder_ / "bounce.csv");
  EXPECT_THAT(study->experiments.Find<FourPost>()->plan.recordings[0].posts,
              testing::ElementsAre(testing::Pair("front", 1), testing::Pair("rear", -0.5)));
  ASSERT_EQ(study->experiments.Find<FourPost>()->plan.channels.size(), 2u);
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.channels[0].first, "a_body");
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.channels[0].second.combine, ChannelSource::Combine::kMean);
  EXPECT_THAT(study->experiments.Find<FourPost>()->plan.channels[0].second.channels,
              testing::ElementsAre("a_left", "a_right"));
  EXPECT_THAT(study->experiments.Find<FourPost>()->plan.channels[1].second.channels, testing::ElementsAre("a_axle"));
  EXPECT_EQ(study->experiments.Find<StaticLoadTest>()->plan.table, folder_ / "static.csv");
  EXPECT_EQ(study->experiments.Find<StaticLoadTest>()->plan.tyres[0].second.combine, ChannelSource::Combine::kSum);
  EXPECT_THAT(study->free, testing::ElementsAre("k", "c"));
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.band_lower_Hz, 0.5);
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.band_upper_Hz, 12);
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.model_error.gain_dB, 0.5);
  EXPECT_DOUBLE_EQ(study->experiments.Find<FourPost>()->plan.model_error.phase_rad, 3 * 3.14159265358979323846 / 180);
  EXPECT_DOUBLE_EQ(study->experiments.Find<FourPost>()->plan.model_error.mean_m, 0.2e-3);
  EXPECT_EQ(study->search.seed, 7u);
  EXPECT_EQ(study->search.evaluations, 400);
  EXPECT_EQ(study->search.population, 30);
  EXPECT_EQ(study->search.starts, 3);
  EXPECT_EQ(study->search.deadline_s, 0.25);
  EXPECT_EQ(study->refine.loss, LossKind::kCauchy);
  EXPECT_EQ(study->refine.scale, 3);
}

TEST_F(StudyTest, ReportsAnUnknownKeyWithTheNearest) {
  EXPECT_THAT(Fault("model_error:", "model_eror:"), Reports(kKeyUnknown, 15, {"'model_eror'", "'model_error'"}));
}

TEST_F(StudyTest, ReportsAKeyThatStandsTwice) {
  EXPECT_THAT(Fault("free: [k, c]", "free: [k, c]\nfree: [k]"), Reports(kKeyTwice, 14, {"'free'"}));
}

TEST_F(StudyTest, ReportsAnEmptyBand) {
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[12 Hz, 0.5 Hz]"), Reports(kBandEmpty, 14));
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[0 Hz, 1e308 Hz]"), Reports(kBandTooHigh, 14));
  EXPECT_THAT(Fault("evaluations: 400", "evaluations: 2147483648"),
              Reports(kKeyNotInteger, 21, {"'evaluations' of 'search'", "1 to 1000000000"}));
  EXPECT_THAT(Fault("0.2 mm", "1e300 m"), Reports(kKeyTooLarge, 18, {"'mean' of 'model_error'", "1e12 m"}));
}

TEST_F(StudyTest, ReportsAMissingUnit) {
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[0.5, 12 Hz]"), Reports(kKeyNotQuantity, 14, {"Hz"}));
}

TEST_F(StudyTest, ReportsAWrongDimension) {
  EXPECT_THAT(Fault("0.2 mm", "0.2 kg"), Reports(kKeyNotQuantity, 18, {"length"}));
}

TEST_F(StudyTest, ReportsAnAngleWithoutUnit) {
  EXPECT_THAT(Fault("3 deg", "3"), Reports(kKeyNotQuantity, 17, {"angle", "deg"}));
}

TEST_F(StudyTest, ReadsAPatternOfPosts) {
  const std::optional<Study> study = Read("{front: 1, rear: -0.5}", "pitch");
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.recordings[0].pattern, "pitch");
  EXPECT_THAT(study->experiments.Find<FourPost>()->plan.recordings[0].posts, testing::IsEmpty());
  EXPECT_EQ(Read()->experiments.Find<FourPost>()->plan.recordings[0].pattern, std::nullopt);
}

TEST_F(StudyTest, BounceIsHeave) {
  EXPECT_EQ(Read("{front: 1, rear: -0.5}", "bounce")->experiments.Find<FourPost>()->plan.recordings[0].pattern,
            "heave");
}

TEST_F(StudyTest, ReportsAnUnknownPatternOfPosts) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "ptich"), Reports(kSinePatternUnknown, 5, {"'ptich'", "'pitch'"}));
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "bounc"), Reports(kSinePatternUnknown, 5, {"'bounc'", "'bounce'"}));
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "hop"),
              Reports(kSinePatternUnknown, 5, {"'hop'", "heave, bounce, pitch, roll, warp"}));
}

TEST_F(StudyTest, ReportsPostsThatAreNeitherPatternNorShares) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "[pitch]"), Reports(kPostSharesMissing, 5));
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "~"), Reports(kPostSharesMissing, 5));
}

TEST_F(StudyTest, ReportsPostsWithoutReference) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "{front: 0.5, rear: -0.5}"), Reports(kPostReferenceMissing, 5));
}

TEST_F(StudyTest, ReportsAModelErrorOfMeansThatIsZero) {
  EXPECT_THAT(Fault("0.2 mm", "0 mm"), Reports(kKeyNotPositive, 18, {"'mean' of 'model_error'"}));
}

TEST_F(StudyTest, TakesTheUsualScaleOfALossWithoutOne) {
  const std::optional<Study> study = Read("cauchy, scale: 3", "soft_l1");
  ASSERT_TRUE(study);
  EXPECT_EQ(study->refine.loss, LossKind::kSoftL1);
  EXPECT_FALSE(study->refine.scale);
}

TEST_F(StudyTest, ReportsALossThatIsNone) {
  EXPECT_THAT(Fault("cauchy", "cauchi"), Reports(kLossUnknown, 25, {"'cauchi'", "'cauchy'"}));
  EXPECT_THAT(Fault("scale: 3", "scale: 0"), Reports(kKeyNotNumber, 25, {"'scale' of 'refine'"}));
  EXPECT_THAT(Fault("{loss: cauchy, scale: 3}", "{scale: 3}"), Reports(kKeyMissing, 25, {"'refine'", "'loss'"}));
}

TEST_F(StudyTest, ReportsADeadlineThatIsNoTime) {
  EXPECT_THAT(Fault("250 ms", "0 s"), Reports(kKeyNotPositive, 24, {"'deadline' of 'search'"}));
  EXPECT_THAT(Fault("250 ms", "250"), Reports(kKeyNotQuantity, 24, {"'deadline'"}));
  EXPECT_THAT(Fault("250 ms", "250 mm"), Reports(kKeyNotQuantity, 24, {"'deadline'"}));
}

TEST_F(StudyTest, ReportsStaticLoadsWithoutFile) {
  EXPECT_THAT(Fault("  file: static.csv\n", ""), Reports(kKeyMissing, 10, {"'static_loads'", "'file'"}));
}

TEST_F(StudyTest, ListsTheKeysWhenNoneIsNear) {
  EXPECT_THAT(Fault("seed: 7", "xyz: 7"), Reports(kKeyUnknown, 20, {"seed, method, evaluations, population, starts"}));
}

TEST_F(StudyTest, ReportsANumberOutOfRange) {
  EXPECT_THAT(Fault("population: 30", "population: 2"), Reports(kKeyNotInteger, 22, {"4"}));
}

TEST_F(StudyTest, ReportsAMissingKey) {
  EXPECT_THAT(Fault("vehicle: car.urdf\n", ""), Reports(kKeyMissing, 1, {"'vehicle'"}));
}

TEST_F(StudyTest, ReportsTextThatIsNotYaml) {
  EXPECT_THAT(Fault("free: [k, c]", "free: [k, c"), Reports(kStudyNotYaml, 14));
}

TEST_F(StudyTest, ReportsTwoRecordingsOfOneName) {
  EXPECT_THAT(Fault("channels:\n", "  - {name: bounce, file: b.csv, posts: {front: 1}}\nchannels:\n"),
              Reports(kSineTwice, 6, {"'bounce'"}));
}

TEST_F(StudyTest, ReportsAllFaultsAtOnce) {
  EXPECT_FALSE(Read("vehicle: car.urdf\nrecordings:", "vehicel: car.urdf\nrecording:").has_value());
  EXPECT_GE(diagnostics_.items().size(), 4u) << "two unknown keys, two missing ones\n" << diagnostics_.Format();
}

TEST_F(StudyTest, ReportsAMissingFile) {
  EXPECT_FALSE(ReadStudy(folder_ / "nowhere.yaml", diagnostics_).has_value());
  EXPECT_THAT(diagnostics_, Reports(kFileNotThere, 0));
  EXPECT_EQ(diagnostics_.items().at(0).place.file, (folder_ / "nowhere.yaml").string());
}

TEST_F(StudyTest, ReportsAFolderInPlaceOfAFile) {
  EXPECT_FALSE(ReadStudy(folder_, diagnostics_).has_value());
  EXPECT_TRUE(diagnostics_.HasErrors());
}

TEST_F(StudyTest, ReadsMethodsAndATarget) {
  const std::optional<Study> study =
      Read("search:\n", "target: 12.5\nmethods:\n  bold: {method: thesis, factor: 0.9}\nsearch:\n  generations: 70\n");
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->target_cost, 12.5);
  EXPECT_EQ(study->search.generations, 70);
  ASSERT_EQ(study->methods.size(), 1u);
  EXPECT_EQ(study->methods[0].name, "bold");
  EXPECT_EQ(study->methods[0].preset, "thesis");
  ASSERT_EQ(study->methods[0].settings.size(), 1u);
  EXPECT_EQ(study->methods[0].settings[0].key, "factor");
  EXPECT_EQ(study->methods[0].settings[0].value, "0.9");
}

TEST_F(StudyTest, NamesFaultsOfMethods) {
  EXPECT_THAT(Fault("search:\n", "methods: de\nsearch:\n"), Reports(kMethodsNotMapped, 19));
  EXPECT_THAT(Fault("search:\n", "methods: {a: de}\nsearch:\n"), Reports(kMethodNotSettings, 19, {"'a'"}));
  EXPECT_THAT(Fault("search:\n", "methods: {a: {method: de, factor: [1]}}\nsearch:\n"),
              Reports(kSettingNotValue, 19, {"'factor'", "'a'"}));
  EXPECT_THAT(Fault("search:\n", "methods: {a: {method: de}, a: {method: simplex}}\nsearch:\n"),
              Reports(kKeyTwice, 19, {"'a'", "'methods'"}));
  EXPECT_THAT(Fault("search:\n", "target: -1\nsearch:\n"), Reports(kKeyNotNumber, 19, {"'target'"}));
}

TEST_F(StudyTest, ATestProblemHasNoVehicle) {
  std::ofstream(file_) << "problem: coil_spring\nsearch: {evaluations: 9}\n";
  const std::optional<Study> study = ReadStudy(file_, diagnostics_);
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->problem, "coil_spring");
  EXPECT_EQ(study->search.evaluations, 9);
  std::ofstream(file_) << "problem: coil_spring\nvehicle: car.urdf\n";
  EXPECT_FALSE(ReadStudy(file_, diagnostics_));
  EXPECT_THAT(diagnostics_, Reports(kKeyUnknown, 2, {"'vehicle'"}));
}

}  // namespace
}  // namespace fourpost::study_test
