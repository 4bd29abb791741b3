#include "identify/experiments/bench/bench_study.h"

#include <gmock/gmock.h>

#include "identify/experiments/bench/damper_bench.h"
#include "identify/study/study.h"
#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kGood = R"(vehicle: damper.urdf
bench:
  damper: strut
  displacement: x
  force: F
  rig_filter: {order: 2, cutoff: 40 Hz}
  model_error: 3 %
  recordings: [sweep.csv]
  validation:
    - {name: slow, file: sines/one.csv}
    - two.csv
search: {seed: 3}
)";

std::optional<Study> Read(const std::string& text, Diagnostics& diagnostics, const TemporaryFolder& folder) {
  return ReadStudy(folder.Write("study.yaml", text), diagnostics);
}

std::string Faults(const std::string& text) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  EXPECT_FALSE(Read(text, diagnostics, folder));
  return diagnostics.Format();
}

TEST(BenchStudy, IsReadWhole) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::optional<Study> study = Read(kGood, diagnostics, folder);
  ASSERT_TRUE(study) << diagnostics.Format();
  const BenchStudy& bench = study->experiments.Find<DamperBench>()->plan;
  EXPECT_EQ(bench.damper, "strut");
  EXPECT_EQ(bench.displacement, "x");
  EXPECT_EQ(bench.force, "F");
  EXPECT_EQ(bench.rig_filter.value().order, 2);
  EXPECT_EQ(bench.rig_filter.value().cutoff_Hz, 40);
  EXPECT_EQ(bench.model_error, 0.03);
  ASSERT_EQ(bench.recordings.size(), 1);
  EXPECT_EQ(bench.recordings[0].name, "sweep");
  EXPECT_EQ(bench.recordings[0].file, study->file.parent_path() / "sweep.csv");
  ASSERT_EQ(bench.validation.size(), 2);
  EXPECT_EQ(bench.validation[0].name, "slow");
  EXPECT_EQ(bench.validation[0].file, study->file.parent_path() / "sines/one.csv");
  EXPECT_EQ(study->search.seed, 3);
}

TEST(BenchStudyFault, UnknownKeys) {
  EXPECT_THAT(Faults(Replace(kGood, "validation", "validate")), HasSubstr("'validate'"));
  EXPECT_THAT(Faults(Replace(kGood, "search:", "band: [1 Hz, 2 Hz]\nsearch:")), HasSubstr("'band'"));
}

TEST(BenchStudyFault, NoRecordings) {
  EXPECT_THAT(Faults(Replace(kGood, "recordings: [sweep.csv]", "recordings: []")),
              HasSubstr("'recordings' of 'bench' must be a list of files"));
}

TEST(BenchStudyFault, OneNameTwice) {
  EXPECT_THAT(Faults(Replace(kGood, "- two.csv", "- sweep.csv")), HasSubstr("two recordings are called 'sweep'"));
}

TEST(BenchStudyFault, ImpossibleFilterAndError) {
  EXPECT_THAT(
      Faults(Replace(Replace(kGood, "order: 2", "order: 0"), "3 %", "0 %")),
      AllOf(HasSubstr("'order' of 'rig_filter' must be"), HasSubstr("'model_error' of 'bench' must be above zero")));
}

}  // namespace
}  // namespace fourpost
