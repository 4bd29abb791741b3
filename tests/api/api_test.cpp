// The library as other programs see it.
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gmock/gmock.h>

#include <fourpost/fit.h>
#include <fourpost/read.h>
#include <fourpost/response.h>
#include <fourpost/search.h>
#include <fourpost/simulate.h>
#include <fourpost/units.h>
#include <fourpost/version.h>

#include "tests/temporary_folder.h"

namespace fourpost::api {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

const std::filesystem::path kSource = FOURPOST_SOURCE_DIR;

Vehicle QuarterCar() { return ReadVehicle(kSource / "urdf/quarter_car.urdf"); }

std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Of something to call: it throws an Error of this kind with a finding of this code.
auto Fails(Error::Kind kind, const std::string& code) {
  return testing::Throws<Error>(
      testing::AllOf(testing::Property(&Error::kind, kind),
                     testing::Property(&Error::findings, Contains(Field(&Finding::code, code)))));
}

TEST(Api, VehicleHasItsNamesAndValues) {
  Vehicle car = QuarterCar();
  EXPECT_EQ(car.name(), "quarter_car");
  EXPECT_EQ(car.posts().size(), 1);
  EXPECT_THAT(car.sensors(), Contains(Field(&Sensor::name, "a_sprung")));
  const Vehicle before = car;
  const Parameter first = car.parameters().front();
  car.Set(first.name, 0.5 * (first.lower + first.upper));
  EXPECT_DOUBLE_EQ(car.Value(first.name), 0.5 * (first.lower + first.upper));
  EXPECT_EQ(before.Value(first.name), first.value) << "a copy is another vehicle";
}

TEST(Api, ErrorsCarryCodesAndPlaces) {
  Vehicle car = QuarterCar();
  EXPECT_THAT([&] { car.Value("nothing"); }, Fails(Error::Kind::kInput, "name-unknown"));
  EXPECT_THAT([&] { Respond(car, {.frequency_Hz = {1}, .amplitude_m = {0.01}}).At("nothing"); },
              Fails(Error::Kind::kInput, "name-unknown"));
  EXPECT_THAT(
      [&] {
        Respond(car, {.frequency_Hz = {1, 2, 3}, .amplitude_m = {0.01, 0.02}});
      },
      Fails(Error::Kind::kInput, "amplitude-count"));
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "car.urdf") << "<robot name='car'>\n<link/>\n</robot>\n";
  try {
    ReadVehicle(folder.path() / "car.urdf");
    FAIL() << "a link without a name was read";
  } catch (const Error& error) {
    ASSERT_FALSE(error.findings().empty());
    EXPECT_EQ(error.findings().front().line, 2);
    EXPECT_EQ(error.findings().front().file, folder.path() / "car.urdf");
    EXPECT_FALSE(error.findings().front().code.empty());
  }
}

TEST(Api, UnitsGoBothWays) {
  EXPECT_EQ(ToSi("40 kN/m", "N/m"), 40e3);
  EXPECT_EQ(InUnit(40e3, "kN/m"), "40 kN/m");
  EXPECT_THAT([] { ToSi("40 kg", "N/m"); }, Fails(Error::Kind::kInput, "quantity-unreadable"));
  EXPECT_THAT([] { InUnit(1, "furlong"); }, Fails(Error::Kind::kInput, "unit-unknown"));
  EXPECT_EQ(Version(), "0.2.0");
}

/// Far below resonance the body follows the post.
TEST(Api, ResponseIsThatOfAQuarterCar) {
  const Response response = Respond(QuarterCar(), {.frequency_Hz = {0.05}, .amplitude_m = {0.01}});
  EXPECT_NEAR(std::abs(response.At("a_sprung").frf[0]), 1, 0.01);
  EXPECT_EQ(response.At("a_sprung").unit, "m/s^2");
}

/// The steady state of a simulated sine is the stepped sine's response: the laws are the same.
TEST(Api, SimulationSettlesToTheResponse) {
  const Vehicle car = QuarterCar();
  constexpr double kHertz = 3;
  constexpr double kRate = 1000;
  const Eigen::Index count = 8000;
  PostHeights posts{.rate_Hz = kRate};
  Eigen::VectorXd& height = posts.height_m[car.posts().front()];
  height.resize(count);
  for (Eigen::Index k = 0; k < count; ++k)
    height[k] = 0.01 * std::sin(2 * std::numbers::pi * kHertz * static_cast<double>(k) / kRate);
  const History history = Simulate(car, posts);
  const Response response = Respond(car, {.frequency_Hz = {kHertz}, .amplitude_m = {0.01}});
  const double acceleration =
      std::abs(response.At("a_sprung").frf[0]) * 0.01 * std::pow(2 * std::numbers::pi * kHertz, 2);
  // The first harmonic over the last 6 of 24 periods; an integration to 1e-3.
  const Eigen::VectorXd& body = history.readings.at("a_sprung");
  std::complex<double> sum = 0;
  for (Eigen::Index k = count - 2000; k < count; ++k)
    sum += body[k] * std::polar(1.0, -2 * std::numbers::pi * kHertz * static_cast<double>(k) / kRate);
  EXPECT_NEAR(std::abs(sum) * 2 / 2000, acceleration, 2e-3 * acceleration);
}

TEST(Api, FitOfHistoriesInMemoryFindsWhatMadeThem) {
  Vehicle car = ReadVehicle(kSource / "studies/starter/vehicle.urdf");
  Study study(car);
  study.free = {"k", "kt"};
  study.evaluations = 30;
  study.starts = 1;
  car.Set("k", "26 kN/m");
  constexpr double kRate = 200;
  PostHeights posts{.rate_Hz = kRate};
  Eigen::VectorXd& height = posts.height_m[car.posts().front()];
  height.resize(1000);
  for (Eigen::Index k = 0; k < height.size(); ++k) {
    const double t = static_cast<double>(k) / kRate;
    height[k] = 0.01 * (1 - std::cos(2 * t)) * std::sin(2 * std::numbers::pi * (1 + 2 * t) * t);
  }
  const History history = Simulate(car, posts);
  TimeHistoryTest test{.name = "chirp", .rate_Hz = kRate, .posts = posts.height_m};
  for (const char* sensor : {"a_body", "a_wheel", "F_tyre"}) test.channels[sensor] = history.readings.at(sensor);
  study.Add(test);
  const TemporaryFolder folder;
  const Result result = Fit(study, folder.path() / "run");
  EXPECT_TRUE(result.is_converged());
  // Integrated to 1e-3 of a channel, as the fit is.
  EXPECT_NEAR(result.At("k").value, 26e3, 26e3 * 2e-3);
  EXPECT_EQ(ReadResult(folder.path() / "run").At("k").value, result.At("k").value);
  EXPECT_THAT([&] { result.At("nothing"); }, Fails(Error::Kind::kInput, "name-unknown"));
}

TEST(Api, MeansAndStaticLoadsOfArraysAreFitted) {
  Vehicle car = ReadVehicle(kSource / "studies/starter/vehicle.urdf");
  Study study(car);
  study.free = {"c_bump", "c_rebound"};
  study.evaluations = 30;
  study.starts = 1;
  study.static_loads["tyre"] = {.load_N = 1, .sd_N = 1};
  SteppedSineTest test{.frequency_Hz = {1, 2, 4}, .amplitude_m = {0.01}};
  const Response measured = Respond(car, {test.frequency_Hz, test.amplitude_m});
  const ChannelResponse& strut = measured.At("s_strut");
  test.channels["s_strut"] = {.frf = strut.frf, .mean = strut.mean};
  study.Add(test);
  const TemporaryFolder folder;
  const std::filesystem::path file = study.Write(folder.path() / "study");
  const std::string table = TextOf(file.parent_path() / "stepped_sine_1.csv");
  EXPECT_THAT(table, testing::Not(HasSubstr(",,")));
  EXPECT_THAT(TextOf(file.parent_path() / "static_loads.csv"), HasSubstr("tyre,1,1,N"));
  // Three frequencies give a gain, a phase and a mean each; a load.
  EXPECT_EQ(Fit(study, folder.path() / "run", {.accept_unidentified = true}).residuals, 10);
  test.channels["s_strut"].mean = Eigen::VectorXd::Zero(2);
  study.Add(test);
  EXPECT_THAT([&] { study.Write(folder.path() / "other"); }, Fails(Error::Kind::kInput, "arrays-unequal"));
}

TEST(Api, NoiseAndFilterOfHistoriesAreThoseOfTheirStudy) {
  const Vehicle car = QuarterCar();
  TimeHistoryTest test{.name = "rough",
                       .rate_Hz = 500,
                       .posts = {{car.posts().front(), Eigen::VectorXd::LinSpaced(500, 0, 0.01)}},
                       .channels = {{"a_sprung", Eigen::VectorXd::LinSpaced(500, 0, 1)}},
                       .noise = {{"a_sprung", 0.25}},
                       .filter = LowPass{.order = 4, .cutoff_Hz = 30}};
  Study study(car);
  study.Add(test);
  const TemporaryFolder folder;
  const std::string text = TextOf(study.Write(folder.path() / "study"));
  EXPECT_THAT(text, HasSubstr("filter: {order: 4, cutoff: 30 Hz}"));
  EXPECT_THAT(text, HasSubstr("\"a_sprung\": 0.25 m/s^2"));
}

TEST(Api, StudiesOfFilesTakeNothingElse) {
  const TemporaryFolder folder;
  Study study(kSource / "studies/starter/study.yaml");
  EXPECT_EQ(study.Write(folder.path() / "none"), kSource / "studies/starter/study.yaml");
  study.seed = 2;
  EXPECT_THAT([&] { Fit(study, folder.path() / "run"); }, Fails(Error::Kind::kInput, "study-of-file"));
  study.seed = 1;
  study.Add(BenchTest{});
  EXPECT_THAT([&] { study.Write(folder.path() / "none"); }, Fails(Error::Kind::kInput, "study-of-file"));
}

TEST(Api, FindingsNameTheirArgument) {
  try {
    Respond(QuarterCar(), {.frequency_Hz = {1}, .amplitude_m = {0.01}, .posts = "hop"});
    FAIL();
  } catch (const Error& error) {
    ASSERT_EQ(error.findings().size(), 1u);
    EXPECT_EQ(error.findings().front().argument, "--mode");
  }
}

TEST(Api, HistoriesRefuseWhatIsForSteppedSines) {
  const Vehicle car = QuarterCar();
  PostHeights posts{.rate_Hz = 100, .height_m = {{car.posts().front(), Eigen::VectorXd::Zero(10)}}};
  EXPECT_THAT([&] { Simulate(car, posts, Engine::kTimeIntegration); }, Fails(Error::Kind::kInput, "engine-of-sines"));
  posts.rate_Hz = 0;
  EXPECT_THAT([&] { Simulate(car, posts); }, Fails(Error::Kind::kInput, "rate-not-positive"));
}

TEST(Api, StudiesOfArraysAreChecked) {
  const Vehicle car = QuarterCar();
  const TemporaryFolder folder;
  EXPECT_THAT([&] { Fit(Study(car), folder.path() / "run"); }, Fails(Error::Kind::kInput, "study-empty"));
  Study study(car);
  study.Add(SteppedSineTest{
      .frequency_Hz = {1, 2}, .amplitude_m = {0.01}, .channels = {{"a_sprung", {Eigen::VectorXcd(3)}}}});
  EXPECT_THAT([&] { Fit(study, folder.path() / "run"); }, Fails(Error::Kind::kInput, "arrays-unequal"));
  EXPECT_THAT([&] { ReadResult(folder.path()); },
              testing::Throws<Error>(testing::Property(&Error::kind, Error::Kind::kInput)));
}

TEST(Api, MinimisesResidualsOfAnyKind) {
  const std::vector<Axis> axes = {{"a", -5, 5, 0.01}, {"b", 1, 20, 1, true}};
  const auto residuals = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::Vector2d(x[0] - 1.23, x[1] - 7));
  };
  const Minimum minimum = Minimise(axes, residuals, {.evaluations = 2000, .target = 1e-6});
  EXPECT_NEAR(minimum.values[0], 1.23, 1e-3);
  EXPECT_EQ(minimum.values[1], 7);
  EXPECT_LE(minimum.evaluations, 2000);
  EXPECT_THAT([&] { Minimise(axes, residuals, {.method = "dvdhe"}); }, Fails(Error::Kind::kInput, "search-method"));
  EXPECT_THAT([&] { Minimise({{"a", 1, 0, 0.1}}, residuals); }, Fails(Error::Kind::kInput, "search-axes"));
  const auto fails = [](const Eigen::VectorXd&) -> Eigen::VectorXd { throw std::runtime_error("no"); };
  EXPECT_THAT([&] { Minimise(axes, fails, {.evaluations = 50}); },
              testing::Throws<Error>(testing::Property(&Error::kind, Error::Kind::kSimulation)));
}

}  // namespace
}  // namespace fourpost::api
