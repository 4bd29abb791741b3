#include "analysis/files/mat_file.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording_summary.h"
#include "tests/fuzz/fuzz_target.h"

namespace fourpost {

void FuzzMat(const std::string& bytes) {
  Diagnostics diagnostics;
  const std::optional<std::vector<MatVector>> vectors = ParseMat(bytes, "fuzz.mat", diagnostics);
  Require(vectors.has_value() != diagnostics.HasErrors(), "a file reads when it has no error", diagnostics.Format());
  if (!vectors) return;
  std::size_t numbers = 0;
  for (const MatVector& vector : *vectors) {
    Require(vector.values.empty() != vector.texts.empty(), "a vector holds either numbers or texts", vector.name);
    numbers += vector.values.size();
  }
  // Deflate packs zeros no closer than 1032 to 1.
  Require(numbers <= 1032 * bytes.size(), "a file holds the numbers that are read from it");
  Summarise(RecordedTable("fuzz.mat", *vectors));
}

}  // namespace fourpost
