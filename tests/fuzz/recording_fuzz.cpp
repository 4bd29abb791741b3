#include "tests/fuzz/recording_fuzz.h"

#include "analysis/files/recorded_table.h"
#include "analysis/files/recording/inflated.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/recording_summary.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

namespace fourpost {
namespace {

/// A lone digit and a blank are a number; packed zeros are more.
std::size_t MostNumbers(const std::string& bytes) { return kClosestDeflated * bytes.size(); }

void RequireChannels(const RecordingFile& file, const std::string& bytes) {
  for (std::size_t i = 0; i < file.header().channels.size(); ++i) {
    const RecordingChannel& channel = file.header().channels[i];
    Require(channel.samples <= MostNumbers(bytes), "a channel has no more samples than the file", channel.name);
    const std::size_t values = file.Values(i).size();
    Require(values == channel.samples, "a channel has the samples of its header", channel.name);
    const std::size_t times = file.Times(i).size();
    Require(times == (channel.HasTimes() ? values : 0), "a sample has one time", channel.name);
  }
}

}  // namespace

void FuzzRecording(const std::string& bytes, const std::string& format,
                   std::unique_ptr<RecordingFile> (*open)(const std::filesystem::path& file)) {
  static const FuzzFolder folder(format);
  const std::filesystem::path path = folder.Write("fuzz", bytes);
  try {
    const std::unique_ptr<RecordingFile> file = open(path);
    RequireChannels(*file, bytes);
    Diagnostics diagnostics;
    const std::optional<RecordedTable> table = ReadRecordedTable(path, diagnostics);
    if (table) Summarise(*table);
  } catch (const RecordingFault& fault) {
    Require(!fault.found().Text().empty(), "a fault has its words");
  } catch (const FaultyInput& faulty) {
    Require(faulty.diagnostics().HasErrors(), "what ends a reading is an error");
  }
}

}  // namespace fourpost
