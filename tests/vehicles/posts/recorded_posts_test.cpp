#include "vehicles/posts/recorded_posts.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "analysis/files/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"
#include "tests/vehicles/posts/consistent_motion.h"
#include "tests/vehicles/shipped_vehicle.h"

namespace fourpost::recorded_posts_test {
namespace {

/// Post of the quarter car at 2 Hz, 5 mm about 3 mm, sampled at 200 Hz from 10 s on.
double Height(double t) { return 0.003 + 0.005 * std::sin(4 * std::numbers::pi * t); }

std::string Record(const std::string& head, const std::string& units, int count = 401) {
  std::ostringstream text;
  text << head << '\n' << units << '\n';
  text.precision(12);
  for (int k = 0; k < count; ++k) {
    const double t = 10 + k * 0.005;
    text << t << ',' << 1e3 * Height(t) << '\n';
  }
  return text.str();
}

class Recorded : public testing::Test {
 protected:
  Recorded() {
    post_ = vehicle_.posts[0].name;
    good_ = Record("time," + post_, "s,mm");
  }
  std::optional<RecordedPosts> Read(const std::string& text) {
    return ReadRecordedPosts(folder_.Write("posts.csv", text), vehicle_, diagnostics_);
  }
  Diagnostics FaultOf(const std::string& text) {
    EXPECT_FALSE(Read(text));
    return diagnostics_;
  }

  TemporaryFolder folder_;
  Vehicle vehicle_ = ShippedVehicle("quarter_car");
  std::string post_;
  std::string good_;
  Diagnostics diagnostics_;
};

TEST_F(Recorded, FollowsItsSamplesSmoothly) {
  const std::optional<RecordedPosts> record = Read(good_);
  ASSERT_TRUE(record) << diagnostics_.Format();
  EXPECT_EQ(record->start_s, 10);
  EXPECT_EQ(record->end_s, 12);
  EXPECT_NEAR(record->step_s, 0.005, 1e-12);
  std::array<PostState, 1> posts;
  const double w = 4 * std::numbers::pi;
  // Between samples: a cubic spline at 100 samples a period, (2 pi / 100)^4 / 384 and (2 pi / 100)^2 / 12.
  record->motion(10.9987, posts);
  EXPECT_NEAR(posts[0].height, Height(10.9987), 1e-9);
  EXPECT_NEAR(posts[0].velocity, 0.005 * w * std::cos(w * 10.9987), 1e-5 * w * 0.005);
  record->motion(11.1237, posts);
  EXPECT_NEAR(posts[0].acceleration, -0.005 * w * w * std::sin(w * 11.1237), 5e-4 * w * w * 0.005);
  ExpectConsistent(record->motion, 1, 10 - record->lead_s, 12, 0.005);
}

// From rest at height 0 to the first sample's height and velocity.
TEST_F(Recorded, IsLedInFromRest) {
  const std::optional<RecordedPosts> record = Read(good_);
  ASSERT_TRUE(record);
  std::array<PostState, 1> posts;
  record->motion(10 - record->lead_s, posts);
  EXPECT_NEAR(posts[0].height, 0, 1e-12);
  EXPECT_NEAR(posts[0].velocity, 0, 1e-9);
  double highest = 0;
  double fastest = 0;
  for (double t = 8; t < 10; t += 0.001) {
    record->motion(t, posts);
    highest = std::max(highest, std::abs(posts[0].height));
    fastest = std::max(fastest, std::abs(posts[0].acceleration));
  }
  // The polynomial turns back before it meets the velocity; gentler than the record, whose acceleration goes to 0.79.
  EXPECT_LT(highest, 0.03);
  EXPECT_LT(fastest, 0.79);
}

TEST_F(Recorded, MayCallAPostByItsTag) {
  EXPECT_TRUE(Read(Record("time,post_" + post_, "s,mm"))) << diagnostics_.Format();
}

TEST_F(Recorded, NamesPostsThatAreMissing) {
  EXPECT_THAT(FaultOf(Record("time,height", "s,mm")), Reports(kChannelColumnMissing, {"'" + post_ + "'"}));
}

TEST_F(Recorded, NamesUnitsThatAreNoLength) {
  EXPECT_THAT(FaultOf(Record("time," + post_, "s,kN")),
              Reports(kUnitOfOtherDimension, 2, {"'" + post_ + "'", "'kN'", "'mm'"}));
}

TEST_F(Recorded, NamesSamplesWithoutANumber) {
  const std::string text = Replace(good_, "\n10.5,", "\n10.5,lost");
  EXPECT_THAT(FaultOf(text), Reports(kSampleMissing, 103, {"'" + post_ + "'", "'lost"}));
}

TEST_F(Recorded, NamesGaps) {
  std::string text = good_;
  const std::size_t gap = text.find("\n10.5,");
  text.erase(gap, text.find("\n11,") - gap);
  EXPECT_THAT(FaultOf(text), Reports(kTimeStepUneven, 103, {"10.495 s", "11 s"}));
}

TEST_F(Recorded, NamesTimesThatStepBack) {
  EXPECT_THAT(FaultOf(Replace(good_, "\n10.5,", "\n9,")), Reports(kTimeStepUneven, {"10.495 s", "9 s"}));
}

TEST_F(Recorded, NamesRecordsThatAreTooShort) {
  EXPECT_THAT(FaultOf(Record("time," + post_, "s,mm", 3)), Reports(kTooFewSamples, {"3"}));
}

}  // namespace
}  // namespace fourpost::recorded_posts_test
