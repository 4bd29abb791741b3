#include "identify/experiments/four_post/response_chart.h"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "analysis/signals/decibel.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "tests/identify/shipped_study.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost::response_chart_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::complex<double> Phasor(double gain_dB, double phase_deg) {
  return std::polar(GainFromDecibel(gain_dB), RadiansFromDegrees(phase_deg));
}

// With a margin of 6 % the axis goes from 1 to 16 Hz.
const std::vector<double> kFrequency = {1.06, 4, 16 / 1.06};

/// One run of one channel at three frequencies.
struct Example {
  std::vector<MeasuredRun> runs;
  std::vector<FrequencyResponse> modelled;
  std::vector<ChannelMisfit> channels = {{"a_body", 0.52, 3.14}};

  Example(std::vector<std::complex<double>> measured, std::vector<std::complex<double>> model) {
    runs.push_back({.name = "bounce", .excitation = {.frequency_Hz = kFrequency}});
    runs[0].channels.push_back({.sensor = 1, .name = "a_body", .unit = "m/s^2", .response = std::move(measured)});
    modelled.push_back({.channels = {{.name = "other"}, {.name = "a_body", .response = std::move(model)}}});
  }

  std::string Svg() const { return ResponseSvg(runs, modelled, channels, 2, 8); }
};

Example Flat() { return Example({1, 1, 1}, {1, 1, 1}); }

/// The steps of the paths of a colour.
std::vector<std::string> PathsOf(const std::string& svg, const std::string& color) {
  std::vector<std::string> paths;
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  for (auto* panel = document.RootElement()->FirstChildElement("svg"); panel; panel = panel->NextSiblingElement("svg"))
    for (auto* path = panel->FirstChildElement("path"); path; path = path->NextSiblingElement("path"))
      if (path->Attribute("stroke") == color) paths.push_back(path->Attribute("d"));
  return paths;
}

std::vector<std::string> Dots(const std::string& svg) { return PathsOf(svg, "#0072B2"); }
std::vector<std::string> Lines(const std::string& svg) { return PathsOf(svg, "#D55E00"); }

TEST(ResponseChart, PlacesGainAndPhase) {
  const Example example({Phasor(-20, 0), Phasor(0, 95), Phasor(20, -95)},
                        {Phasor(20, 0), Phasor(0, 0), Phasor(-20, 0)});
  // A panel is 188 by 116 px. Gain from -20 to 20 dB, phase from -190 to 190 degrees; 4 Hz is midway from 1 to 16 Hz,
  // 1.06 Hz is 188 px * log(1.06) / log(16) = 4 px from the left.
  EXPECT_THAT(Dots(example.Svg()), ElementsAre("M4 116h0M94 58h0M184 0h0", HasSubstr("M4 58h0M94 29h0")));
  EXPECT_THAT(Lines(example.Svg()), ElementsAre("M4 0L94 58L184 116", "M4 58L94 58L184 58"));
}

TEST(ResponseChart, DrawsAPhaseThatWrapsAtBothEdgesAndNoLineAcross) {
  const Example example({1, 1, 1}, {Phasor(0, 100), Phasor(0, 180), Phasor(0, -100)});
  // From 100 by 180 to 260 degrees, and the same a turn lower: -260, -180, -100.
  EXPECT_EQ(Lines(example.Svg())[1], "M4 27.5L94 3.1L184 -21.4M4 137.4L94 112.9L184 88.5");
}

TEST(ResponseChart, LeavesAGapForAGainOfZero) {
  const Example example({1, 0, 1}, {1, 0, 1});
  EXPECT_EQ(Lines(example.Svg())[0], "M4 58M184 58");
  EXPECT_THAT(example.Svg(), Not(HasSubstr("inf")));
  EXPECT_THAT(example.Svg(), Not(HasSubstr("nan")));
}

TEST(ResponseChart, HasTheFrequencyTicksOfARig) {
  Example example = Flat();
  example.runs[0].excitation.frequency_Hz = {0.5, 4, 30};
  for (const char* tick : {"0.5", "1", "2", "5", "10", "20", "30"})
    EXPECT_THAT(example.Svg(), HasSubstr(">" + std::string(tick) + "</text>"));
}

TEST(ResponseChart, ShadesWhatWasNotFitted) {
  // 2 and 8 Hz are a quarter and three quarters of the way from 1 to 16 Hz.
  EXPECT_THAT(Flat().Svg(), HasSubstr("<rect x=\"0\" y=\"0\" width=\"47\" height=\"116\""));
  EXPECT_THAT(Flat().Svg(), HasSubstr("<rect x=\"141\" y=\"0\" width=\"47\" height=\"116\""));
  EXPECT_THAT(Flat().Svg(), HasSubstr("from 2 to 8 Hz"));
}

TEST(ResponseChart, NamesColumnsAndTheMisfitOfEachChannel) {
  const std::string svg = Flat().Svg();
  EXPECT_THAT(svg, HasSubstr("bounce: gain [dB]"));
  EXPECT_THAT(svg, HasSubstr("bounce: phase [deg]"));
  EXPECT_THAT(svg, HasSubstr(">a_body<"));
  EXPECT_THAT(svg, HasSubstr(">rms 0.5 dB, 3.1 deg<"));
}

TEST(ResponseChart, TellsTheReferenceOfAGainWithAUnit) {
  Example example = Flat();
  example.runs[0].channels[0].unit = "N";
  EXPECT_THAT(example.Svg(), HasSubstr("gain re 1 N/m"));
}

TEST(ResponseChart, LeavesAPanelEmptyWhereARunHasNotTheChannel) {
  Example example = Flat();
  example.channels = {{"F_tyre", 0, 0}};
  EXPECT_THAT(Dots(example.Svg()), ElementsAre());
}

TEST(ResponseChart, TakesASingleFrequency) {
  Example example({1}, {1});
  example.runs[0].excitation.frequency_Hz = {3};
  EXPECT_EQ(Dots(example.Svg())[0], "M94 58h0");
}

TEST(ResponseChart, RefusesNoRun) { EXPECT_THROW(ResponseSvg({}, {}, {}, 1, 2), std::invalid_argument); }

TEST(ResponseChart, OfTheShippedStudyHasARowPerChannelAndIsSmall) {
  const LoadedStudy study = ShippedStudy();
  const CondensedVehicle condensed(study.vehicle);
  const std::vector<MeasuredRun>& runs = Sines(study).runs;
  const std::vector<FrequencyResponse> modelled =
      ModelledResponses(condensed.At(study.vehicle.ParameterValues()), study.vehicle.sensors, runs);
  const std::string svg = ResponseSvg(runs, modelled, ResponseMisfits(runs, modelled), 0.5, 12);
  // 11 channels, each with gain and phase in two recordings.
  EXPECT_EQ(Dots(svg).size(), 44u);
  EXPECT_EQ(Lines(svg).size(), 44u);
  EXPECT_LT(svg.size(), 300000u);
}

}  // namespace
}  // namespace fourpost::response_chart_test
