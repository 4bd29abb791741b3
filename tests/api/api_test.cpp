// The library as other programs see it.
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gmock/gmock.h>

#include <fourpost/fit.h>
#include <fourpost/objective.h>
#include <fourpost/response.h>
#include <fourpost/run.h>
#include <fourpost/search.h>
#include <fourpost/simulate.h>
#include <fourpost/units.h>
#include <fourpost/vehicle.h>
#include <fourpost/version.h>

#include "tests/temporary_folder.h"

namespace fourpost::api::api_test {
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
  EXPECT_EQ(SiUnitOf("kN/m"), "N/m");
  EXPECT_EQ(SiUnitOf(""), "1");
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

TEST(Api, DeviationsOfArraysAreNotNegative) {
  const Vehicle car = ReadVehicle(kSource / "studies/starter/vehicle.urdf");
  const TemporaryFolder folder;
  const auto refuses = [&](const char* sensor, const MeasuredFrf& measured) {
    Study study(car);
    study.Add(SteppedSineTest{.frequency_Hz = {1, 2}, .amplitude_m = {0.01}, .channels = {{sensor, measured}}});
    EXPECT_THAT([&] { study.Write(folder.path() / "study"); }, Fails(Error::Kind::kInput, "array-negative"));
  };
  const Eigen::VectorXcd frf = Eigen::VectorXcd::Ones(2);
  const Eigen::VectorXd one_below = Eigen::Vector2d(0.1, -0.1);
  refuses("a_body", {.frf = frf, .relative_sd_at = one_below});
  refuses("s_strut", {.frf = frf, .mean = Eigen::VectorXd::Zero(2), .mean_sd = one_below});
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

/// A study of stepped sines that the starter's vehicle made with another spring.
Study SinesOfASofterCar() {
  Vehicle car = ReadVehicle(kSource / "studies/starter/vehicle.urdf");
  Study study(car);
  study.free = {"k", "c_bump"};
  car.Set("k", "26 kN/m");
  SteppedSineTest test{.frequency_Hz = {0.6, 1, 1.5, 2, 3, 5, 8, 12}, .amplitude_m = {0.01}};
  const Response measured = Respond(car, {test.frequency_Hz, test.amplitude_m});
  for (const char* sensor : {"a_body", "s_strut", "F_tyre"})
    test.channels[sensor] = {.frf = measured.At(sensor).frf, .mean = measured.At(sensor).mean};
  study.Add(test);
  return study;
}

TEST(Api, BatchIsItsSingleResponsesToTheLastBit) {
  const Vehicle car = ReadVehicle(kSource / "studies/starter/vehicle.urdf");
  const SteppedSine sine = UsualSine(car);
  ParameterTable table{.parameters = {"k", "c_bump"}, .values = Eigen::MatrixXd(3, 2)};
  table.values << 21e3, 900, -1, 900, 34e3, 2500;
  for (const Engine engine : {Engine::kReduced, Engine::kAuto}) {
    const std::vector<RowResponse> rows = RespondAt(car, table, sine, {.engine = engine, .threads = 2});
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_FALSE(rows[1].response) << "no spring has a rate below zero";
    EXPECT_THAT(rows[1].why, HasSubstr("setting-sign"));
    for (const std::size_t i : {0u, 2u}) {
      Vehicle one = car;
      one.Set("k", table.values(static_cast<Eigen::Index>(i), 0));
      one.Set("c_bump", table.values(static_cast<Eigen::Index>(i), 1));
      const Response alone = Respond(one, sine, engine);
      ASSERT_TRUE(rows[i].response);
      for (const ChannelResponse& channel : alone.channels)
        EXPECT_EQ(rows[i].response->At(channel.sensor).frf, channel.frf) << channel.sensor;
    }
  }
  table.parameters.pop_back();
  EXPECT_THAT([&] { RespondAt(car, table, sine); }, Fails(Error::Kind::kInput, "table-shape"));
}

TEST(Api, MotionsThatCannotBeAreRefused) {
  const Vehicle car = QuarterCar();
  const double nan = std::nan("");
  EXPECT_THAT([&] { Respond(car, {.frequency_Hz = {1}, .amplitude_m = {12}}); },
              Fails(Error::Kind::kInput, "usual-stroke-exceeded"));
  EXPECT_THAT([&] { Respond(car, {.frequency_Hz = {nan}, .amplitude_m = {0.01}}); },
              Fails(Error::Kind::kInput, "number-not-finite"));
  EXPECT_THAT([&] { Respond(car, {.frequency_Hz = {-1}, .amplitude_m = {0.01}}); },
              Fails(Error::Kind::kInput, "engine-refused"));
  PostHeights posts{.rate_Hz = 100, .height_m = {{car.posts().front(), Eigen::VectorXd::Constant(10, 2)}}};
  EXPECT_THAT([&] { Simulate(car, posts); }, Fails(Error::Kind::kInput, "usual-stroke-exceeded"));
  posts.height_m.begin()->second.setConstant(nan);
  EXPECT_THAT([&] { Simulate(car, posts); }, Fails(Error::Kind::kInput, "number-not-finite"));
  posts.height_m.begin()->second.setZero();
  EXPECT_THAT([&] { Simulate(car, posts, Engine::kAuto, [] { return true; }); },
              testing::Throws<Error>(testing::Property(&Error::kind, Error::Kind::kSimulation)));
}

TEST(Api, ObjectiveIsWhatAFitMinimises) {
  const Study study = SinesOfASofterCar();
  const TemporaryFolder folder;
  const Result result = Fit(study, folder.path() / "run");
  const Objective objective(study);
  ASSERT_EQ(objective.parameters().size(), 2u);
  EXPECT_EQ(objective.residual_count(), result.residuals);
  Eigen::VectorXd values(2);
  for (Eigen::Index j = 0; j < 2; ++j)
    values[j] = result.At(objective.parameters()[static_cast<std::size_t>(j)].name).value;
  EXPECT_EQ(objective.CostsAt(values.transpose())[0], result.cost);
  EXPECT_EQ(objective.ResidualsAt(values.transpose()).row(0).transpose(), objective.Residuals(values));
  // At the least cost; beside it the slope is that way.
  EXPECT_LT((objective.Jacobian(values).transpose() * objective.Residuals(values)).cwiseProduct(values).norm(), 0.01);
  EXPECT_THAT([&] { objective.Residuals(Eigen::VectorXd::Ones(3)); }, Fails(Error::Kind::kInput, "table-shape"));
  EXPECT_THAT([&] { objective.Jacobian(1e9 * values); }, Fails(Error::Kind::kInput, "value-out-of-range"));
}

TEST(Api, DrawsPredictionsAndChoicesComeFromTheFolderOfAFit) {
  const TemporaryFolder folder;
  const std::filesystem::path run = folder.path() / "run";
  const Result result = Fit(Study(kSource / "studies/starter/study.yaml"), run);
  const Draws draws = Draw(run, {.count = 50});
  ASSERT_EQ(draws.values.rows(), 50);
  EXPECT_EQ(draws.parameters.size(), result.parameters.size());
  EXPECT_NEAR(draws.values.col(0).mean(), result.parameters[0].value, result.parameters[0].sd);
  const Prediction prediction =
      Predict(run, kSource / "studies/starter/stepped_sine.csv", {.output = folder.path() / "p"});
  EXPECT_THAT(prediction.json, HasSubstr("\"was_fitted\": true"));
  EXPECT_EQ(TextOf(folder.path() / "p/result.json"), prediction.json);
  const std::filesystem::path settings = folder.path() / "settings.yaml";
  std::ofstream(settings) << "knobs:\n  spring: {sets: k, range: {from: 12 kN/m, to: 28 kN/m, step: 8 kN/m}}\n"
                             "roads:\n  - {class: B, speed: 80 km/h}\ndraws: 20\nduration: 5 s\n";
  EXPECT_THAT(Choose(run, settings).json, HasSubstr("\"best\""));
  const auto stop = [] { return true; };
  EXPECT_THAT([&] { Choose(run, settings, {.stop = stop}); }, Fails(Error::Kind::kSimulation, "call-stopped"));
}

TEST(Api, FitsThatWereStoppedAreReadBack) {
  Study study = SinesOfASofterCar();
  study.evaluations = 100'000'000;
  const TemporaryFolder folder;
  FitProgress last;
  FitOptions options{.seed = 7};
  options.progress = [&](const FitProgress& progress) { last = progress; };
  options.stop = [&] { return last.evaluations > 20; };
  const Result result = Fit(study, folder.path() / "run", options);
  EXPECT_EQ(result.termination, "interrupted");
  EXPECT_FALSE(result.explains_data);
  EXPECT_EQ(ReadResult(folder.path() / "run").cost, result.cost);
  EXPECT_THAT(TextOf(folder.path() / "run/result.json"), HasSubstr("\"seed\": 7"));
}

}  // namespace
}  // namespace fourpost::api::api_test
