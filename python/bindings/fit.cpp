#include <mutex>
#include <utility>

#include <fourpost/fit.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

/// What a running fit reports, handed from its threads to that of the interpreter.
class FitNews {
 public:
  FitNews(py::object progress, py::object warn) : progress_(std::move(progress)), warn_(std::move(warn)) {}

  void Add(const api::FitProgress& progress) {
    const std::lock_guard lock(mutex_);
    latest_ = progress;
  }
  void Add(const api::Finding& finding) {
    const std::lock_guard lock(mutex_);
    findings_.push_back(finding);
  }

  /// Calls Python with what is new: of progress the latest.
  void Show() {
    std::optional<api::FitProgress> latest;
    std::vector<api::Finding> findings;
    {
      const std::lock_guard lock(mutex_);
      latest = std::exchange(latest_, std::nullopt);
      findings.swap(findings_);
    }
    for (const api::Finding& finding : findings) warn_(FindingOf(finding));
    if (latest && !progress_.is_none())
      progress_(latest->stage, latest->evaluations, latest->failed, latest->best_cost);
  }

 private:
  py::object progress_;
  py::object warn_;
  std::mutex mutex_;
  std::optional<api::FitProgress> latest_;
  std::vector<api::Finding> findings_;
};

void Fit(const api::Study& study, const std::filesystem::path& folder, int threads,
         const std::optional<std::uint64_t>& seed, bool resume, bool accept_unidentified, bool accept_implausible,
         py::object progress, py::object warn) {
  FitNews news(std::move(progress), std::move(warn));
  const auto fit = [&](const Stop& stop) {
    return api::Fit(study, folder,
                    {.seed = seed,
                     .threads = threads,
                     .resume = resume,
                     .accept_unidentified = accept_unidentified,
                     .accept_implausible = accept_implausible,
                     .stop = stop,
                     .warn = [&](const api::Finding& finding) { news.Add(finding); },
                     .progress = [&](const api::FitProgress& now) { news.Add(now); }});
  };
  Computed(fit, [&] { news.Show(); });
}

}  // namespace

void BindFit(py::module_& module) { module.def("fit", &Fit); }

}  // namespace fourpost::python
