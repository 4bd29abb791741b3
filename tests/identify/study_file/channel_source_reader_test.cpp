#include "identify/study_file/channel_source_reader.h"

#include <gmock/gmock.h>

#include "identify/study_file/channel_source_text.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"

namespace fourpost::channel_source_reader_test {
namespace {

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

Diagnostics Faults(const std::string& text, ChannelKind kind = ChannelKind::kHistory) {
  Diagnostics diagnostics;
  Read("a: " + text, kind, diagnostics);
  return diagnostics;
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
    EXPECT_THAT(Faults(std::string("{mean: [b, c], sign: ") + sign + "}"), Reports(kChannelSign, 1, {"'a'"}));
  EXPECT_THAT(Faults("{mean: [b, c], delay: 2 ms}"), Reports(kKeyUnknown, 1, {"'delay'"}));
  EXPECT_THAT(Faults("{mean: [b, c], sum: [b, c]}"), Reports(kChannelMeanAndSum, 1, {"'a'"}));
  EXPECT_THAT(Faults("{channel: b, sign: 0.5}"), Reports(kChannelSign, 1, {"'a'"}));
  EXPECT_EQ(Faults("{channel: b, sign: 0.5}").items().at(0).place.file, "study.yaml");
  EXPECT_THAT(Faults("{channel: b, scale: 0}"), Reports(kChannelScale, 1, {"'a'"}));
  EXPECT_THAT(Faults("{channel: b, scale: -2}"), Reports(kKeyNotNumber, 1, {"'scale'"}));
  EXPECT_THAT(Faults("{channel: b, delay: 2}"), Reports(kKeyNotQuantity, 1, {"'delay'"}));
  EXPECT_THAT(Faults("{channel: b, unit: furlong}"), Reports(kChannelSourceUnit, 1, {"'a'", "'furlong'"}));
  EXPECT_THAT(Faults("{channel: b, sgin: 1}"), Reports(kKeyUnknown, 1, {"'sign'"}));
  const Diagnostics two = Faults("{chanel: b, sgn: -1}");
  EXPECT_THAT(two, Reports(kKeyUnknown, 1, {"'chanel'", "'a'", "'channel'"}));
  EXPECT_THAT(two, Reports(kKeyUnknown, 1, {"'sgn'", "'a'", "'sign'"}));
  EXPECT_EQ(two.items().size(), 2u) << two.Format();
  EXPECT_THAT(Faults("{maen: [b, c]}"), Reports(kKeyUnknown, 1, {"'maen'", "'a'", "'mean'"}));
  EXPECT_EQ(Faults("{maen: [b, c]}").items().size(), 1u);
  EXPECT_THAT(Faults("{sum: [b, {chanel: c}]}"), Reports(kKeyUnknown, 1, {"'chanel'", "'a'", "'channel'"}));
  EXPECT_THAT(Faults("{sign: -1}"), Reports(kChannelNotNamed, 1, {"'a'"}));
  EXPECT_THAT(Faults("{sum: []}"), Reports(kChannelListEmpty, 1, {"'a'"}));
}

TEST(SourceText, IsWhatTheReaderReads) {
  for (const char* text : {"b", "{channel: b, unit: g, sign: -1, scale: 2.5, delay: -20.2 ms}", "{sum: [b]}",
                           "{mean: [b, {channel: c, sign: -1}]}"})
    EXPECT_EQ(SourceText(Good(text)), text);
}

TEST(ChannelSourceReader, RefusesKeysOfAnotherKindOfData) {
  EXPECT_EQ(Good("{channel: b, unit: mm, delay: 1 ms}").channels.at(0).delay_s, 0.001);
  EXPECT_THAT(Faults("{channel: b, delay: 1 ms}", ChannelKind::kLoad), Reports(kKeyUnknown, 1, {"'delay'"}));
  EXPECT_EQ(Good("{channel: b, unit: mm, sign: -1, scale: 2}", ChannelKind::kCurve).channels.at(0).factor, -2);
  for (const char* key : {"offset: 1 mm", "trend: remove", "high_pass: 1 Hz", "delay: 1 ms", "integrate: 1 Hz"})
    EXPECT_THAT(Faults("{channel: b, " + std::string(key) + "}", ChannelKind::kCurve), Reports(kKeyUnknown, 1, {}));
  EXPECT_THAT(Faults("{mean: [b, c]}", ChannelKind::kCurve), Reports(kKeyUnknown, 1, {"'mean'"}));
}

}  // namespace
}  // namespace fourpost::channel_source_reader_test
