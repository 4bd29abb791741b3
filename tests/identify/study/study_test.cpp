#include "identify/study/study.h"

#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/static_loads/static_loads.h"
#include "identify/experiments/time_history/time_histories.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

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
  std::string Fault(const std::string& what, const std::string& with) {
    diagnostics_ = {};
    EXPECT_FALSE(Read(what, with).has_value());
    EXPECT_EQ(diagnostics_.items().size(), 1u) << diagnostics_.Format();
    const std::string text = diagnostics_.Format();
    EXPECT_THAT(text, testing::StartsWith(file_.string()));
    return text.substr(file_.string().size());
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
  std::filesystem::path file_ = folder_ / "study.yaml";
  Diagnostics diagnostics_;
};

TEST_F(StudyTest, IsOneDocument) {
  EXPECT_THAT(Fault("refine:", "---\nrefine:"), HasSubstr(":25: error: a second document begins here"));
}

TEST_F(StudyTest, HasNoTags) {
  EXPECT_TRUE(Read("vehicle: car.urdf", "vehicle: 'car.urdf'"));
  EXPECT_THAT(Fault("seed: 7", "seed: !!int 7"),
              HasSubstr(":20: error: has the tag 'tag:yaml.org,2002:int'; remove it"));
  EXPECT_THAT(Fault("free: [k, c]", "free: !!python/object:os.system [k, c]"), HasSubstr(":13: error: has the tag"));
}

TEST_F(StudyTest, MayUseAliasesWithinReason) {
  ASSERT_TRUE(Read("a_axle: a_axle", "a_axle: &axle a_axle\n  a_other: *axle")) << diagnostics_.Format();
  std::string laughs = "free: &a0 [k, c]\n";
  for (int i = 1; i < 20; ++i) {
    laughs += "x" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 10; ++k) laughs += (k == 0 ? "*a" : ", *a") + std::to_string(i - 1);
    laughs += "]\n";
  }
  EXPECT_THAT(Fault("free: [k, c]\n", laughs), HasSubstr("error: has more than 5000 values up to here"));
  EXPECT_THAT(Fault("free: [k, c]", "free: &a [k, *a]"), HasSubstr(":13: error: is an alias of what it stands in"));
}

TEST_F(StudyTest, IsNoMebibyte) {
  EXPECT_THAT(Fault("name: bounce", "name: " + std::string(1 << 20, 'x')), HasSubstr(": error: is longer than 1 MiB"));
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
  EXPECT_THAT(Fault("model_error:", "model_eror:"), testing::AllOf(HasSubstr(":15: error: "), HasSubstr("'model_eror'"),
                                                                   HasSubstr("did you mean 'model_error'?")));
}

TEST_F(StudyTest, ReportsAKeyThatStandsTwice) {
  EXPECT_THAT(Fault("free: [k, c]", "free: [k, c]\nfree: [k]"),
              testing::AllOf(HasSubstr(":14: error: "), HasSubstr("'free'"), HasSubstr("twice")));
}

TEST_F(StudyTest, ReportsAnEmptyBand) {
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[12 Hz, 0.5 Hz]"), HasSubstr(":14: error: 'band' is empty"));
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[0 Hz, 1e308 Hz]"), HasSubstr(":14: error: 'band' ends above 100 kHz"));
  EXPECT_THAT(Fault("evaluations: 400", "evaluations: 2147483648"),
              HasSubstr(":21: error: 'evaluations' of 'search' must be a whole number from 1 to 1000000000"));
  EXPECT_THAT(Fault("0.2 mm", "1e300 m"), HasSubstr(":18: error: 'mean' of 'model_error' must be at most 1e12 m"));
}

TEST_F(StudyTest, ReportsAMissingUnit) {
  EXPECT_THAT(Fault("[0.5 Hz, 12 Hz]", "[0.5, 12 Hz]"), testing::AllOf(HasSubstr(":14: error: "), HasSubstr("Hz")));
}

TEST_F(StudyTest, ReportsAWrongDimension) {
  EXPECT_THAT(Fault("0.2 mm", "0.2 kg"), testing::AllOf(HasSubstr(":18: error: "), HasSubstr("length")));
}

TEST_F(StudyTest, ReportsAnAngleWithoutUnit) {
  EXPECT_THAT(Fault("3 deg", "3"), testing::AllOf(HasSubstr(":17: error: "), HasSubstr("angle such as deg")));
}

TEST_F(StudyTest, ReadsAPatternOfPosts) {
  const std::optional<Study> study = Read("{front: 1, rear: -0.5}", "pitch");
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->experiments.Find<FourPost>()->plan.recordings[0].pattern, "pitch");
  EXPECT_THAT(study->experiments.Find<FourPost>()->plan.recordings[0].posts, testing::IsEmpty());
  EXPECT_EQ(Read()->experiments.Find<FourPost>()->plan.recordings[0].pattern, std::nullopt);
}

TEST_F(StudyTest, ReportsAnUnknownPatternOfPosts) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "ptich"),
              HasSubstr(":5: error: unknown pattern 'ptich' of 'posts', did you mean 'pitch'?"));
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "bounce"),
              HasSubstr(":5: error: unknown pattern 'bounce' of 'posts'; legal: heave, pitch, roll, warp"));
}

TEST_F(StudyTest, ReportsPostsThatAreNeitherPatternNorShares) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "[pitch]"),
              HasSubstr(":5: error: 'posts' must be a pattern such as pitch"));
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "~"), HasSubstr(":5: error: 'posts' must be a pattern such as pitch"));
}

TEST_F(StudyTest, ReportsPostsWithoutReference) {
  EXPECT_THAT(Fault("{front: 1, rear: -0.5}", "{front: 0.5, rear: -0.5}"), HasSubstr("must be the reference"));
}

TEST_F(StudyTest, ReportsAModelErrorOfMeansThatIsZero) {
  EXPECT_THAT(Fault("0.2 mm", "0 mm"), HasSubstr("'mean' of 'model_error' must be above zero"));
}

TEST_F(StudyTest, TakesTheUsualScaleOfALossWithoutOne) {
  const std::optional<Study> study = Read("cauchy, scale: 3", "soft_l1");
  ASSERT_TRUE(study);
  EXPECT_EQ(study->refine.loss, LossKind::kSoftL1);
  EXPECT_FALSE(study->refine.scale);
}

TEST_F(StudyTest, ReportsALossThatIsNone) {
  EXPECT_THAT(Fault("cauchy", "cauchi"), HasSubstr("unknown loss 'cauchi', did you mean 'cauchy'?"));
  EXPECT_THAT(Fault("scale: 3", "scale: 0"), HasSubstr("'scale' of 'refine' must be a number from"));
  EXPECT_THAT(Fault("{loss: cauchy, scale: 3}", "{scale: 3}"), HasSubstr("needs the key 'loss'"));
}

TEST_F(StudyTest, ReportsADeadlineThatIsNoTime) {
  EXPECT_THAT(Fault("250 ms", "0 s"), HasSubstr("'deadline' of 'search' must be above zero"));
  EXPECT_THAT(Fault("250 ms", "250"), HasSubstr("'deadline'"));
  EXPECT_THAT(Fault("250 ms", "250 mm"), HasSubstr("'deadline'"));
}

TEST_F(StudyTest, ReportsStaticLoadsWithoutFile) {
  EXPECT_THAT(Fault("  file: static.csv\n", ""), HasSubstr("'static_loads' needs the key 'file'"));
}

TEST_F(StudyTest, ListsTheKeysWhenNoneIsNear) {
  EXPECT_THAT(Fault("seed: 7", "xyz: 7"), HasSubstr("; legal: seed, method, evaluations, population, starts"));
}

TEST_F(StudyTest, ReportsANumberOutOfRange) {
  EXPECT_THAT(Fault("population: 30", "population: 2"), testing::AllOf(HasSubstr(":22: error: "), HasSubstr("4")));
}

TEST_F(StudyTest, ReportsAMissingKey) { EXPECT_THAT(Fault("vehicle: car.urdf\n", ""), HasSubstr("'vehicle'")); }

TEST_F(StudyTest, ReportsTextThatIsNotYaml) {
  EXPECT_THAT(Fault("free: [k, c]", "free: [k, c"), HasSubstr("not YAML"));
}

TEST_F(StudyTest, ReportsTwoRecordingsOfOneName) {
  EXPECT_THAT(Fault("channels:\n", "  - {name: bounce, file: b.csv, posts: {front: 1}}\nchannels:\n"),
              HasSubstr(":6: error: two recordings are called 'bounce'"));
}

TEST_F(StudyTest, ReportsAllFaultsAtOnce) {
  EXPECT_FALSE(Read("vehicle: car.urdf\nrecordings:", "vehicel: car.urdf\nrecording:").has_value());
  EXPECT_GE(diagnostics_.items().size(), 4u) << "two unknown keys, two missing ones\n" << diagnostics_.Format();
}

TEST_F(StudyTest, ReportsAMissingFile) {
  EXPECT_FALSE(ReadStudy(folder_ / "nowhere.yaml", diagnostics_).has_value());
  EXPECT_THAT(diagnostics_.Format(), HasSubstr("nowhere.yaml: error: cannot be read: No such file"));
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
  EXPECT_THAT(Fault("search:\n", "methods: de\nsearch:\n"), HasSubstr("'methods' must map names to settings"));
  EXPECT_THAT(Fault("search:\n", "methods: {a: de}\nsearch:\n"), HasSubstr("method 'a' must be a list of settings"));
  EXPECT_THAT(Fault("search:\n", "methods: {a: {method: de, factor: [1]}}\nsearch:\n"),
              HasSubstr("'factor' of method 'a' must be a single value"));
  EXPECT_THAT(Fault("search:\n", "methods: {a: {method: de}, a: {method: ds}}\nsearch:\n"),
              HasSubstr("key 'a' of 'methods' stands twice"));
  EXPECT_THAT(Fault("search:\n", "target: -1\nsearch:\n"), HasSubstr("'target' of the study must be a number"));
}

TEST_F(StudyTest, ATestProblemHasNoVehicle) {
  std::ofstream(file_) << "problem: coil_spring\nsearch: {evaluations: 9}\n";
  const std::optional<Study> study = ReadStudy(file_, diagnostics_);
  ASSERT_TRUE(study) << diagnostics_.Format();
  EXPECT_EQ(study->problem, "coil_spring");
  EXPECT_EQ(study->search.evaluations, 9);
  std::ofstream(file_) << "problem: coil_spring\nvehicle: car.urdf\n";
  EXPECT_FALSE(ReadStudy(file_, diagnostics_));
  EXPECT_THAT(diagnostics_.Format(), HasSubstr(":2: error: unknown key 'vehicle' in the study"));
}

}  // namespace
}  // namespace fourpost
