#include "analysis/files/near_file.h"

#include <algorithm>
#include <system_error>
#include <vector>

#include "analysis/files/findings.h"
#include "analysis/text/nearest.h"

namespace fourpost {

std::string DidYouMeanFile(const std::filesystem::path& missing) {
  namespace fs = std::filesystem;
  const fs::path named = missing.has_filename() ? missing : missing.parent_path();
  const fs::path folder = named.has_parent_path() ? named.parent_path() : fs::path(".");
  std::error_code failure;
  if (fs::exists(named, failure)) return "";
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure))
    names.push_back(entry->path().filename().string());
  // Of equals the first is taken, and folders have no order.
  std::sort(names.begin(), names.end());
  const std::optional<std::string_view> near = NearestName(named.filename().string(), names);
  return near ? ", did you mean '" + fs::path(named).replace_filename(*near).string() + "'?" : "";
}

bool RequireFile(const std::filesystem::path& file, const std::string& named_by, int line, Diagnostics& diagnostics) {
  std::error_code failure;
  if (std::filesystem::exists(file, failure)) return true;
  diagnostics.Report(kFileNotThere, {named_by, line},
                     {" " + file.string(), DidYouMeanFile(file) + (failure ? " (" + failure.message() + ")" : "")});
  return false;
}

}  // namespace fourpost
