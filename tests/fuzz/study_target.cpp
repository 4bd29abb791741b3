#include "identify/study/loaded_study.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"

namespace fourpost {
namespace {

/// Holds what the starter study names.
class StudyFolder : public FuzzFolder {
 public:
  StudyFolder() : FuzzFolder("study") {
    for (const char* name : {"vehicle.urdf", "stepped_sine.csv"})
      std::filesystem::copy_file(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/starter" / name, path() / name,
                                 std::filesystem::copy_options::overwrite_existing);
  }
};

}  // namespace

void FuzzStudy(const std::string& bytes) {
  static const StudyFolder folder;
  const std::filesystem::path file = folder.Write("study.yaml", bytes);
  Diagnostics faults;
  const std::optional<Study> study = ReadStudy(file, faults);
  Require(study.has_value() != faults.HasErrors(), "a study reads when it has no error", faults.Format());
  // Problems have no files, and a vehicle elsewhere is none of these bytes.
  if (!study || study->problem) return;
  Diagnostics file_faults;
  const bool is_loaded = LoadStudy(file, file_faults).has_value();
  Require(is_loaded != file_faults.HasErrors(), "a study loads when nothing is wrong", file_faults.Format());
}

}  // namespace fourpost
