#include "analysis/files/csv_writer.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/files/csv.h"
#include "tests/rounding.h"

namespace fourpost::csv_writer_test {
namespace {

TEST(CsvWriter, EndsARowWhenItIsFull) {
  CsvWriter csv({"channel", "gain"});
  csv.Add("a_cg").Add(1.02).Add("a_sill").Add(-0.5);
  EXPECT_EQ(csv.text(), "channel,gain\na_cg,1.02\na_sill,-0.5\n");
}

TEST(CsvWriter, LeavesAFieldEmptyForNaN) {
  CsvWriter csv({"a", "b"});
  csv.Add(kNan).Add(1.0);
  EXPECT_EQ(csv.text(), "a,b\n,1\n");
}

TEST(CsvWriter, QuotesOnlyWhatItMust) {
  CsvWriter csv({"a"});
  csv.Add("x y").Add("x,y").Add("\"x\"").Add(" x").Add("x\ny");
  EXPECT_EQ(csv.text(), "a\nx y\n\"x,y\"\n\"\"\"x\"\"\"\n\" x\"\n\"x\ny\"\n");
}

TEST(CsvWriter, WritesTextsThatNoSpreadsheetComputes) {
  CsvWriter csv({"=1+1", "number"});
  csv.Add("=HYPERLINK(\"x\")").Add(-1.5).Add("@a").Add("-2.5");
  EXPECT_EQ(csv.text(), "'=1+1,number\n\"'=HYPERLINK(\"\"x\"\")\",-1.5\n'@a,-2.5\n");
  Diagnostics diagnostics;
  const std::optional<CsvTable> table = ParseCsv(csv.text(), "t.csv", diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_EQ(table->names()[0], "=1+1");
  EXPECT_EQ(table->Text(0, 0), "=HYPERLINK(\"x\")");
  EXPECT_EQ(table->Text(1, 0), "@a");
}

TEST(CsvWriter, WritesUtf8) {
  CsvWriter csv({"a"});
  csv.Add("Sto\xDF");
  EXPECT_EQ(csv.text(), "a\nSto\uFFFD\n");
}

TEST(CsvWriter, WritesWhatTheReaderReads) {
  CsvWriter csv({"text", "number"});
  csv.Add(" \"a\",\nb\t").Add(1.0 / 3);
  Diagnostics diagnostics;
  const std::optional<CsvTable> table = ParseCsv(csv.text(), "t.csv", diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_EQ(table->Text(0, 0), " \"a\",\nb\t");
  EXPECT_EQ(table->Number(0, 1), 1.0 / 3);
}

TEST(CsvWriter, RefusesInfinity) {
  CsvWriter csv({"a"});
  EXPECT_THROW(csv.Add(kInfinity), std::invalid_argument);
}

TEST(CsvWriter, RefusesATableWithoutColumns) { EXPECT_THROW(CsvWriter({}), std::invalid_argument); }

TEST(CsvWriter, HasNoTextWithinARow) {
  CsvWriter csv({"a", "b"});
  csv.Add(1.0);
  EXPECT_THROW(csv.text(), std::logic_error);
}

}  // namespace
}  // namespace fourpost::csv_writer_test
