#include "analysis/measured_response/measured_response.h"

#include <gmock/gmock.h>

#include "analysis/files/csv_writer.h"
#include "analysis/files/frequency_response_file.h"
#include "analysis/measured_response/dwell_groups.h"
#include "analysis/measured_response/findings.h"
#include "analysis/measured_response/measured_response_files.h"
#include "analysis/signals/low_pass.h"
#include "tests/analysis/frequency_response/known_system.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::measured_response_test {
namespace {

using testing::ElementsAre;

constexpr double kRate = 200;

/// A recording of columns, with units, at kRate.
std::string Csv(const std::vector<std::string>& names, const std::vector<std::string>& units,
                const std::vector<std::vector<double>>& columns) {
  std::vector<std::string> all = {"time"};
  all.insert(all.end(), names.begin(), names.end());
  CsvWriter csv(all);
  csv.Add("s");
  for (const std::string& unit : units) csv.Add(unit);
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    csv.Add(static_cast<double>(k) / kRate);
    for (const std::vector<double>& column : columns) csv.Add(column[k]);
  }
  return csv.text();
}

std::vector<double> Times(double factor, std::vector<double> signal) {
  for (double& sample : signal) sample *= factor;
  return signal;
}

std::optional<MeasuredResponses> Measure(const std::string& text, Diagnostics& diagnostics,
                                         ResponseRequest request = {}) {
  const TemporaryFolder folder;
  request.files = {folder.Write("run.csv", text)};
  return MeasureResponses(request, diagnostics);
}

const std::vector<double> kFrequencies = {1, 2, 4, 8};

/// In mm and g, as rigs write.
std::string SteppedCsv(double rear) {
  const std::vector<double> post = Times(1e3, SteppedSine(kFrequencies, 20, kRate));
  return Csv({"post_front", "post_rear", "s_front", "a_body", "oil"}, {"mm", "mm", "mm", "g", "V"},
             {post, Times(rear, post), Times(0.5, post), Times(0.01, post), post});
}

TEST(MeasuredResponse, OfASteppedSineIsInSiByReference) {
  Diagnostics diagnostics;
  const auto measured = Measure(SteppedCsv(-1), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  EXPECT_EQ(measured->kind, ExcitationKind::kStepped);
  EXPECT_EQ(measured->dwells, 4);
  EXPECT_TRUE(measured->has_means);
  EXPECT_TRUE(measured->without_rest.empty());
  EXPECT_THAT(measured->left_out, ElementsAre("oil"));
  ASSERT_EQ(measured->responses.size(), 1U);
  const MeasuredResponse& pitch = measured->responses.front();
  EXPECT_EQ(pitch.name, "pitch");
  EXPECT_EQ(pitch.shares.share, (std::vector<double>{1, -1}));
  const ChannelResponse* strut = pitch.response.Find("s_front");
  const ChannelResponse* body = pitch.response.Find("a_body");
  ASSERT_TRUE(strut && body);
  for (std::size_t i = 0; i < 4; ++i) {
    const double w = 2 * std::numbers::pi * kFrequencies[i];
    EXPECT_NEAR(pitch.response.frequency_Hz[i], kFrequencies[i], 1e-6);
    EXPECT_NEAR(pitch.response.amplitude_m[i], RigAmplitude(kFrequencies[i]), 1e-6);
    EXPECT_NEAR(strut->response[i].real(), 0.5, 1e-6);
    // Per acceleration of the post, which is -w^2 times its displacement.
    EXPECT_NEAR(body->response[i].real(), -0.01 * 1e3 * 9.80665 / (w * w), 1e-6);
  }
}

TEST(MeasuredResponse, IsReadBackAsARecording) {
  Diagnostics diagnostics;
  const auto measured = Measure(SteppedCsv(1), diagnostics);
  ASSERT_TRUE(measured);
  const FrequencyResponse& made = measured->responses.front().response;
  const TemporaryFolder folder;
  const auto read = ReadFrequencyResponse(folder.Write("heave.csv", RecordingCsv(made)), diagnostics);
  ASSERT_TRUE(read) << diagnostics.Format();
  ASSERT_EQ(read->channels.size(), 2U);
  // Written at ten digits.
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(std::abs(read->channels[1].response[i] / made.channels[1].response[i] - 1.0), 1e-9);
  EXPECT_NE(StudySection(*measured).find("{file: heave.csv, posts: heave}"), std::string::npos);
}

TEST(MeasuredResponse, KeepsAmplitudesApartAndJoinsRepeats) {
  std::vector<double> post = SteppedSine(kFrequencies, 20, kRate);
  const std::vector<double> once = post;
  for (const double factor : {1.0, 0.5}) {
    const std::vector<double> more = Times(factor, once);
    post.insert(post.end(), more.begin(), more.end());
  }
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  ASSERT_EQ(measured->responses.size(), 2U);
  EXPECT_EQ(measured->responses[0].name, "heave");
  EXPECT_THAT(measured->responses[0].repeats, ElementsAre(2, 2, 2, 2));
  EXPECT_EQ(measured->responses[1].name, "heave_2");
  EXPECT_THAT(measured->responses[1].repeats, ElementsAre(1, 1, 1, 1));
}

TEST(MeasuredResponse, HasDeviationsOfMeansThatItsFileKeeps) {
  const std::vector<double> post = SteppedSine(kFrequencies, 20, kRate);
  std::vector<double> channel;
  for (const double z : post) channel.push_back(2 * z + 5 * z * z);
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Noisy(channel, 0.01, 0, 7)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  const FrequencyResponse& response = measured->responses.front().response;
  ASSERT_EQ(response.channels[0].mean_sd.size(), 4U);
  for (const double sd : response.channels[0].mean_sd) EXPECT_GT(sd, 0);
  const TemporaryFolder folder;
  const auto read = ReadFrequencyResponse(folder.Write("heave.csv", RecordingCsv(response)), diagnostics);
  ASSERT_TRUE(read) << diagnostics.Format();
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(read->channels[0].mean_sd[i] / response.channels[0].mean_sd[i], 1, 1e-5);
}

// Of two files the one that does not begin at rest has no means; that of the other is not lost.
TEST(MeasuredResponse, HasMeansOfFilesThatBeginAtRest) {
  const std::vector<double> post = SteppedSine(kFrequencies, 20, kRate);
  const std::vector<double> late(post.begin() + static_cast<std::ptrdiff_t>(2.1 * kRate), post.end());
  const auto text = [](const std::vector<double>& heights) {
    std::vector<double> channel;
    for (const double z : heights) channel.push_back(2 * z + 5 * z * z);
    return Csv({"post_FL", "s"}, {"m", "m"}, {heights, Noisy(channel, 0.001, 0, 7)});
  };
  const TemporaryFolder folder;
  const std::filesystem::path with = folder.Write("with.csv", text(post));
  const std::filesystem::path without = folder.Write("without.csv", text(late));
  Diagnostics diagnostics;
  const auto both = MeasureResponses({.files = {with, without}}, diagnostics);
  ASSERT_TRUE(both) << diagnostics.Format();
  EXPECT_THAT(both->responses.front().repeats, ElementsAre(2, 2, 2, 2));
  ASSERT_EQ(both->responses.front().response.channels[0].mean.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double mean = 2.5 * std::pow(RigAmplitude(kFrequencies[i]), 2);
    EXPECT_NEAR(both->responses.front().response.channels[0].mean[i], mean, 0.05 * mean + 1e-6);
  }
  ASSERT_EQ(both->without_rest.size(), 1U);
  EXPECT_THAT(both->without_rest[0], testing::ContainsRegex("without.csv does not begin at rest: .* more than 0.06"));
  const auto alone = MeasureResponses({.files = {without}}, diagnostics);
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->responses.front().response.channels[0].mean.empty());
  EXPECT_NE(MeasuredText(*alone).find("mean offsets not known"), std::string::npos);
}

TEST(MeasuredResponse, UndoesTheFilterOfTheRig) {
  std::vector<double> post = SteppedSine(kFrequencies, 20, kRate);
  std::vector<double> square;
  for (const double z : post) square.push_back(z + 20 * z * z);
  const LowPass filter(4, 10, kRate);
  filter.Apply(post);
  filter.Apply(square);
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, square}), diagnostics,
                                {.filter = AcquisitionFilter{.order = 4, .cutoff_Hz = 10}});
  ASSERT_TRUE(measured) << diagnostics.Format();
  const FrequencyResponse& response = measured->responses.front().response;
  for (std::size_t i = 0; i < 4; ++i) {
    const double amplitude = RigAmplitude(kFrequencies[i]);
    EXPECT_NEAR(response.amplitude_m[i] / amplitude, 1, 1e-3);
    EXPECT_NEAR(response.channels[0].second_harmonic[i] / (10 * amplitude * amplitude), 1, 5e-3) << kFrequencies[i];
  }
}

TEST(MeasuredResponse, OfARandomMotionSaysThatTheVehicleIsNotLinear) {
  const std::vector<double> post = RandomMotion(120, kRate, 1);
  const double size = DeviationOf(post);
  std::vector<double> cubic;
  for (const double z : post) cubic.push_back(z + 0.3 * z * z * z / (size * size));
  Diagnostics linear;
  EXPECT_TRUE(Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), linear));
  EXPECT_TRUE(linear.items().empty()) << linear.Format();
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, cubic}), diagnostics);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->kind, ExcitationKind::kRandom);
  EXPECT_THAT(diagnostics, Reports(kResponseRandomNonlinear)) << diagnostics.Format();
}

TEST(MeasuredResponse, OfASteppedSineStatesItsHarmonics) {
  const std::vector<double> post = SteppedSine(kFrequencies, 20, kRate);
  std::vector<double> square;
  for (const double z : post) square.push_back(z + 20 * z * z);
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, square}), diagnostics);
  ASSERT_TRUE(measured);
  // Every car has some: no reason for a warning.
  EXPECT_TRUE(diagnostics.items().empty()) << diagnostics.Format();
  // 20 z^2 has a second harmonic of 10 amplitude^2, the most at the largest.
  EXPECT_NEAR(measured->responses[0].channels[0].distortion, 10 * RigAmplitude(1), 1e-3);
  EXPECT_NEAR(measured->responses[0].channels[0].distortion_Hz, 1, 1e-6);
}

/// Six cycles at 12 Hz behind other dwells, and the answer of a body whose own 1 Hz takes longer to fade.
std::string WithAShortDwell(std::vector<double> post) {
  for (int k = 0; k < 100; ++k) post.push_back(RigAmplitude(12) * std::sin(2 * std::numbers::pi * 12 / kRate * k));
  return Csv({"post_FL", "s"}, {"m", "m"}, {post, KnownSystem(1, 0.1, kRate).Answer(post)});
}

TEST(MeasuredResponse, NamesDwellsThatAreTooShort) {
  const std::string text = WithAShortDwell(SteppedSine({4, 6, 8}, 20, kRate));
  Diagnostics diagnostics;
  const auto measured = Measure(text, diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  EXPECT_EQ(measured->dwells, 3);
  ASSERT_EQ(measured->missed.size(), 1U);
  EXPECT_THAT(measured->missed[0],
              testing::ContainsRegex("the dwell at 1[12][.][0-9] Hz from .* for 10 cycles, 0[.]8"));
  const auto stated = Measure(text, diagnostics, {.kind = ExcitationKind::kStepped, .frequencies_Hz = {4, 6, 8, 12}});
  ASSERT_TRUE(stated);
  EXPECT_EQ(stated->dwells, 3);
  EXPECT_EQ(stated->missed.size(), 1U);
  EXPECT_THAT(diagnostics, Reports(kResponseStatedMissing, {"1 of 4", "12.0 Hz", "10 cycles", "0.83 s"}));
}

// Two tones at once between dwells: half a second is many of their cycles.
TEST(MeasuredResponse, NamesMotionsWithoutADwellByTheirCycles) {
  std::vector<double> post = SteppedSine({15, 18}, 20, kRate);
  const std::size_t begin = post.size();
  for (double k = 0; k < 0.5 * kRate; ++k)
    post.push_back(RigAmplitude(20) * (std::sin(2 * std::numbers::pi * 20 / kRate * k) +
                                       0.7 * std::sin(2 * std::numbers::pi * 27 / kRate * k)));
  const std::vector<double> more = SteppedSine({22}, 20, kRate);
  post.insert(post.end(), more.begin() + static_cast<std::ptrdiff_t>(2 * kRate), more.end());
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  EXPECT_EQ(measured->dwells, 3);
  ASSERT_EQ(measured->missed.size(), 1U);
  EXPECT_THAT(measured->missed[0], testing::HasSubstr("no dwell was found from 10"));
  EXPECT_THAT(measured->missed[0], testing::HasSubstr("or state the frequencies"));
  EXPECT_EQ(begin, static_cast<std::size_t>(10 * kRate));
  const auto stated = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics,
                              {.kind = ExcitationKind::kStepped, .frequencies_Hz = {15, 18, 22}});
  ASSERT_TRUE(stated);
  ASSERT_EQ(stated->missed.size(), 1U);
  EXPECT_THAT(stated->missed[0], testing::Not(testing::HasSubstr("state the frequencies")));
}

// To another height within three seconds, and to rest: no dwell was missed there.
TEST(MeasuredResponse, TakesNoRampForAMotionWithoutDwell) {
  std::vector<double> post = SteppedSine({4, 8}, 20, kRate);
  const double height = 2 * RigAmplitude(4);
  for (double k = 0; k < 3 * kRate; ++k) post.push_back(height * k / (3 * kRate));
  for (const double sample : SteppedSine({12}, 20, kRate)) post.push_back(height + sample);
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  EXPECT_EQ(measured->dwells, 3);
  EXPECT_THAT(measured->missed, testing::IsEmpty());
}

/// Dwells of 15 cycles that fade in and out over three, and pauses at rest. `swept`: the second sweeps up to three times
/// its frequency.
std::vector<double> DwellsAndPauses(double pause_s, bool swept) {
  constexpr double kCycles = 15;
  constexpr double kFade = 3;
  std::vector<double> post(static_cast<std::size_t>(2 * kRate), 0.0);
  for (const double frequency : {1.0, 1.5, 3.0, 6.0}) {
    double phase = 0;
    while (phase < kCycles) {
      post.push_back(5e-3 * std::min({1.0, phase / kFade, (kCycles - phase) / kFade}) *
                     std::sin(2 * std::numbers::pi * phase));
      phase += frequency / kRate * (swept && frequency == 1.5 ? 1 + 2 * phase / kCycles : 1);
    }
    post.insert(post.end(), static_cast<std::size_t>(pause_s * kRate), 0.0);
  }
  return post;
}

TEST(MeasuredResponse, TakesNoPauseForAMotionWithoutDwell) {
  for (const double pause_s : {0.0, 0.2, 0.7, 1.0, 3.0, 10.0}) {
    const std::vector<double> post = Noisy(DwellsAndPauses(pause_s, false), 1e-3, 0, 4);
    Diagnostics diagnostics;
    const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics,
                                  {.kind = ExcitationKind::kStepped});
    ASSERT_TRUE(measured) << diagnostics.Format();
    EXPECT_EQ(measured->dwells, 4);
    EXPECT_THAT(measured->missed, testing::IsEmpty()) << pause_s << " s";
  }
}

TEST(MeasuredResponse, NamesMotionsWithoutADwellBetweenPauses) {
  for (const double pause_s : {0.0, 0.2, 1.0, 3.0, 10.0}) {
    const std::vector<double> post = Noisy(DwellsAndPauses(pause_s, true), 1e-3, 0, 4);
    Diagnostics diagnostics;
    const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics,
                                  {.kind = ExcitationKind::kStepped});
    ASSERT_TRUE(measured) << diagnostics.Format();
    EXPECT_EQ(measured->dwells, 3);
    ASSERT_EQ(measured->missed.size(), 1U) << pause_s << " s";
    const auto begin = static_cast<int>(2 + 15 + pause_s);
    EXPECT_THAT(measured->missed[0], testing::HasSubstr("no dwell was found from " + std::to_string(begin)));
  }
}

// As one counts: "1 dwell", "1 frequency".
TEST(MeasuredResponse, OfOneDwellIsInTheSingular) {
  const std::vector<double> post = SteppedSine({4}, 20, kRate);
  Diagnostics diagnostics;
  const auto measured = Measure(Csv({"post_FL", "s"}, {"m", "m"}, {post, Times(2, post)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  const std::string text = MeasuredText(*measured);
  EXPECT_NE(text.find("1 dwell, "), std::string::npos) << text;
  EXPECT_NE(text.find("1 frequency, 4.000 Hz"), std::string::npos) << text;
}

TEST(MeasuredResponse, TakesTheFeedbackOfAPost) {
  const std::vector<double> command = SteppedSine(kFrequencies, 20, kRate);
  std::vector<double> feedback(command.size(), 0.0);
  for (std::size_t k = 2; k < feedback.size(); ++k) feedback[k] = 0.95 * command[k - 2];
  Diagnostics diagnostics;
  const auto measured = Measure(
      Csv({"Zyl_VL_soll", "Zyl_VL_ist", "s"}, {"m", "m", "m"}, {command, feedback, Times(2, feedback)}), diagnostics);
  ASSERT_TRUE(measured) << diagnostics.Format();
  EXPECT_THAT(measured->posts, ElementsAre("FL"));
  EXPECT_THAT(measured->responses.front().repeats, ElementsAre(1, 1, 1, 1));
  ASSERT_EQ(measured->responses.front().response.channels.size(), 1U);
  for (const std::complex<double> response : measured->responses.front().response.channels[0].response)
    EXPECT_LT(std::abs(response - 2.0), 1e-6);
  EXPECT_THAT(measured->preparations, ElementsAre(testing::HasSubstr("'Zyl_VL_ist' is FL")));
  const std::string twice = Csv({"ram FL", "cyl FL", "s"}, {"m", "m", "m"}, {command, feedback, command});
  EXPECT_FALSE(Measure(twice, diagnostics));
  EXPECT_THAT(diagnostics, Reports(kResponsePostTwice, {"'ram FL', 'cyl FL'", "--post 'ram FL=NAME'"}));
}

TEST(MeasuredResponse, SaysWhyThereIsNoDwell) {
  const std::string text = WithAShortDwell({});
  const auto refused = [&](const std::vector<double>& frequencies_Hz) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Measure(text, diagnostics, {.kind = ExcitationKind::kStepped, .frequencies_Hz = frequencies_Hz}));
    return diagnostics;
  };
  EXPECT_THAT(refused({}), Reports(kResponseDwellsShort, {"FL", "10 cycles", "0.8"}));
  EXPECT_THAT(refused({6, 12}), Reports(kResponseDwellsShort, {"FL", "12.0 Hz"}));
  EXPECT_THAT(refused({1, 2}), Reports(kResponseStatedNone, {"FL", "2 stated"}));
}

TEST(MeasuredResponse, RefusesWhatHasNoPostsOrChannels) {
  const std::vector<double> post = SteppedSine({2}, 20, kRate);
  const std::vector<double> random = RandomMotion(30, kRate, 1);
  const std::string unnamed = Csv({"x", "y"}, {"m", "m"}, {post, post});
  const std::string stepped = Csv({"post_FL", "y"}, {"m", "m"}, {post, post});
  const std::string moved = Csv({"post_FL", "y"}, {"m", "m"}, {random, random});
  const auto refused = [&](const std::string& text, ResponseRequest request = {}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Measure(text, diagnostics, std::move(request)));
    return diagnostics;
  };
  EXPECT_THAT(refused(unnamed), Reports(kResponsePostsUnknown));
  EXPECT_THAT(refused(unnamed, {.posts = {{"z", "FL"}}}), Reports(kResponsePostMissing));
  EXPECT_THAT(refused(Csv({"post_FL", "y"}, {"m", "V"}, {post, post})), Reports(kResponseNoChannel));
  EXPECT_THAT(refused(stepped, {.reference = "FR"}), Reports(kResponseReferenceUnknown));
  EXPECT_THAT(refused(Csv({"post_FL", "y"}, {"m", "m"}, {Times(0, post), post})), Reports(kResponsePostsStill));
  EXPECT_THAT(refused(moved, {.kind = ExcitationKind::kStepped}), Reports(kResponseNoDwell));
  EXPECT_THAT(refused(moved, {.kind = ExcitationKind::kMultisine}), Reports(kResponseNoPeriod));
  EXPECT_THAT(refused(moved, {.frequencies_Hz = {0.01}}), Reports(kResponseTooShort));
  EXPECT_THAT(refused(Csv({"post_FL", "post_FR", "y"}, {"m", "m", "m"}, {random, RandomMotion(30, kRate, 2), random})),
              Reports(kResponsePostsApart));
}

}  // namespace
}  // namespace fourpost::measured_response_test
