#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "identify/experiments/bench/damper_bench.h"
#include "identify/experiments/four_post/four_post.h"
#include "identify/experiments/static_loads/static_loads.h"
#include "identify/experiments/time_history/time_histories.h"
#include "identify/study/loaded_study.h"

namespace fourpost {

inline const std::filesystem::path kLandRoverStudy =
    std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110/model2.yaml";

/// A study of the Land Rover, which must read without a finding.
inline LoadedStudy ShippedStudy(const std::string& name = "model2") {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> study = LoadStudy(kLandRoverStudy.parent_path() / (name + ".yaml"), diagnostics);
  EXPECT_EQ(diagnostics.Format(), "");
  return std::move(study).value();
}

/// The experiments of a study that has them.
inline FourPost& Sines(LoadedStudy& study) { return *study.study.experiments.Find<FourPost>(); }
inline const FourPost& Sines(const LoadedStudy& study) { return *study.study.experiments.Find<FourPost>(); }
inline StaticLoadTest& Rest(LoadedStudy& study) { return *study.study.experiments.Find<StaticLoadTest>(); }
inline const StaticLoadTest& Rest(const LoadedStudy& study) { return *study.study.experiments.Find<StaticLoadTest>(); }
inline const DamperBench& Bench(const LoadedStudy& study) { return *study.study.experiments.Find<DamperBench>(); }

}  // namespace fourpost
