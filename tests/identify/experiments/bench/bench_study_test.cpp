#include "identify/experiments/bench/bench_study.h"

#include <gmock/gmock.h>

#include "identify/experiments/bench/damper_bench.h"
#include "identify/experiments/bench/findings.h"
#include "identify/study/study.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::bench_study_test {
namespace {

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

Diagnostics Faults(const std::string& text) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  EXPECT_FALSE(Read(text, diagnostics, folder));
  return diagnostics;
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

TEST(BenchStudy, ARecordingHasColumnsTimesAndAWindowOfItsOwn) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::string entry =
      "\n    - {file: sweep.csv, displacement: s, force: {channel: F, sign: -1}, time: clock, start: 1 s, end: 3 s,"
      " resample: 500 Hz, bridge: 20 ms, with: [force.csv]}";
  const std::optional<Study> study = Read(Replace(kGood, "[sweep.csv]", entry), diagnostics, folder);
  ASSERT_TRUE(study) << diagnostics.Format();
  const BenchStudy::Recording& own = study->experiments.Find<DamperBench>()->plan.recordings.at(0);
  EXPECT_EQ(own.displacement.value().name, "s");
  EXPECT_EQ(own.force.value().factor, -1);
  EXPECT_EQ(own.time.value().name, "clock");
  EXPECT_EQ(own.window.start_s, 1);
  EXPECT_EQ(own.window.end_s, 3);
  EXPECT_EQ(own.preparation.rate_Hz, 500);
  EXPECT_EQ(own.preparation.bridge_s, 0.02);
  EXPECT_EQ(own.preparation.others.at(0).path.filename(), "force.csv");
}

TEST(BenchStudyFault, AWindowThatEndsBeforeItsStart) {
  const std::string entry = "\n    - {file: sweep.csv, start: 3 s, end: 1 s}";
  EXPECT_THAT(Faults(Replace(kGood, "[sweep.csv]", entry)), Reports(kBenchWindowEmpty, 9, {"recording 'sweep'"}));
}

TEST(BenchStudyFault, UnknownKeys) {
  EXPECT_THAT(Faults(Replace(kGood, "validation", "validate")), Reports(kKeyUnknown, 9, {"'validate'"}));
  EXPECT_THAT(Faults(Replace(kGood, "search:", "band: [1 Hz, 2 Hz]\nsearch:")), Reports(kKeyUnknown, 12, {"'band'"}));
}

TEST(BenchStudyFault, NoRecordings) {
  EXPECT_THAT(Faults(Replace(kGood, "recordings: [sweep.csv]", "recordings: []")),
              Reports(kBenchRecordingsEmpty, 8, {"'recordings'"}));
}

TEST(BenchStudyFault, OneNameTwice) {
  EXPECT_THAT(Faults(Replace(kGood, "- two.csv", "- sweep.csv")), Reports(kBenchRecordingTwice, 11, {"'sweep'"}));
}

TEST(BenchStudyFault, ImpossibleFilterAndError) {
  const Diagnostics faults = Faults(Replace(Replace(kGood, "order: 2", "order: 0"), "3 %", "0 %"));
  EXPECT_THAT(faults, Reports(kKeyNotInteger, 6, {"'order' of 'rig_filter'"}));
  EXPECT_THAT(faults, Reports(kKeyNotPositive, 7, {"'model_error' of 'bench'"}));
}

}  // namespace
}  // namespace fourpost::bench_study_test
