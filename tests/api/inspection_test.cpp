// Before there is a fit: what files hold, responses of recordings, modes.
#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>

#include <fourpost/frf.h>
#include <fourpost/info.h>
#include <fourpost/modes.h>
#include <fourpost/vehicle.h>

namespace fourpost::api::inspection_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

const std::filesystem::path kSource = FOURPOST_SOURCE_DIR;
const std::filesystem::path kSweep = kSource / "studies/landrover110/bounce_sweep.csv";

Vehicle StarterCar() { return ReadVehicle(kSource / "studies/starter/vehicle.urdf"); }

/// Of something to call: it throws an Error with a finding of this code.
auto IsRefused(const std::string& code) {
  return testing::Throws<Error>(
      testing::AllOf(testing::Property(&Error::kind, Error::Kind::kInput),
                     testing::Property(&Error::findings, Contains(Field(&Finding::code, code)))));
}

FrfOptions PostsOfSweep() {
  return {.posts = {{"FL", "z_post_FL"}, {"FR", "z_post_FR"}, {"RL", "z_post_RL"}, {"RR", "z_post_RR"}}};
}

TEST(Inspection, DescribesRecordingsAndStudies) {
  const Info recording = Describe(kSweep);
  EXPECT_THAT(recording.json, HasSubstr("\"time_history\""));
  EXPECT_THAT(recording.text, HasSubstr("a_tow_point"));
  EXPECT_THAT(Describe(kSource / "studies/landrover110/model2.yaml").text, HasSubstr("audit of the rig"));
  EXPECT_THAT([] { Describe(kSource / "urdf/quarter_car.urdf"); }, IsRefused("vehicle-for-recording"));
}

TEST(Inspection, ResponsesOfASweepAreThoseOfItsPosts) {
  FrfOptions options = PostsOfSweep();
  options.frequency_Hz = {2, 5};
  const FrfMeasurement found = MeasureFrf({kSweep}, options);
  EXPECT_EQ(found.kind, "sweep");
  ASSERT_EQ(found.patterns.size(), 1);
  const MeasuredPattern& heave = found.patterns.front();
  EXPECT_EQ(heave.posts, "heave");
  EXPECT_THAT(heave.frequency_Hz, ElementsAre(2, 5));
  const auto post = std::find_if(heave.channels.begin(), heave.channels.end(),
                                 [](const MeasuredChannel& channel) { return channel.name == "a_post_FR"; });
  ASSERT_NE(post, heave.channels.end());
  // An accelerometer on a post of the pattern follows it: 1 within its scale error.
  for (const std::complex<double>& value : post->frf) EXPECT_NEAR(std::abs(value), 1, 0.03);
  EXPECT_EQ(post->coherence.size(), 2);
  EXPECT_EQ(post->mean.size(), 0);
}

TEST(Inspection, WrongRequestsAreRefused) {
  EXPECT_THAT([] { MeasureFrf({kSweep}, {.posts = {{"FL", "nowhere"}}}); }, IsRefused("response-post-missing"));
  EXPECT_THAT([] { MeasureFrf({}); }, IsRefused("argument-refused"));
  FrfOptions options = PostsOfSweep();
  options.kind = "steped";
  EXPECT_THAT([&] { MeasureFrf({kSweep}, options); }, IsRefused("name-unknown"));
}

/// The sum of all poles is the trace of the state matrix, and -c / m of two dashpots' masses.
TEST(Inspection, ModesAreThoseOfTheStateSpace) {
  const Vehicle car = StarterCar();
  const Modes found = FindModes(car);
  ASSERT_EQ(found.modes.size(), 2);
  EXPECT_EQ(found.modes[0].name, "heave");
  EXPECT_EQ(found.modes[1].name, "wheel hop");
  double sum = 0;
  for (const Mode& mode : found.modes) sum += 2 * mode.poles.front().real();
  // Rounding of an eigenvalue.
  EXPECT_NEAR(sum, found.state_space.a.trace(), 1e-10 * std::abs(sum));
  const double c = 0.5 * (car.Value("c_bump") + car.Value("c_rebound"));
  EXPECT_NEAR(sum, -c / car.Value("m_body") - c / car.Value("m_wheel"), 1e-6 * std::abs(sum));
  EXPECT_THAT(found.state_space.posts, ElementsAre(car.posts().front()));
}

TEST(Inspection, PolesFollowAParameter) {
  const Vehicle car = StarterCar();
  const std::vector<PolePath> paths = FollowPoles(car, "k", {15e3, 20e3, 30e3});
  ASSERT_EQ(paths.size(), 2);
  EXPECT_EQ(paths[0].mode, "heave");
  // At the value of the vehicle it is its mode's.
  EXPECT_NEAR(std::abs(paths[0].poles[1] - FindModes(car).modes[0].poles.front()), 0, 1e-10);
  EXPECT_LT(std::abs(paths[0].poles[0]), std::abs(paths[0].poles[2]));
  EXPECT_THAT([&] { FollowPoles(car, "kk", {1}); }, IsRefused("name-unknown"));
  EXPECT_THAT([&] { FollowPoles(car, "k", {-1}); }, IsRefused("setting-sign"));
}

}  // namespace
}  // namespace fourpost::api::inspection_test
