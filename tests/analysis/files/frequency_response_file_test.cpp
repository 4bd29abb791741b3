#include "analysis/files/frequency_response_file.h"

#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis/faults_of.h"
#include "tests/analysis/files/mat_writer.h"
#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
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

std::string Faults(const std::string& text) { return FaultsOf("frf.csv", text, ReadFrequencyResponse); }

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
  EXPECT_THAT(diagnostics.Format(),
              HasSubstr("frf.mat: error: row 2: s_FL at 1 Hz: gain -1 must be above zero; correct it"));
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
  EXPECT_EQ(Faults("frequency_Hz,post_amplitude_m,channel,gain,phase_sd_deg\n1,0.01,a_cg,1,0\n"),
            "frf.csv:1: error: column 'phase_deg' is missing; add it");
}

TEST(FrequencyResponseFault, UnknownColumn) {
  EXPECT_EQ(Faults(Replace(kGood, "second_harmonic", "second_harmonics")),
            "frf.csv:1: error: unknown column 'second_harmonics', did you mean 'second_harmonic'?");
}

TEST(FrequencyResponseFault, MissingGain) {
  for (const char* gain : {"", "NaN"})
    EXPECT_EQ(Faults(Replace(kGood, "1.34", gain)),
              "frf.csv:5: error: a_cg at 3.2 Hz: gain is missing (NaN); remove the whole frequency or repeat the "
              "measurement");
}

TEST(FrequencyResponseFault, GainThatIsNotANumber) {
  EXPECT_EQ(Faults(Replace(kGood, "1.34", "1.3.4")),
            "frf.csv:5: error: a_cg at 3.2 Hz: gain '1.3.4' is not a finite number; correct it");
}

TEST(FrequencyResponseFault, GainNotAboveZero) {
  EXPECT_EQ(Faults(Replace(kGood, "1.34", "0")),
            "frf.csv:5: error: a_cg at 3.2 Hz: gain 0 must be above zero; correct it");
  EXPECT_EQ(Faults(Replace(kGood, "1.34", "-1.34")),
            "frf.csv:5: error: a_cg at 3.2 Hz: gain -1.34 must be above zero; correct it");
}

TEST(FrequencyResponseFault, MissingPhase) {
  EXPECT_EQ(Faults(Replace(kGood, "-95", "nan")),
            "frf.csv:5: error: a_cg at 3.2 Hz: phase_deg is missing (NaN); remove the whole frequency or repeat the "
            "measurement");
}

TEST(FrequencyResponseFault, PhaseThatIsNotANumber) {
  EXPECT_EQ(Faults(Replace(kGood, "-95", "lag")),
            "frf.csv:5: error: a_cg at 3.2 Hz: phase_deg 'lag' is not a finite number; correct it");
}

TEST(FrequencyResponseFault, NegativeDeviation) {
  EXPECT_EQ(Faults(Replace(kGood, "0.02,", "-0.02,")),
            "frf.csv:5: error: a_cg at 3.2 Hz: gain_sd -0.02 must not be negative; correct it");
  EXPECT_EQ(Faults(Replace(kGood, "1.6,", "-1.6,")),
            "frf.csv:6: error: s_FL at 3.2 Hz: phase_sd_deg -1.6 must not be negative; correct it");
}

TEST(FrequencyResponseFault, NegativeSecondHarmonic) {
  EXPECT_EQ(Faults(Replace(kGood, "6e-6", "-6e-6")),
            "frf.csv:5: error: a_cg at 3.2 Hz: second_harmonic -6e-6 must not be negative; correct it");
}

TEST(FrequencyResponseFault, OptionalValueThatIsNotANumber) {
  EXPECT_EQ(Faults(Replace(kGood, "0.004", "low")),
            "frf.csv:6: error: s_FL at 3.2 Hz: mean 'low' is not a finite number; correct it");
}

TEST(FrequencyResponseFault, BlankInOnlySomeRows) {
  EXPECT_EQ(Faults(Replace(kGood, "0.004", "")),
            "frf.csv:6: error: s_FL at 3.2 Hz: mean is missing, but is there at other frequencies; fill it in for all "
            "of them or for none");
}

TEST(FrequencyResponseFault, FrequencyNotAboveZero) {
  EXPECT_EQ(Faults(Replace(kGood, "3.2,0.007,a_cg", "0,0.007,a_cg")),
            "frf.csv:5: error: a_cg at 0 Hz: frequency_Hz 0 must be above zero; correct it");
}

TEST(FrequencyResponseFault, FrequenciesThatDoNotIncrease) {
  EXPECT_EQ(Faults("frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n"
                   "1,0.01,a_cg,1,0\n3,0.01,a_cg,1,0\n2,0.01,a_cg,1,0\n4,0.01,a_cg,1,0\n"),
            "frf.csv:4: error: a_cg at 2 Hz: frequencies must increase, but 3 Hz stands above it; sort the rows");
}

TEST(FrequencyResponseFault, AmplitudeNotAboveZero) {
  EXPECT_EQ(Faults(Replace(kGood, "0.007,a_cg", "-0.007,a_cg")),
            "frf.csv:5: error: a_cg at 3.2 Hz: post_amplitude_m -0.007 must be above zero; correct it");
}

TEST(FrequencyResponseFault, TwoAmplitudesAtOneFrequency) {
  EXPECT_EQ(Faults(Replace(kGood, "0.007,s_FL", "0.008,s_FL")),
            "frf.csv:6: error: s_FL at 3.2 Hz: post_amplitude_m is 0.008, but 0.007 in line 5; a frequency has one "
            "amplitude");
}

TEST(FrequencyResponseFault, ChannelWithoutName) {
  EXPECT_EQ(Faults(Replace(kGood, "0.007,s_FL", "0.007,")),
            "frf.csv:6: error: the channel has no name; write one or remove the row");
}

TEST(FrequencyResponseFault, ChannelMissingAtAFrequency) {
  EXPECT_EQ(Faults(Replace(kGood, "3.2,0.007,s_FL,0.45,10,0.003,1.6,0.004,2e-5\n", "")),
            "frf.csv:5: error: at 3.2 Hz there is no s_FL; add what is missing or remove the whole frequency");
}

TEST(FrequencyResponseFault, ChannelTwiceAtOneFrequency) {
  EXPECT_EQ(Faults(std::string(kGood) + "3.2,0.007,a_cg,1.34,-95,0.02,0.3,,6e-6\n"),
            "frf.csv:8: error: a_cg at 3.2 Hz: the channel is there twice; remove one of the two rows");
}

TEST(FrequencyResponseFault, NameThatDoesNotTellTheUnit) {
  const std::string file =
      "frequency_Hz,post_amplitude_m,channel,gain,phase_deg\n1,0.01,engine,1,0\n2,0.01,engine,1,0\n";
  EXPECT_EQ(Faults(file),
            "frf.csv:2: error: the unit of engine is not to be told from its name (a_ for m/s^2, s_ for m, F_ for N); "
            "add a column 'unit'");
}

TEST(FrequencyResponseFault, UnknownUnit) {
  EXPECT_EQ(Faults(Replace(kGoodWithUnits, "mm", "inch")),
            "frf.csv:3: error: strut: the unit 'inch' is not one of a length, a force, an acceleration or an angular "
            "velocity; write one like mm, kN, m/s^2 or deg/s");
}

TEST(FrequencyResponseFault, UnitOfAnotherDimension) {
  // Grams, where the user thinks of gravity.
  EXPECT_EQ(Faults(Replace(kGoodWithUnits, "cm/s^2", "g")),
            "frf.csv:2: error: body: the unit 'g' is not one of a length, a force, an acceleration or an angular "
            "velocity; write one like mm, kN, m/s^2 or deg/s");
}

// Not even of the dimension of rad/s: a turn a second is 2 pi of them, and an angle is no rate.
TEST(FrequencyResponseFault, UnitOfNoAngularVelocity) {
  for (const std::string unit : {"Hz", "1/s", "rad", "deg/s^2"})
    EXPECT_EQ(Faults(Gyro(unit)), "frf.csv:2: error: pitch_rate: the unit '" + unit +
                                      "' is not one of a length, a force, an acceleration or an angular velocity; "
                                      "write one like mm, kN, m/s^2 or deg/s");
}

TEST(FrequencyResponseFault, UnitThatChanges) {
  EXPECT_EQ(Faults(std::string("frequency_Hz,post_amplitude_m,channel,unit,gain,phase_deg\n"
                               "1,0.01,strut,mm,1,0\n2,0.01,strut,m,1,0\n")),
            "frf.csv:3: error: strut at 2 Hz: the unit is 'm', but 'mm' in line 2; a channel has one unit");
}

TEST(FrequencyResponseFault, AllAreReportedAtOnce) {
  EXPECT_EQ(Faults(Replace(Replace(Replace(kGood, "1.02", ""), "0.007,s_FL", "0.008,s_FL"), "9100", "x")),
            "frf.csv:2: error: a_cg at 0.5 Hz: gain is missing (NaN); remove the whole frequency or repeat the "
            "measurement\n"
            "frf.csv:6: error: s_FL at 3.2 Hz: post_amplitude_m is 0.008, but 0.007 in line 5; a frequency has one "
            "amplitude\n"
            "frf.csv:7: error: F_FL at 3.2 Hz: gain 'x' is not a finite number; correct it");
}

TEST(FrequencyResponseFault, UnreadableFile) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "frf.csv";
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadFrequencyResponse(path, diagnostics));
  EXPECT_EQ(diagnostics.Format(), path + ": error: cannot be read: No such file or directory");
}

TEST(FrequencyResponseFile, TellsOnceOfAResultThatIsNoRecording) {
  EXPECT_EQ(Faults("recording,channel,frequency_Hz,post_amplitude_m,gain_measured,gain_modelled\n"
                   "bounce,a_cg,1,0.01,1,1\nbounce,a_cg,2,0.01,1,1\npitch,a_cg,1,0.01,1,1\n"),
            "frf.csv:1: error: is a result, in which measurement and model stand side by side (bounce, pitch): name a "
            "recording itself, as the `recordings` of a study do");
}

TEST(FrequencyResponseFile, ATimeHistoryIsToldWhereItBelongs) {
  const std::string told = "frf.csv:1: error: is a time history, not a stepped sine: list it under 'histories'";
  EXPECT_EQ(Faults("time,z_ground,a_body\ns,m,m/s^2\n0,0,0\n0.1,0,1\n"), told);
  EXPECT_EQ(Faults("Time [s],z_ground [m]\n0,0\n0.1,0\n"), told);
}

}  // namespace
}  // namespace fourpost
