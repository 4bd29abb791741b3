#include "analysis/files/csv.h"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::csv_test {
namespace {

using ::testing::ElementsAre;

CsvTable ParseGood(std::string_view text, CsvHeader header = CsvHeader::kNames) {
  Diagnostics diagnostics;
  std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, header);
  if (!table) throw std::runtime_error(diagnostics.Format());
  EXPECT_EQ(diagnostics.Format(), "");
  return *table;
}

Diagnostics Faults(std::string_view text, CsvHeader header = CsvHeader::kNames) {
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseCsv(text, "t.csv", diagnostics, header));
  return diagnostics;
}

TEST(Csv, HasNamesAndRowsAndTheirLines) {
  const CsvTable table = ParseGood("f,gain\n1,2\n3,4\n");
  EXPECT_EQ(table.file(), "t.csv");
  EXPECT_THAT(table.names(), ElementsAre("f", "gain"));
  EXPECT_THAT(table.units(), ElementsAre());
  ASSERT_EQ(table.rows(), 2);
  EXPECT_EQ(table.Text(1, 0), "3");
  EXPECT_EQ(table.Number(1, 1), 4);
  EXPECT_EQ(table.line(0), 2);
  EXPECT_EQ(table.line(1), 3);
  EXPECT_EQ(table.FindColumn("gain"), 1);
  EXPECT_FALSE(table.FindColumn("phase"));
}

TEST(Csv, HasNamesAndUnitsOfLatin1InUtf8) {
  const CsvTable table = ParseGood("Weg,Beschl\xE4unigung\nmm,m/s\xB2\n1,2\n", CsvHeader::kNamesAndUnits);
  EXPECT_THAT(table.names(), ElementsAre("Weg", "Beschl\u00E4unigung"));
  EXPECT_THAT(table.units(), ElementsAre("mm", "m/s\u00B2"));
}

TEST(Csv, NeedsNoLineBreakAtItsEnd) { EXPECT_EQ(ParseGood("f\n1\n2").rows(), 2); }

TEST(Csv, LeavesOutALastRowThatIsCutOff) {
  Diagnostics diagnostics;
  const std::optional<CsvTable> table =
      ParseCsv("a,b,c\ns,m,m\n1,2,3\n4,5,6\n7,8.", "t.csv", diagnostics, CsvHeader::kNamesAndUnits);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_EQ(table->rows(), 2);
  EXPECT_THAT(diagnostics, ReportsOnly(kCsvLastRowCut, 5, {"2 fields of 3"}));
  EXPECT_THAT(Faults("a,b,c\n1,2,3\n4,5\n7,8,9"), ReportsOnly(kCsvRowLength, 3, {"2", "3"}));
  // Results of our own have no units, and are damaged.
  EXPECT_THAT(Faults("a,b,c\n1,2,3\n4,5"), ReportsOnly(kCsvRowLength, 3, {"2", "3"}));
}

TEST(Csv, MayHaveARowOfUnits) {
  const CsvTable table = ParseGood("t,z\ns,mm\n0,1\n", CsvHeader::kNamesAndUnits);
  EXPECT_THAT(table.units(), ElementsAre("s", "mm"));
  EXPECT_EQ(table.rows(), 1);
  EXPECT_EQ(table.line(0), 3);
}

// As numpy.savetxt writes headers.
TEST(Csv, MayHaveMarkedNamesAndUnits) {
  for (const char* text : {"# time,z\n# s,mm\n0,1\n1,2\n2,3\n", "% time,z\n% s,mm\n0,1\n1,2\n2,3\n",
                           "#time,z\n#[s],[mm]\n0,1\n1,2\n2,3\n", "# time,z\ns,mm\n0,1\n1,2\n2,3\n"}) {
    const CsvTable table = ParseGood(text, CsvHeader::kNamesAndUnits);
    EXPECT_THAT(table.names(), ElementsAre("time", "z")) << text;
    EXPECT_THAT(table.units(), ElementsAre("s", "mm")) << text;
    EXPECT_EQ(table.rows(), 3) << text;
  }
  // A per cent is a unit.
  EXPECT_THAT(ParseGood("load,z\n%,mm\n0,1\n", CsvHeader::kNamesAndUnits).units(), ElementsAre("%", "mm"));
}

TEST(Csv, TakesTheLineBreaksAndTheMarkOfWindows) {
  const CsvTable table = ParseGood(
      "\xEF\xBB\xBF"
      "f,gain\r\n1,2\r\n");
  EXPECT_THAT(table.names(), ElementsAre("f", "gain"));
  EXPECT_EQ(table.Text(0, 1), "2");
}

TEST(Csv, IgnoresBlanksAroundFieldsAndBlankLines) {
  const CsvTable table = ParseGood("\n f , gain \n\n 1 ,\t2 \n  \n3,4\n");
  EXPECT_THAT(table.names(), ElementsAre("f", "gain"));
  ASSERT_EQ(table.rows(), 2);
  EXPECT_EQ(table.Text(0, 1), "2");
  EXPECT_EQ(table.line(1), 6);
}

TEST(Csv, TakesQuotedCommasQuotesBlanksAndLineBreaks) {
  const CsvTable table = ParseGood("a,b\n\"x,y\",\" \"\"z\"\"\n\" \nlast,1\n");
  EXPECT_EQ(table.Text(0, 0), "x,y");
  EXPECT_EQ(table.Text(0, 1), " \"z\"\n");
  EXPECT_EQ(table.line(1), 4);
}

TEST(Csv, NumberIsNaNForABlankAndNothingForText) {
  const CsvTable table = ParseGood("a,b\n,x\n");
  EXPECT_TRUE(std::isnan(table.Number(0, 0).value()));
  EXPECT_FALSE(table.Number(0, 1));
}

TEST(Csv, NumbersReportsEveryFieldThatIsNone) {
  const CsvTable table = ParseGood("a,b\n1,\n2,nan\n3,4\n5,1.2.3\n");
  Diagnostics diagnostics;
  const std::vector<double> numbers = table.Numbers(1, diagnostics);
  EXPECT_THAT(diagnostics, AllOf(Reports(kCsvNotANumber, 3, {"'nan'"}), Reports(kCsvNotANumber, 5, {"'1.2.3'"})));
  ASSERT_EQ(numbers.size(), 4);
  EXPECT_TRUE(std::isnan(numbers[0]));
  EXPECT_TRUE(std::isnan(numbers[1]));
  EXPECT_EQ(numbers[2], 4);
}

TEST(CsvFault, EmptyFile) {
  EXPECT_THAT(Faults(""), ReportsOnly(kCsvEmpty, 0));
  EXPECT_THAT(Faults("\n \n"), ReportsOnly(kCsvEmpty, 0));
}

TEST(CsvFault, NoRows) { EXPECT_THAT(Faults("a,b\n"), ReportsOnly(kCsvNoRows, 0)); }

/// Units alone would not mend it.
TEST(CsvFault, NoRowsAndNoUnits) {
  for (const char* text : {"a,b\n", "a [m],b [N]\n", "a,b\nm,N\n"})
    EXPECT_THAT(Faults(text, CsvHeader::kNamesAndUnits), ReportsOnly(kCsvNoRows, 0));
}

TEST(CsvFault, ColumnWithoutName) { EXPECT_THAT(Faults("a,,c\n1,2,3\n"), ReportsOnly(kCsvColumnNameless, 1, {"2"})); }

TEST(CsvFault, ColumnWithTheNameOfAnother) {
  EXPECT_THAT(Faults("a,b,a\n1,2,3\n"), ReportsOnly(kCsvColumnTwice, 1, {"'a'", "3"}));
}

TEST(CsvFault, RowsOfAnotherLength) {
  EXPECT_THAT(Faults("a,b\n1\n2,3\n4,5,6\n"),
              AllOf(Reports(kCsvRowLength, 2, {"1", "2"}), Reports(kCsvRowLength, 4, {"3", "2"})));
}

TEST(CsvFault, QuoteThatIsNeverClosed) {
  EXPECT_THAT(Faults("a,b\n1,2\n\"3,4\n5,6\n"), ReportsOnly(kCsvQuoteOpen, 3, {"3"}));
}

TEST(CsvFault, TextBehindAQuote) { EXPECT_THAT(Faults("a,b\n\"1\"x,2\n"), ReportsOnly(kCsvTextBehindQuote, 2)); }

TEST(CsvFile, IsReadAsItsText) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::optional<CsvTable> table = ReadCsv(folder.Write("t.csv", "a\n1\n"), diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_EQ(table->file(), (folder.path() / "t.csv").string());
  EXPECT_EQ(table->Number(0, 0), 1);
}

TEST(CsvFile, ThatIsEmptyIsToldApartFromAnUnreadableOne) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("t.csv", "");
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadCsv(path, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kCsvEmpty, 0));
}

TEST(CsvFile, ThatIsNotThereIsReported) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "t.csv";
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadCsv(path, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kFileNotThere, 0));
}

TEST(CsvFile, ThatIsAFolderIsReported) {
  const TemporaryFolder folder;
  const std::string path = folder.path();
  Diagnostics diagnostics;
  EXPECT_FALSE(ReadCsv(path, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kFileUnreadable, 0));
}

}  // namespace
}  // namespace fourpost::csv_test
