#include "analysis/files/frequency_response_file.h"
#include "analysis/files/recorded_table.h"
#include "analysis/files/recording_summary.h"
#include "analysis/files/static_loads.h"
#include "analysis/files/time_recording.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

namespace fourpost {

void FuzzTable(const std::string& bytes) {
  static const FuzzFolder folder("table");
  const std::filesystem::path file = folder.Write("fuzz.csv", bytes);
  const auto expect = [](bool reads, const Diagnostics& diagnostics) {
    Require(reads != diagnostics.HasErrors(), "a file reads when it has no error", diagnostics.Format());
  };

  Diagnostics faults;
  const std::optional<RecordedTable> table = ReadRecordedTable(file, faults);
  expect(table.has_value(), faults);
  if (table) Summarise(*table);

  Diagnostics response_faults;
  expect(ReadFrequencyResponse(file, response_faults).has_value(), response_faults);
  Diagnostics load_faults;
  expect(ReadStaticLoads(file, load_faults).has_value(), load_faults);
  Diagnostics record_faults;
  const std::vector<RecordedChannel> wanted = {
      {.names = {"force"}, .dimension = kForce, .what = "the force"},
      {.names = {"stroke"}, .dimension = kLength, .what = "the stroke", .delay_s = 0.002}};
  expect(ReadTimeRecording(file, wanted, record_faults).has_value(), record_faults);
}

}  // namespace fourpost
