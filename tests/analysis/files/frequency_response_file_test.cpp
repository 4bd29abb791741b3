#include "analysis/files/frequency_response_file.h"

#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "tests/analysis/faults_of.h"
#include "tests/analysis/files/mat_writer.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::frequency_response_file_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kRadian = std::numbers::pi / 180;

const char kGood[] =
    "frequency_Hz,post_amplitude_m,channel,gain,phase_deg,gain_sd,phase_sd_deg,mean,second_harmonic\n"
    "0.5,0.012,a_cg,1.02,-90,0.01,0.2,,4e-6\n"
    "0.5,0.012,s_FL,0.11,0,0.002,1.5,0.003,1e-5\n"
    "0.5,0.012,F_FL,1200,180,5,0.5,,\n"
    "3.2,0.007,a_cg,1.34,-95,0.02,0.3,,6e-6\n"
    "3.2,0.007,s_FL,0.45,10,0.003,1.6,0.004,2e-5\n"
    "3.2,0.007,F_FL,9100,170,6,0.6,,\n";

const char kGoodWithUnits[] =
    "frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg,gain_sd,mean\n"
    "0.5,0.012,body,cm/s^2,1.5,0,0.25,50\n"
    "0.5,0.012,strut,mm,125,0,2,3\n"
    "0.5,0.012,tyre,kN,2.5,0,0.5,7\n";

FrequencyResponse ReadGood(const std::string& text) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto response = ReadFrequencyResponse(folder.Write("frf.csv", text), diagnostics);
  if (!response) throw std::runtime_error(diagnostics.Format());
  EXPECT_EQ(diagnostics.Format(), "");
  return *response;
}

Diagnostics Faults(const std::string& text) {
  return FaultsOf("frf.csv", text, [](const std::filesystem::path& file, Diagnostics& diagnostics) {
    return ReadFrequencyResponse(file, diagnostics);
  });
}

TEST(FrequencyResponseFile, HasItsFrequenciesAmplitudesAndChannels) {
  const FrequencyResponse response = ReadGood(kGood);
  EXPECT_THAT(response.frequency_Hz, ElementsAre(0.5, 3.2));
  EXPECT_THAT(response.amplitude_m, ElementsAre(0.012, 0.007));
  ASSERT_EQ(response.channels.size(), 3);
  EXPECT_EQ(response.channels[0].name, "a_cg");
  EXPECT_EQ(response.channels[1].name, "s_FL");
  EXPECT_EQ(response.channels[2].name, "F_FL");
}

TEST(FrequencyResponseFile, ResponseIsGainAtPhase) {
  const FrequencyResponse response = ReadGood(kGood);
  const std::complex<double> acceleration = response.channels[0].response[0];
  EXPECT_DOUBLE_EQ(acceleration.imag(), -1.02);
  // cos(90 deg) is zero but for the rounding of pi.
  EXPECT_NEAR(acceleration.real(), 0, 1e-16);
  EXPECT_DOUBLE_EQ(std::arg(response.channels[1].response[1]), 10 * kRadian);
  EXPECT_DOUBLE_EQ(response.channels[2].response[0].real(), -1200);
}

TEST(FrequencyResponseFile, HasDeviationsMeansAndSecondHarmonics) {
  const FrequencyResponse response = ReadGood(kGood);
  EXPECT_THAT(response.channels[1].gain_sd, ElementsAre(0.002, 0.003));
  EXPECT_THAT(response.channels[1].phase_sd_rad, ElementsAre(1.5 * kRadian, 1.6 * kRadian));
  EXPECT_THAT(response.channels[1].mean, ElementsAre(0.003, 0.004));
  EXPECT_THAT(response.channels[1].second_harmonic, ElementsAre(1e-5, 2e-5));
}

TEST(FrequencyResponseFile, IsEmptyWhereAChannelHasOnlyBlanks) {
  const FrequencyResponse response = ReadGood(kGood);
  EXPECT_THAT(response.channels[0].mean, IsEmpty());
  EXPECT_THAT(response.channels[0].second_harmonic, ElementsAre(4e-6, 6e-6));
  EXPECT_THAT(response.channels[2].second_harmonic, IsEmpty());
}

TEST(FrequencyResponseFile, TakesNaNForABlank) {
  const FrequencyResponse response =
      ReadGood(Replace(Replace(kGood, "5,0.5,,", "5,0.5,NaN,nan"), "6,0.6,,", "6,0.6,NaN,nan"));
  EXPECT_THAT(response.channels[2].mean, IsEmpty());
  EXPECT_THAT(response.channels[2].second_harmonic, IsEmpty());
}

TEST(FrequencyResponseFile, NeedsNoOptionalColumn) {
  const FrequencyResponse response =
      ReadGood("channel,gain,phase_deg,frequency_Hz,post_amplitude_m\na_cg,1,0,0.5,0.012\n");
  EXPECT_THAT(response.channels[0].gain_sd, IsEmpty());
  EXPECT_THAT(response.channels[0].phase_sd_rad, IsEmpty());
  EXPECT_THAT(response.channels[0].mean, IsEmpty());
}

TEST(FrequencyResponseFile, MayBeInTheOrderOfItsChannels) {
  const FrequencyResponse response = ReadGood(
      "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n"
      "1,0.012,a_cg,1,0\n2,0.01,a_cg,2,0\n1,0.012,s_FL,3,0\n2,0.01,s_FL,4,0\n");
  EXPECT_THAT(response.frequency_Hz, ElementsAre(1, 2));
  EXPECT_THAT(response.channels[1].response, ElementsAre(3, 4));
}

TEST(FrequencyResponseFile, TellsUnitsFromNames) {
  const FrequencyResponse response = ReadGood(kGood);
  EXPECT_EQ(response.channels[0].unit, "m/s^2");
  EXPECT_EQ(response.channels[1].unit, "m");
  EXPECT_EQ(response.channels[2].unit, "N");
}

TEST(FrequencyResponseFile, ConvertsItsUnitsToSi) {
  const FrequencyResponse response = ReadGood(kGoodWithUnits);
  EXPECT_EQ(response.channels[1].unit, "m");
  EXPECT_THAT(response.channels[1].response, ElementsAre(0.125));
  EXPECT_THAT(response.channels[1].gain_sd, ElementsAre(0.002));
  EXPECT_THAT(response.channels[1].mean, ElementsAre(0.003));
  EXPECT_EQ(response.channels[2].unit, "N");
  EXPECT_THAT(response.channels[2].response, ElementsAre(2500));
}

TEST(FrequencyResponseFile, AccelerationsAreRelativeWhateverTheirUnit) {
  const FrequencyResponse response = ReadGood(kGoodWithUnits);
  EXPECT_EQ(response.channels[0].unit, "m/s^2");
  EXPECT_THAT(response.channels[0].response, ElementsAre(1.5));
  EXPECT_THAT(response.channels[0].gain_sd, ElementsAre(0.25));
  EXPECT_THAT(response.channels[0].mean, ElementsAre(0.5));
}

/// One row of a gyro.
std::string Gyro(const std::string& unit) {
  return "frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg,gain_sd,mean,second_harmonic\n"
         "2,0.01,pitch_rate," +
         unit + ",180,90,18,9,3.6\n";
}

TEST(FrequencyResponseFile, AngularVelocitiesAreInRadians) {
  for (const auto& [unit, size] : {std::pair("rad/s", 1.0), std::pair("deg/s", kRadian)}) {
    const ChannelResponse gyro = ReadGood(Gyro(unit)).channels.at(0);
    EXPECT_EQ(gyro.unit, "rad/s");
    EXPECT_DOUBLE_EQ(gyro.response[0].imag(), 180 * size);
    EXPECT_DOUBLE_EQ(gyro.gain_sd[0], 18 * size);
    EXPECT_DOUBLE_EQ(gyro.mean[0], 9 * size);
    EXPECT_DOUBLE_EQ(gyro.second_harmonic[0], 3.6 * size);
  }
}

TEST(FrequencyResponseFile, MayBeAMatFile) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "frf.mat").string();
  {
    MatWriter mat(file, MAT_FT_MAT5);
    mat.Add(MatWriter::Struct("run", {{"frequency_Hz", MatWriter::Column(nullptr, {0.5, 0.5, 0.5})},
                                      {"post_amplitude_m", MatWriter::Column(nullptr, {0.012, 0.012, 0.012})},
                                      {"channel", MatWriter::Cells(nullptr, {"body", "strut", "tyre"})},
                                      {"unit", MatWriter::Cells(nullptr, {"cm/s^2", "mm", "kN"})},
                                      {"gain", MatWriter::Column(nullptr, {1.5, 125, 2.5})},
                                      {"phase_deg", MatWriter::Column(nullptr, {0, 0, 0})},
                                      {"gain_sd", MatWriter::Column(nullptr, {0.25, 2, 0.5})},
                                      {"mean", MatWriter::Column(nullptr, {50, 3, 7})}}));
  }
  Diagnostics diagnostics;
  const auto response = ReadFrequencyResponse(file, diagnostics);
  ASSERT_TRUE(response) << diagnostics.Format();
  const FrequencyResponse same = ReadGood(kGoodWithUnits);
  EXPECT_EQ(response->frequency_Hz, same.frequency_Hz);
  EXPECT_EQ(response->amplitude_m, same.amplitude_m);
  ASSERT_EQ(response->channels.size(), same.channels.size());
  for (std::size_t i = 0; i < same.channels.size(); ++i) {
    EXPECT_EQ(response->channels[i].name, same.channels[i].name);
    EXPECT_EQ(response->channels[i].unit, same.channels[i].unit);
    EXPECT_EQ(response->channels[i].response, same.channels[i].response);
    EXPECT_EQ(response->channels[i].gain_sd, same.channels[i].gain_sd);
    EXPECT_EQ(response->channels[i].mean, same.channels[i].mean);
  }
}

TEST(FrequencyResponseFile, OfMatlabTellsRows) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "frf.mat").string();
  {
    MatWriter mat(file, MAT_FT_MAT5);
    mat.Add(MatWriter::Column("frequency_Hz", {0.5, 1}));
    mat.Add(MatWriter::Column("post_amplitude_m", {0.012, 0.012}));
    mat.Add(MatWriter::Rows("channel", {"s_FL", "s_FL"}));
    mat.Add(MatWriter::Column("gain", {1, -1}));
    mat.Add(MatWriter::Column("phase_deg", {0, 0}));
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadFrequencyResponse(file, diagnostics));
  EXPECT_THAT(diagnostics, Reports(kFieldNotPositive, 0, {"2", "1 Hz", "-1"}));
}

TEST(FrequencyResponseFile, OfTheLandRoverIsRead) {
  for (const char* name : {"bounce_frf.csv", "pitch_frf.csv"}) {
    Diagnostics diagnostics;
    const auto response =
        ReadFrequencyResponse(std::string(FOURPOST_SOURCE_DIR "/studies/landrover110/") + name, diagnostics);
    ASSERT_TRUE(response) << diagnostics.Format();
    EXPECT_EQ(response->frequency_Hz.size(), 64);
    EXPECT_EQ(response->channels.size(), 21);
    EXPECT_EQ(response->Find("s_strut_RR")->mean.size(), 64);
    EXPECT_EQ(response->Find("no_such_channel"), nullptr);
  }
}

TEST(FrequencyResponseFault, MissingColumn) {
  EXPECT_THAT(Faults("frequency_Hz,post_amplitude_m,channel,gain,phase_sd_deg\n1,0.01,a_cg,1,0\n"),
              ReportsOnly(kColumnMissing, 1, {"'phase_deg'"}));
}

TEST(FrequencyResponseFault, UnknownColumn) {
  EXPECT_THAT(Faults(Replace(kGood, "second_harmonic", "second_harmonics")),
              ReportsOnly(kColumnUnknown, 1, {"'second_harmonics'", "'second_harmonic'"}));
}

TEST(FrequencyResponseFault, MissingGain) {
  for (const char* gain : {"", "NaN"})
    EXPECT_THAT(Faults(Replace(kGood, "1.34", gain)), ReportsOnly(kFieldMissing, 5, {"3.2 Hz"}));
}

TEST(FrequencyResponseFault, GainThatIsNotANumber) {
  EXPECT_THAT(Faults(Replace(kGood, "1.34", "1.3.4")), ReportsOnly(kFieldNotANumber, 5, {"'1.3.4'", "3.2 Hz"}));
}

TEST(FrequencyResponseFault, GainNotAboveZero) {
  EXPECT_THAT(Faults(Replace(kGood, "1.34", "0")), ReportsOnly(kFieldNotPositive, 5, {"3.2 Hz", "0"}));
  EXPECT_THAT(Faults(Replace(kGood, "1.34", "-1.34")), ReportsOnly(kFieldNotPositive, 5, {"3.2 Hz", "-1.34"}));
}

TEST(FrequencyResponseFault, MissingPhase) {
  EXPECT_THAT(Faults(Replace(kGood, "-95", "nan")), ReportsOnly(kFieldMissing, 5, {"3.2 Hz"}));
}

TEST(FrequencyResponseFault, PhaseThatIsNotANumber) {
  EXPECT_THAT(Faults(Replace(kGood, "-95", "lag")), ReportsOnly(kFieldNotANumber, 5, {"'lag'", "3.2 Hz"}));
}

TEST(FrequencyResponseFault, NegativeDeviation) {
  EXPECT_THAT(Faults(Replace(kGood, "0.02,", "-0.02,")), ReportsOnly(kFieldNegative, 5, {"3.2 Hz", "-0.02"}));
  EXPECT_THAT(Faults(Replace(kGood, "1.6,", "-1.6,")), ReportsOnly(kFieldNegative, 6, {"3.2 Hz", "-1.6"}));
}

TEST(FrequencyResponseFault, DeviationsOfMeansThatSayNothing) {
  const std::string head = "frequency_Hz,post_amplitude_m,channel,gain,phase_deg,";
  EXPECT_THAT(Faults(head + "mean_sd\n0.5,0.012,a_cg,1.02,-90,0.1\n3.2,0.012,a_cg,1.02,-90,0.1\n"),
              ReportsOnly(kMeanSdWithoutMean, 2, {"a_cg"}));
  // A column of the wrong sign is one fault.
  EXPECT_THAT(Faults(head + "mean,mean_sd\n0.5,0.012,a_cg,1.02,-90,1,-0.1\n3.2,0.012,a_cg,1.02,-90,1,-0.2\n"),
              ReportsOnly(kFieldNegative, 2, {"0.5 Hz", "-0.1"}));
}

TEST(FrequencyResponseFault, NegativeSecondHarmonic) {
  EXPECT_THAT(Faults(Replace(kGood, "6e-6", "-6e-6")), ReportsOnly(kFieldNegative, 5, {"3.2 Hz", "-6e-6"}));
}

TEST(FrequencyResponseFault, OptionalValueThatIsNotANumber) {
  EXPECT_THAT(Faults(Replace(kGood, "0.004", "low")), ReportsOnly(kFieldNotANumber, 6, {"'low'", "3.2 Hz"}));
}

TEST(FrequencyResponseFault, BlankInOnlySomeRows) {
  EXPECT_THAT(Faults(Replace(kGood, "0.004", "")), ReportsOnly(kFieldNotEverywhere, 6, {"3.2 Hz"}));
}

TEST(FrequencyResponseFault, FrequencyNotAboveZero) {
  EXPECT_THAT(Faults(Replace(kGood, "3.2,0.007,a_cg", "0,0.007,a_cg")),
              ReportsOnly(kFieldNotPositive, 5, {"0 Hz", "0"}));
}

TEST(FrequencyResponseFault, FrequenciesThatDoNotIncrease) {
  EXPECT_THAT(Faults("frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n"
                     "1,0.01,a_cg,1,0\n3,0.01,a_cg,1,0\n2,0.01,a_cg,1,0\n4,0.01,a_cg,1,0\n"),
              ReportsOnly(kFrequenciesUnsorted, 4, {"2 Hz", "3 Hz"}));
}

TEST(FrequencyResponseFault, AmplitudeNotAboveZero) {
  EXPECT_THAT(Faults(Replace(kGood, "0.007,a_cg", "-0.007,a_cg")),
              ReportsOnly(kFieldNotPositive, 5, {"3.2 Hz", "-0.007"}));
}

TEST(FrequencyResponseFault, TwoAmplitudesAtOneFrequency) {
  EXPECT_THAT(Faults(Replace(kGood, "0.007,s_FL", "0.008,s_FL")),
              ReportsOnly(kAmplitudesDiffer, 6, {"3.2 Hz", "0.008", "0.007", "5"}));
}

TEST(FrequencyResponseFault, ChannelWithoutName) {
  EXPECT_THAT(Faults(Replace(kGood, "0.007,s_FL", "0.007,")), ReportsOnly(kChannelNameless, 6));
}

TEST(FrequencyResponseFault, ChannelMissingAtAFrequency) {
  EXPECT_THAT(Faults(Replace(kGood, "3.2,0.007,s_FL,0.45,10,0.003,1.6,0.004,2e-5\n", "")),
              ReportsOnly(kChannelsMissing, 5, {"3.2 Hz"}));
}

TEST(FrequencyResponseFault, ChannelTwiceAtOneFrequency) {
  EXPECT_THAT(Faults(std::string(kGood) + "3.2,0.007,a_cg,1.34,-95,0.02,0.3,,6e-6\n"),
              ReportsOnly(kChannelTwice, 8, {"3.2 Hz"}));
}

TEST(FrequencyResponseFault, NameThatDoesNotTellTheUnit) {
  const std::string file =
      "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n1,0.01,engine,1,0\n2,0.01,engine,1,0\n";
  EXPECT_THAT(Faults(file), ReportsOnly(kChannelUnitUnknown, 2, {"'unit'", "2"}));
}

TEST(FrequencyResponseFault, UnknownUnit) {
  EXPECT_THAT(Faults(Replace(kGoodWithUnits, "mm", "inch")), ReportsOnly(kChannelUnit, 3, {"'inch'", "2"}));
}

TEST(FrequencyResponseFault, UnitOfAnotherDimension) {
  // Grams, where the user thinks of gravity.
  EXPECT_THAT(Faults(Replace(kGoodWithUnits, "cm/s^2", "g")), ReportsOnly(kChannelUnit, 2, {"'g'", "2"}));
}

// Not even of the dimension of rad/s: a turn a second is 2 pi of them, and an angle is no rate.
TEST(FrequencyResponseFault, UnitOfNoAngularVelocity) {
  for (const std::string unit : {"Hz", "1/s", "rad", "deg/s^2"})
    EXPECT_THAT(Faults(Gyro(unit)), ReportsOnly(kChannelUnit, 2, {"pitch_rate", "'" + unit + "'"}));
}

TEST(FrequencyResponseFault, UnitThatChanges) {
  EXPECT_THAT(Faults(std::string("frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg\n"
                                 "1,0.01,strut,mm,1,0\n2,0.01,strut,m,1,0\n")),
              ReportsOnly(kChannelUnitsDiffer, 3, {"'m'", "'mm'", "2 Hz", "2"}));
}

TEST(FrequencyResponseFault, AllAreReportedAtOnce) {
  EXPECT_THAT(
      Faults(Replace(Replace(Replace(kGood, "1.02", ""), "0.007,s_FL", "0.008,s_FL"), "9100", "x")),
      AllOf(Reports(kFieldMissing, 2, {"0.5 Hz"}), Reports(kAmplitudesDiffer, 6, {"3.2 Hz", "0.008", "0.007", "5"}),
            Reports(kFieldNotANumber, 7, {"'x'", "3.2 Hz"})));
}

TEST(FrequencyResponseFault, MissingFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "frf.csv";
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadFrequencyResponse(path, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kFileNotThere, 0));
}

TEST(FrequencyResponseFile, TellsOnceOfAResultThatIsNoRecording) {
  EXPECT_THAT(Faults("recording,channel,frequency_Hz,post_amplitude_m,gain_measured,gain_modelled\n"
                     "bounce,a_cg,1,0.01,1,1\nbounce,a_cg,2,0.01,1,1\npitch,a_cg,1,0.01,1,1\n"),
              ReportsOnly(kComparisonAsRecording, 1));
}

TEST(FrequencyResponseFile, ATimeHistoryIsToldWhereItBelongs) {
  const auto sends_it_there = ReportsOnly(kHistoryAsSteppedSine, 1);
  EXPECT_THAT(Faults("time,z_ground,a_body\ns,m,m/s^2\n0,0,0\n0.1,0,1\n"), sends_it_there);
  EXPECT_THAT(Faults("Time [s],z_ground [m]\n0,0\n0.1,0\n"), sends_it_there);
}

}  // namespace
}  // namespace fourpost::frequency_response_file_test
