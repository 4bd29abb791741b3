#include "identify/experiments/bench/force_memory.h"

#include <gmock/gmock.h>

#include "tests/identify/shipped_study.h"

namespace fourpost::force_memory_test {
namespace {

/// The linear damper of Model 1 at two settings: a parameter that holds its rate at the second one.
class ForceMemoryTest : public ::testing::Test {
 protected:
  ForceMemoryTest() {
    Diagnostics diagnostics;
    const LoadedStudy study =
        *LoadStudy(std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies/damper/model1.yaml", diagnostics);
    vehicle_ = study.vehicle;
    vehicle_.parameters.push_back(vehicle_.parameters.front());
    recordings_.assign(2, Bench(study).data.fitted.front());
    recordings_[1].setting.blends = {{.parameter = 0, .lower = 0, .upper = 1, .share = 1}};
  }

  std::vector<double> Force(ForceMemory& memory, std::size_t place, const std::vector<double>& values) const {
    return *memory.Of(place, BenchDamper(vehicle_, 0), recordings_[place], values);
  }

  std::vector<double> Modelled(std::size_t place, const std::vector<double>& values) const {
    return ModelledForce(BenchDamper(vehicle_, 0), recordings_[place], values);
  }

  Vehicle vehicle_;
  std::vector<BenchRecording> recordings_;
};

TEST_F(ForceMemoryTest, IsThatOfTheModel) {
  ForceMemory memory(vehicle_, recordings_);
  for (const std::vector<double>& values : {std::vector<double>{1000, 2000}, {1000, 3000}, {500, 3000}, {1000, 2000}})
    for (const std::size_t place : {0U, 1U}) EXPECT_EQ(Force(memory, place, values), Modelled(place, values));
}

TEST_F(ForceMemoryTest, ModelsARecordingOnlyForWhatItFollows) {
  ForceMemory memory(vehicle_, recordings_);
  Force(memory, 0, {1000, 2000});
  Force(memory, 1, {1000, 2000});
  EXPECT_EQ(memory.modelled(), 2U);
  // Of the second setting alone.
  Force(memory, 0, {1000, 3000});
  EXPECT_EQ(memory.modelled(), 2U);
  Force(memory, 1, {1000, 3000});
  EXPECT_EQ(memory.modelled(), 3U);
  // As before.
  Force(memory, 1, {1000, 2000});
  EXPECT_EQ(memory.modelled(), 3U);
}

TEST_F(ForceMemoryTest, ModelsAgainWhereTheParameterHasAnotherUse) {
  vehicle_.dampers[0].law.friction = DashpotDescription::Friction{{.parameter = 1}, {0.01}};
  ForceMemory memory(vehicle_, recordings_);
  Force(memory, 0, {1000, 20});
  EXPECT_EQ(Force(memory, 0, {1000, 30}), Modelled(0, {1000, 30}));
  EXPECT_EQ(memory.modelled(), 2U);
}

TEST_F(ForceMemoryTest, ForgetsWhatIsOld) {
  ForceMemory memory(vehicle_, recordings_);
  for (int i = 0; i < 100; ++i) Force(memory, 0, {1000.0 + i, 2000});
  EXPECT_EQ(memory.modelled(), 100U);
  Force(memory, 0, {1000, 2000});
  EXPECT_EQ(memory.modelled(), 101U);
}

}  // namespace
}  // namespace fourpost::force_memory_test
