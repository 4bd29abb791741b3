#include "analysis/files/output_folder.h"
#include "identify/search/evaluation_store.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

namespace fourpost {
namespace {

/// That of the archives in the corpus.
const EvaluationContext kContext = {.vehicle = "car", .data = "rig", .settings = "band", .version = "1"};

/// What they hold at 0, 1, 2; every third one failed.
Evaluation EvaluationAt(int i) {
  if (i % 3 == 2) return Infeasible(i, "too far");
  Evaluation evaluation;
  // As seeds.py has them, to the last bit.
  evaluation.residuals.resize(10);
  for (int k = 0; k < 10; ++k) evaluation.residuals[k] = i + k / 9.0;
  return evaluation;
}

void UseArchive(const std::filesystem::path& file) {
  ReadStoredContent(file);
  ChangedParts(file, kContext);
  EvaluationStore store(file, kContext);
  for (int i = 0; i < 4; ++i) {
    const auto evaluate = [&] { return EvaluationAt(i); };
    const Evaluation answer = store.FindOrEvaluate(Eigen::Vector2d(i, 0.5), evaluate).evaluation;
    const Evaluation right = evaluate();
    Require(answer.failure == right.failure && answer.residuals.size() == right.residuals.size() &&
                answer.residuals == right.residuals && answer.detail == right.detail &&
                answer.violation == right.violation,
            "an archive answers what was put in");
  }
}

}  // namespace

void FuzzArchive(const std::string& bytes) {
  static const FuzzFolder folder("archive");
  for (const char* name : {"fuzz.sqlite-wal", "fuzz.sqlite-shm", "fuzz.sqlite-journal"})
    std::filesystem::remove(folder.path() / name);
  try {
    UseArchive(folder.Write("fuzz.sqlite", bytes));
  } catch (const OutputError&) {
    // Damaged beyond reading: refused, with what to do.
  }
}

}  // namespace fourpost
