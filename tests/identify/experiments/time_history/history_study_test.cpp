#include "identify/experiments/time_history/history_study.h"

#include <gmock/gmock.h>

#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/findings.h"
#include "tests/findings.h"

namespace fourpost::history_study_test {
namespace {

constexpr const char* kGood = R"(
- name: sweep
  file: data/sweep.csv
  posts: {ground: z_ground}
  channels: {z_sprung: z_s, F_tyre: {sum: [F_left, F_right]}}
  filter: {order: 4, cutoff: 30 Hz}
  noise: {F_tyre: 20 N}
  process: 0.5 m/s^2
  start: 500 ms
  end: 30 s
)";

std::vector<StudyHistory> Read(const std::string& text, Diagnostics& diagnostics) {
  return ReadHistories(YAML::Load(text), YAML::Node(YAML::NodeType::Undefined), "folder/study.yaml", diagnostics);
}

Diagnostics Fault(const std::string& what, const std::string& with) {
  std::string text = kGood;
  text.replace(text.find(what), what.size(), with);
  Diagnostics diagnostics;
  Read(text, diagnostics);
  EXPECT_EQ(diagnostics.items().size(), 1u) << diagnostics.Format();
  return diagnostics;
}

TEST(HistoryStudy, ReadsEveryKey) {
  Diagnostics diagnostics;
  const std::vector<StudyHistory> histories = Read(kGood, diagnostics);
  ASSERT_EQ(diagnostics.Format(), "");
  ASSERT_EQ(histories.size(), 1u);
  const StudyHistory& history = histories[0];
  EXPECT_EQ(history.name, "sweep");
  EXPECT_EQ(history.file, "folder/data/sweep.csv");
  EXPECT_EQ(history.posts[0].first, "ground");
  EXPECT_EQ(history.channels[1].second.combine, ChannelSource::Combine::kSum);
  EXPECT_THAT(history.channels[1].second.channels, testing::ElementsAre("F_left", "F_right"));
  EXPECT_EQ(history.filter->order, 4);
  EXPECT_EQ(history.filter->cutoff_Hz, 30);
  EXPECT_EQ(history.noise[0].sd, "20 N");
  EXPECT_EQ(history.process_sd, 0.5);
  EXPECT_EQ(history.start_s, 0.5);
  EXPECT_EQ(history.end_s, 30);
}

TEST(HistoryStudy, RefusesWhatIsWrong) {
  EXPECT_THAT(Fault("  file: data/sweep.csv\n", ""), Reports(kKeyMissing, 2, {"'file'"}));
  EXPECT_THAT(Fault("start:", "stard:"), Reports(kKeyUnknown, 9, {"'stard'", "'start'"}));
  EXPECT_THAT(Fault("{ground: z_ground}", "[ground]"), Reports(kChannelsNotMapped, 4, {"'posts' of history 'sweep'"}));
  EXPECT_THAT(Fault("{sum: [F_left, F_right]}", "{product: [F_left]}"), Reports(kKeyUnknown, 5, {"'product'"}));
  EXPECT_THAT(Fault("order: 4", "order: 40"), Reports(kKeyNotInteger, 6, {"'order' of 'filter' of history 'sweep'"}));
  EXPECT_THAT(Fault("30 Hz}", "30}"), Reports(kKeyNotQuantity, 6, {"'cutoff' of 'filter' of history 'sweep'"}));
  EXPECT_THAT(Fault("end: 30 s", "end: 300 ms"), Reports(kHistoryWindowEmpty, 10, {"'sweep'"}));
  EXPECT_THAT(Fault("0.5 m/s^2", "0 m/s^2"), Reports(kKeyNotPositive, 8, {"'process' of history 'sweep'"}));
  EXPECT_THAT(Fault("{F_tyre: 20 N}", "20 N"), Reports(kNoiseNotMapped, 7, {"'sweep'"}));
}

TEST(HistoryStudy, RefusesTwoOfOneName) {
  Diagnostics diagnostics;
  Read(std::string(kGood) + kGood, diagnostics);
  EXPECT_THAT(diagnostics, Reports(kHistoryTwice, 12, {"'sweep'"}));
}

}  // namespace
}  // namespace fourpost::history_study_test
