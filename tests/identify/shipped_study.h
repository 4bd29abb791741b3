#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "identify/loaded_study.h"

namespace fourpost {

inline const std::filesystem::path kLandRoverStudy =
    std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/landrover110/model2.yaml";

/// The Land Rover's study, which must read without a finding.
inline LoadedStudy ShippedStudy() {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> study = LoadStudy(kLandRoverStudy, diagnostics);
  EXPECT_EQ(diagnostics.Format(), "");
  return std::move(study).value();
}

}  // namespace fourpost
