#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/fit.h"
#include "identify/fit_verdict.h"
#include "identify/loaded_study.h"
#include "identify/misfit.h"

namespace fourpost {

/// What one kind of data adds to the results of a fit.
struct FitSection {
  /// Tables for the terminal.
  std::string text;
  Misfits misfits;
  /// Of the whole fit.
  FitVerdict verdict;
  /// Warnings of recordings that can hardly be right, judged after the fit.
  Diagnostics findings;
  /// Names in the folder of the results, and what they hold.
  std::vector<std::pair<std::string, std::string>> files;
};

/// Of stepped-sine responses and static loads; empty for a study without.
FitSection FourPostSection(const LoadedStudy& study, const FitResult& fit);

/// Of time histories; empty for a study without. `engines`: what is known of each fitted one, see CheckHistories;
/// empty: nothing, for the fit was cut short.
FitSection HistorySection(const LoadedStudy& study, const FitResult& fit, const std::vector<HistoryEngine>& engines);

/// Of a damper on its bench; empty for a study without.
FitSection BenchSection(const LoadedStudy& study, const FitResult& fit);

}  // namespace fourpost
