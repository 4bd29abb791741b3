#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "identify/loaded_study.h"

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

}  // namespace fourpost
