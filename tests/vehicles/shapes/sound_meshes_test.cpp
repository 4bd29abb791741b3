#include "vehicles/shapes/sound_meshes.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "vehicles/shapes/mesh.h"
#include "vehicles/shapes/shape_error.h"

namespace fourpost::sound_meshes_test {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

void Write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(SoundMeshes, AreCheckedAgainWhenTheyChange) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.obj";
  Write(file, kTriangle);
  EXPECT_NO_THROW(CheckMesh(file));
  EXPECT_NO_THROW(CheckMesh(file));
  Write(file, "v 0 0 0\n");
  EXPECT_THROW(CheckMesh(file), ShapeError);
  std::filesystem::remove(file);
  EXPECT_THROW(CheckMesh(file), ShapeError);
}

TEST(SoundMeshes, AreNotReadAgain) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.obj";
  Write(file, kTriangle);
  CheckMesh(file);
  // Of the same size and time, which no editor leaves.
  const auto time = std::filesystem::last_write_time(file);
  std::string broken = kTriangle;
  broken.replace(broken.find("f 1 2 3"), 7, "f 1 2 9");
  Write(file, broken);
  std::filesystem::last_write_time(file, time);
  EXPECT_NO_THROW(CheckMesh(file));
  EXPECT_THROW(ReadMesh(file), ShapeError);
}

TEST(SoundMeshes, DoNotHoldFaultyOnes) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.obj";
  Write(file, "v 0 0 0\n");
  EXPECT_THROW(CheckMesh(file), ShapeError);
  EXPECT_THROW(CheckMesh(file), ShapeError);
}

}  // namespace
}  // namespace fourpost::sound_meshes_test
