#include "identify/experiments/four_post/response_table.h"

#include <cmath>

#include <gmock/gmock.h>

#include "identify/experiments/findings.h"
#include "tests/findings.h"

namespace fourpost::response_table_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kHead =
    "recording,channel,unit,frequency_Hz,post_amplitude_m,in_band,gain_measured,gain_modelled,phase_measured_deg,"
    "phase_modelled_deg,mean_measured,mean_modelled";

TEST(ResponseTable, GroupsRowsByRecordingAndChannel) {
  const std::vector<ComparedChannel> channels =
      ReadResponseTable(std::string(kHead) +
                            ",gain_sd,phase_sd_deg,gain_start,phase_start_deg\n"
                            "bounce,a,m/s^2,1,0.01,1,2,2.5,-10,-12,,,0.1,,3,-20\n"
                            "bounce,a,m/s^2,2,0.01,0,1,1.5,-20,-22,,,0.2,,4,-30\n"
                            "pitch,a,m/s^2,1,0.01,1,5,5.5,-30,-32,,,0.3,,6,-40\n",
                        "response.csv");
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[0].recording, "bounce");
  EXPECT_THAT(channels[0].frequency_Hz, ElementsAre(1, 2));
  EXPECT_THAT(channels[0].in_band, ElementsAre(true, false));
  EXPECT_THAT(channels[0].gain_sd, ElementsAre(0.1, 0.2));
  EXPECT_THAT(channels[0].phase_start_deg, ElementsAre(-20, -30));
  EXPECT_TRUE(std::isnan(channels[0].phase_sd_deg[0]));
  EXPECT_THAT(channels[1].gain_modelled, ElementsAre(5.5));
}

TEST(ResponseTable, TakesTablesOfEarlierVersions) {
  const auto channels =
      ReadResponseTable(std::string(kHead) + "\nbounce,a,m,1,0.01,1,2,2.5,-10,-12,0.1,0.2\n", "response.csv");
  EXPECT_THAT(channels.at(0).mean_modelled, ElementsAre(0.2));
  EXPECT_THAT(channels.at(0).gain_start, IsEmpty());
}

TEST(ResponseTable, TellsEveryColumnThatIsMissing) {
  EXPECT_THAT([] { ReadResponseTable("recording,channel,frequency_Hz\nbounce,a,1\n", "response.csv"); },
              AllOf(Refuses(kFitColumnMissing, 1, {"'unit'"}), Refuses(kFitColumnMissing, 1, {"'gain_measured'"})));
}

}  // namespace
}  // namespace fourpost::response_table_test
