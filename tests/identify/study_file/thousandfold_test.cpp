#include "identify/study_file/thousandfold.h"

#include <fstream>

#include <gtest/gtest.h>

#include "identify/study_file/channel_source_text.h"

namespace fourpost::thousandfold_test {
namespace {

class UnitMeant : public testing::Test {
 protected:
  UnitMeant() { std::ofstream(file_) << "time,s,a,F,r\ns,mm,g,kN,rad/s\n0,1,1,1,1\n0.1,2,2,2,2\n0.2,1,1,1,1\n"; }
  ~UnitMeant() override { std::filesystem::remove(file_); }

  std::string Of(const std::string& channel, double times, const std::string& stated = "") const {
    ChannelSource source{.channels = {SourceChannel(channel)}};
    source.channels.front().unit = stated;
    const std::optional<ChannelSource> meant = WithUnitOfTimes(source, times, {file_});
    return meant ? SourceText(*meant) : "none";
  }

 private:
  std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / "fourpost_unit_meant.csv";
};

TEST_F(UnitMeant, IsNamedWhereOneIsSoManyTimesTheOther) {
  EXPECT_EQ(Of("s", 1e-3, "m"), "{channel: s, unit: mm}");
  EXPECT_EQ(Of("s", 1e3), "{channel: s, unit: m}");
  EXPECT_EQ(Of("s", 25.4), "{channel: s, unit: in}");
  EXPECT_EQ(Of("a", 1 / 9.80665), "{channel: a, unit: m/s^2}");
  EXPECT_EQ(Of("a", 9.80665, "m/s^2"), "{channel: a, unit: g}");
  EXPECT_EQ(Of("F", 1e-3), "{channel: F, unit: N}");
}

TEST_F(UnitMeant, IsNoneOfAnotherFactor) {
  EXPECT_EQ(Of("s", 2), "none");
  EXPECT_EQ(Of("r", 1e-3), "none");
  EXPECT_EQ(Of("missing", 1e-3), "none");
}

}  // namespace
}  // namespace fourpost::thousandfold_test
