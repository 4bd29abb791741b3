#include "identify/study_file/channel_source_reader.h"

#include <gmock/gmock.h>

#include "identify/study_file/channel_source_text.h"

namespace fourpost {
namespace {

using testing::HasSubstr;

using Sources = std::vector<std::pair<std::string, ChannelSource>>;

Sources Read(const std::string& text, ChannelKind kind, Diagnostics& diagnostics) {
  return ReadChannelSources(YAML::Load(text), "'channels'", "sensors", kind, "study.yaml", diagnostics);
}

ChannelSource Good(const std::string& text, ChannelKind kind = ChannelKind::kHistory) {
  Diagnostics diagnostics;
  const Sources sources = Read("a: " + text, kind, diagnostics);
  EXPECT_EQ(diagnostics.Format(), "") << text;
  return sources.at(0).second;
}

std::string Fault(const std::string& text, ChannelKind kind = ChannelKind::kHistory) {
  Diagnostics diagnostics;
  Read("a: " + text, kind, diagnostics);
  return diagnostics.Format();
}

TEST(ChannelSourceReader, TakesANameForAChannel) {
  EXPECT_THAT(Good("left").channels, testing::ElementsAre("left"));
  const ChannelSource sum = Good("{sum: [left, right]}");
  EXPECT_EQ(sum.combine, ChannelSource::Combine::kSum);
  EXPECT_THAT(sum.channels, testing::ElementsAre("left", "right"));
}

TEST(ChannelSourceReader, TakesUnitSignScaleAndDelay) {
  const SourceChannel channel = Good("{channel: ch7, unit: mm, sign: -1, scale: 1.5, delay: 2 ms}").channels.at(0);
  EXPECT_EQ(channel.name, "ch7");
  EXPECT_EQ(channel.unit, "mm");
  EXPECT_EQ(channel.factor, -1.5);
  EXPECT_EQ(channel.delay_s, 0.002);
  EXPECT_EQ(Good("{channel: a, delay: -1 ms}").channels.at(0).delay_s, -0.001);
}

TEST(ChannelSourceReader, TakesThemWithinASum) {
  const ChannelSource mean = Good("{mean: [left, {channel: right, sign: -1}]}");
  ASSERT_EQ(mean.channels.size(), 2u);
  EXPECT_EQ(mean.channels[0].factor, 1);
  EXPECT_EQ(mean.channels[1].name, "right");
  EXPECT_EQ(mean.channels[1].factor, -1);
}

TEST(ChannelSourceReader, TakesTheSignOfASumForThatOfAll) {
  const ChannelSource sum = Good("{sum: [left, {channel: right, sign: -1}], sign: -1, scale: 2}");
  EXPECT_EQ(sum.combine, ChannelSource::Combine::kSum);
  ASSERT_EQ(sum.channels.size(), 2u);
  EXPECT_EQ(sum.channels[0].factor, -2);
  EXPECT_EQ(sum.channels[1].factor, 2);
}

TEST(ChannelSourceReader, RefusesWhatIsWrong) {
  for (const char* sign : {"2", "-2", "left", "1 mm"})
    EXPECT_THAT(Fault(std::string("{mean: [b, c], sign: ") + sign + "}"), HasSubstr("'sign' of 'a' must be 1 or -1"));
  EXPECT_THAT(Fault("{mean: [b, c], delay: 2 ms}"), HasSubstr("'delay'"));
  EXPECT_THAT(Fault("{mean: [b, c], sum: [b, c]}"), HasSubstr("either the mean or the sum"));
  EXPECT_THAT(Fault("{channel: b, sign: 0.5}"), HasSubstr("study.yaml:1: error: 'sign' of 'a' must be 1 or -1"));
  EXPECT_THAT(Fault("{channel: b, scale: 0}"), HasSubstr("'scale' of 'a' must be above zero"));
  EXPECT_THAT(Fault("{channel: b, scale: -2}"), HasSubstr("'scale'"));
  EXPECT_THAT(Fault("{channel: b, delay: 2}"), HasSubstr("'delay'"));
  EXPECT_THAT(Fault("{channel: b, unit: furlong}"), HasSubstr("'unit' of 'a' is 'furlong', which is none"));
  EXPECT_THAT(Fault("{channel: b, sgin: 1}"), HasSubstr("did you mean 'sign'?"));
  EXPECT_EQ(Fault("{chanel: b, sgn: -1}"),
            "study.yaml:1: error: unknown key 'chanel' in 'a', did you mean 'channel'?\n"
            "study.yaml:1: error: unknown key 'sgn' in 'a', did you mean 'sign'?");
  EXPECT_EQ(Fault("{maen: [b, c]}"), "study.yaml:1: error: unknown key 'maen' in 'a', did you mean 'mean'?");
  EXPECT_THAT(Fault("{sum: [b, {chanel: c}]}"), HasSubstr("unknown key 'chanel' in 'a', did you mean 'channel'?"));
  EXPECT_THAT(Fault("{sign: -1}"), HasSubstr("'a' must be a measured channel"));
  EXPECT_THAT(Fault("{sum: []}"), HasSubstr("'a' must be a list of channels"));
}

TEST(SourceText, IsWhatTheReaderReads) {
  for (const char* text : {"b", "{channel: b, unit: g, sign: -1, scale: 2.5, delay: -20.2 ms}", "{sum: [b]}",
                           "{mean: [b, {channel: c, sign: -1}]}"})
    EXPECT_EQ(SourceText(Good(text)), text);
}

TEST(ChannelSourceReader, RefusesWhatAnotherKindOfDataTells) {
  EXPECT_THAT(Fault("{channel: b, unit: mm}", ChannelKind::kSteppedSine), HasSubstr("unit"));
  EXPECT_EQ(Good("{channel: b, delay: 1 ms}", ChannelKind::kSteppedSine).channels.at(0).delay_s, 0.001);
  EXPECT_THAT(Fault("{channel: b, delay: 1 ms}", ChannelKind::kLoad), HasSubstr("delay"));
}

}  // namespace
}  // namespace fourpost
