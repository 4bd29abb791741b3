#include "analysis/files/csv_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/csv.h"
#include "analysis/files/findings.h"
#include "tests/findings.h"

namespace fourpost::csv_start_test {
namespace {

using ::testing::ElementsAre;

CsvTable Parse(std::string_view text) {
  Diagnostics diagnostics;
  std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, CsvHeader::kNamesAndUnits);
  if (!table) throw std::runtime_error(diagnostics.Format());
  return *table;
}

TEST(CsvStart, IsBelowLinesOfOtherKinds) {
  const CsvTable table =
      Parse("Logger 7\nRate: 500 Hz\nOperator;Max\n\ntime;F [kN];z\ns;kN;mm\n0;1,5;2\n1;2,5;3\n2;3,5;4\n");
  EXPECT_THAT(table.names(), ElementsAre("time", "F [kN]", "z"));
  EXPECT_THAT(table.units(), ElementsAre("s", "kN", "mm"));
  EXPECT_EQ(table.names_line(), 5);
  EXPECT_EQ(table.line(0), 7);
  EXPECT_EQ(table.Number(0, 1), 1.5);
}

TEST(CsvStart, MayHoldLinesWithAsManyFields) {
  const CsvTable table = Parse("Rate,500\nChannels,2\ntime [s],F [N]\n0,1\n1,2\n2,3\n");
  EXPECT_THAT(table.names(), ElementsAre("time", "F"));
  EXPECT_EQ(table.rows(), 3);
}

// As many fields as there are columns, some of them empty or a dash, and names without units.
TEST(CsvStart, MayHoldFieldsWithoutAValue) {
  for (const char* above : {"Date:\n", "Operator;\nDate;\n", "Date;;\n\n", "Description;-\n", "Stroke;mm\n\n", "Name;Miller\n"}) {
    const CsvTable table = Parse(std::string(above) + "time;F\n0;1,5\n1;2,5\n2;3,5\n");
    EXPECT_THAT(table.names(), ElementsAre("time", "F")) << above;
    EXPECT_EQ(table.rows(), 3);
  }
}

// Units that are not known are no names.
TEST(CsvStart, HasUnitsThatAreNotKnownBelowNames) {
  const CsvTable table = Parse("Bench 7\ntime;counts\nsec.;U\n0;1,5\n1;2,5\n2;3,5\n");
  EXPECT_THAT(table.names(), ElementsAre("time", "counts"));
  EXPECT_THAT(table.units(), ElementsAre("sec.", "U"));
}

// In a column of comments, which rows need not have.
TEST(CsvStart, IsAboveRowsOfWhichSomeHaveAComment) {
  for (const char* rows : {"0,1,warm-up\n1,2,\n2,3,\n", "0,1,\n1,2,\n2,3,cold\n", "0,1,warm-up\n1,2\n2,3\n"}) {
    const CsvTable table = Parse(std::string("Bench 7\nShock: FX-2, front\ntime [s],F [N],Comment\n") + rows);
    EXPECT_THAT(table.names(), ElementsAre("time", "F", "Comment")) << rows;
    EXPECT_EQ(table.names_line(), 3);
    EXPECT_EQ(table.rows(), 3);
  }
}

TEST(CsvStart, IsTheFirstLineOfAPlainTable) {
  EXPECT_FALSE(StartBelowLines("time,F\n0,1\n1,2\n2,3\n"));
  EXPECT_FALSE(StartBelowLines("time,F\ns,N\n0,1\n1,2\n2,3\n"));
  EXPECT_FALSE(StartBelowLines("quantity,value\nmass,1\nlength,2\nwidth,3\n"));
}

TEST(CsvWithoutNames, CallsColumnsByNumber) {
  for (const char* text : {"0.5,1.5,2\n1,2.5,3\n1.5,3.5,4\n", "0,5;1,5;2;\n1;2,5;3;\n1,5;3,5;4;\n",
                           "# by hand, 2025\n# 3 columns\n0.5\t1.5\t2\n1\t2.5\t3\n1.5\t3.5\t4\n"}) {
    Diagnostics diagnostics;
    const auto table = ParseCsv(text, "t.csv", diagnostics, CsvHeader::kNamesAndUnits);
    ASSERT_TRUE(table) << text << diagnostics.Format();
    EXPECT_FALSE(table->has_names());
    EXPECT_THAT(table->names(), ElementsAre("column1", "column2", "column3"));
    EXPECT_THAT(table->units(), ElementsAre("", "", ""));
    ASSERT_EQ(table->rows(), 3U);
    EXPECT_EQ(table->Number(0, 1), 1.5);
    EXPECT_THAT(diagnostics, ReportsOnly(kCsvWithoutNames, table->line(0), {"column3"}));
  }
}

TEST(CsvWithoutNames, MayHoldTexts) {
  Diagnostics diagnostics;
  const auto table = ParseCsv("0.5,5e-3,a,2\n0.5,5e-3,b,3\n1,5e-3,a,2\n", "t.csv", diagnostics);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows(), 3U);
  EXPECT_EQ(table->Text(1, 2), "b");
}

// Numbers that are names: columns that are counted, and frequencies over a row of units or behind a text.
TEST(CsvWithoutNames, IsNoTableWithNumbersAsNames) {
  for (const char* text : {"0,1,2\n0.5,1.5,2\n1,2.5,3\n", "1,2\n0.5,1.5\n1,2.5\n1.5,3\n",
                           "10,20\nmm,N\n0.5,1.5\n1,2.5\n", "click,0,5\nsoft,1.5,2\nhard,2.5,3\nnew,3,4\n"}) {
    Diagnostics diagnostics;
    const auto table = ParseCsv(text, "t.csv", diagnostics);
    ASSERT_TRUE(table) << text;
    EXPECT_TRUE(table->has_names()) << text;
    EXPECT_TRUE(diagnostics.items().empty());
  }
}

TEST(CsvInTheWild, MayMarkItsNamesAsAComment) {
  EXPECT_THAT(Parse("# time [s],F [N]\n0,1\n1,2\n").names(), ElementsAre("time", "F"));
}

TEST(CsvInTheWild, MayEndLinesWithSeparatorsAndHoldEmptyColumns) {
  const CsvTable table = Parse("time,,F,,\ns,,N,,\n0,,1,,\n1,,2,\n2,,3\n");
  EXPECT_THAT(table.names(), ElementsAre("time", "F"));
  EXPECT_THAT(table.units(), ElementsAre("s", "N"));
  EXPECT_EQ(table.Number(2, 1), 3);
}

TEST(CsvInTheWild, ColumnWithoutANameMayNotHoldAnything) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseCsv("time,,F\n0,,1\n1,5,2\n", "t.csv", diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kCsvColumnNameless, 1, {"2"}));
}

TEST(CsvInTheWild, MayNameCommentsThatRowsDoNotHave) {
  const CsvTable table = Parse("time\tF\tComment\ns\tN\t\n0\t1\n1\t2\tbump\n2\t3\n");
  EXPECT_EQ(table.rows(), 3);
  EXPECT_EQ(table.Text(1, 2), "bump");
  EXPECT_EQ(table.Text(2, 2), "");
}

TEST(CsvInTheWild, JsonIsRefusedByName) {
  for (const char* text : {"{\"time\": [0, 1]}", "[\n {\"t\": 0},\n {\"t\": 1}\n]", "[0, 1, 2]"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(ParseCsv(text, "t.csv", diagnostics)) << text;
    EXPECT_THAT(diagnostics, ReportsOnly(kCsvJson, 0));
  }
}

}  // namespace
}  // namespace fourpost::csv_start_test
