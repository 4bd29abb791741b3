#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "identify/fit/fit.h"

namespace fourpost {

/// A page that a browser may keep open while a fit runs: it loads itself again until the report is there.
class WatchPage {
 public:
  /// Writes watch.html to the folder of the results, which is there; throws OutputError where it cannot.
  WatchPage(std::filesystem::path folder, std::string study);
  /// The page says that the fit ended, if End() did not.
  ~WatchPage();
  WatchPage(const WatchPage&) = delete;
  WatchPage& operator=(const WatchPage&) = delete;

  /// Another fit begins, as in growth, whose costs are no continuation of those before.
  void Begin();

  /// Writes the page anew, unless the last one is fresh. A page that cannot be written ends no fit.
  void Show(const FitProgress& progress);

  /// Says how the fit ended, and leads to its report, if there is one: its path from the folder of the page.
  void End(const std::string& report, const std::string& how);

  const std::filesystem::path& file() const { return file_; }

 private:
  using Clock = std::chrono::steady_clock;

  struct Stage {
    std::string name;
    double began_s = 0;
    std::int64_t evaluations = 0;
  };

  double seconds() const;
  void Write(const std::string& next, double wait_s, const std::function<std::string()>& body) const;
  void Note(const FitProgress& progress);
  std::string Stages() const;
  std::string Chart() const;

  std::filesystem::path file_;
  std::string study_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point written_;
  bool has_ended_ = false;
  std::vector<Stage> stages_;
  /// Each below the one before, over time.
  std::vector<double> cost_;
  std::vector<double> cost_s_;
};

}  // namespace fourpost
