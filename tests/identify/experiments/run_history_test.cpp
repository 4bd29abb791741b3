#include "identify/experiments/run_history.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>

#include "identify/experiments/findings.h"
#include "tests/findings.h"

namespace fourpost::run_history_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(HistoriesJson, PartsRecordingsAndLeavesOutWhatTheyHaveNot) {
  const Json histories = HistoriesJson(
      "recording,time,a_measured,s_measured\n,s,m/s^2,m\nslow,0,1,\nslow,0.5,2,\nfast,0,,3\n", "history.csv");
  ASSERT_EQ(histories.size(), 2u);
  EXPECT_EQ(histories[0]["recording"], "slow");
  EXPECT_EQ(histories[0]["columns"], Json::parse(R"([{"name": "time", "unit": "s", "rows": 2, "first": 0, "step": 0.5},
                              {"name": "a_measured", "unit": "m/s^2", "rows": 2, "first": 1, "step": 1}])"));
  EXPECT_EQ(histories[1]["columns"][1]["name"], "s_measured");
  EXPECT_EQ(histories[1]["rows"], 1);
}

TEST(HistoriesJson, ThinsLongRecordingsAndKeepsTheirExtremes) {
  std::string text = "recording,time,a_measured\n,s,m/s^2\n";
  constexpr int kRows = 200000;
  for (int k = 0; k < kRows; ++k)
    text += "sweep," + std::to_string(k) + "," + (k == 54321 ? "7" : k == 54322 ? "-7" : "0") + "\n";
  const Json sweep = HistoriesJson(text, "history.csv", CsvHeader::kNamesAndUnits, 50000)[0];
  EXPECT_EQ(sweep["rows"], kRows);
  EXPECT_LE(sweep["shown_rows"], 50000);
  EXPECT_EQ(sweep["columns"][0]["rows"], sweep["shown_rows"]);
  const std::vector<TimeTable> tables = ReadHistories(text, "history.csv");
  EXPECT_THAT(RowsToShow({&tables[0].columns[0], &tables[0].columns[1]}, kRows, 50000),
              testing::IsSupersetOf({54321u, 54322u}));
  // 32767 steps are the largest, of either sign.
  EXPECT_DOUBLE_EQ(sweep["columns"][1]["scale"].get<double>() * 32767, 7);
  EXPECT_EQ(HistoriesJson(text, "history.csv")[0]["shown_rows"], kRows);
}

TEST(RowsToShow, AreAsManyAsAreAskedForAtTheMost) {
  // Every row of a stretch that may be shown is another one: extremes lie at random.
  std::mt19937 random(1);
  TableColumn a;
  TableColumn b;
  for (int k = 0; k < 7777; ++k)
    for (TableColumn* column : {&a, &b}) column->values.push_back(static_cast<double>(random()));
  for (const std::size_t most : {5u, 100u, 3000u, 7776u}) {
    const std::size_t shown = RowsToShow({&a, &b}, 7777, most).size();
    EXPECT_LE(shown, most);
    EXPECT_GE(shown, most / 2);
  }
  EXPECT_EQ(RowsToShow({&a, &b}, 7777, 7777).size(), 7777u);
}

TEST(HistoriesJson, TellsWhatAFileLacks) {
  EXPECT_THAT([] { HistoriesJson("time,a\ns,m\n0,1\n", "history.csv"); },
              Refuses(kFitColumnMissing, 1, {"'recording'"}));
}

}  // namespace
}  // namespace fourpost::run_history_test
