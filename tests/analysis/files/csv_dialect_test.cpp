#include "analysis/files/csv_dialect.h"

#include <gmock/gmock.h>

#include "analysis/files/csv.h"
#include "analysis/files/findings.h"
#include "tests/findings.h"

namespace fourpost::csv_dialect_test {
namespace {

using testing::ElementsAre;

CsvTable Parse(std::string_view text, CsvHeader header = CsvHeader::kNamesAndUnits) {
  Diagnostics diagnostics;
  std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, header);
  if (!table) throw std::runtime_error(diagnostics.Format());
  return *table;
}

Diagnostics Faults(std::string_view text) {
  Diagnostics diagnostics;
  const std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, CsvHeader::kNamesAndUnits);
  if (table) table->Numbers(1, diagnostics);
  return diagnostics;
}

/// The same two samples as a system writes them.
struct Written {
  std::string system;
  std::string text;
};

std::ostream& operator<<(std::ostream& out, const Written& written) { return out << written.system; }

class CsvDialects : public testing::TestWithParam<Written> {};

TEST_P(CsvDialects, AreTheSameTable) {
  const CsvTable table = Parse(GetParam().text);
  EXPECT_THAT(table.names(), ElementsAre("time", "Kraft"));
  EXPECT_THAT(table.units(), ElementsAre("s", "kN"));
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.Number(0, 1), 1.5);
  EXPECT_EQ(table.Number(1, 0), 0.002);
  EXPECT_EQ(table.Number(1, 1), -2e3);
}

INSTANTIATE_TEST_SUITE_P(
    All, CsvDialects,
    testing::Values(Written{"Commas", "time,Kraft\ns,kN\n0,1.5\n0.002,-2e3\n"},
                    Written{"Semicolons", "time;Kraft\ns;kN\n0;1.5\n0.002;-2e3\n"},
                    Written{"GermanExcel", "\xEF\xBB\xBFtime;Kraft\r\ns;kN\r\n0;1,5\r\n0,002;-2e3\r\n"},
                    Written{"DecimalCommaInTheExponentsNumber", "time;Kraft\ns;kN\n0;1,5\n0,002;-2,0E+03\n"},
                    Written{"TabsAndDecimalCommas", "time\tKraft\ns\tkN\n0\t1,5\n0,002\t-2000\n"},
                    Written{"NoteOfTheSeparator", "sep=;\r\ntime;Kraft\r\ns;kN\r\n0;1,5\r\n0,002;-2000\r\n"},
                    Written{"SeparatorsAtTheEnd", "time;Kraft;\ns;kN;\n0;1,5;\n0,002;-2000;\n"},
                    Written{"UnitsBehindTheNames", "time [s];Kraft [kN]\n0;1,5\n0,002;-2000\n"},
                    Written{"UnitsInRoundBrackets", "time (s),Kraft (kN)\n0,1.5\n0.002,-2000\n"},
                    Written{"UnitsBelowInBrackets", "time;Kraft\n[s];[kN]\n0;1,5\n0,002;-2000\n"},
                    Written{"UnitsBelowInRoundBrackets", "time,Kraft\n(s),( kN )\n0,1.5\n0.002,-2000\n"},
                    Written{"UnitsBehindAStroke", "time / s\tKraft / kN\n0\t1.5\n0.002\t-2000\n"},
                    Written{"QuotedNames", "\"time\";\"Kraft\"\n\"s\";\"kN\"\n\"0\";\"1,5\"\n\"0,002\";\"-2000\"\n"},
                    Written{"BlanksBesideTabs", "time \t Kraft\ns\tkN\n 0\t 1.5\n 0.002\t-2000 \n"}),
    [](const auto& test) { return test.param.system; });

TEST(CsvDialect, LeavesCommasInNamesAlone) {
  const CsvTable table = Parse("time;Kraft, vorn\ns;N\n0;1,5\n");
  EXPECT_THAT(table.names(), ElementsAre("time", "Kraft, vorn"));
  EXPECT_EQ(table.Number(0, 1), 1.5);
}

// With as many commas as the names have, and one more.
TEST(CsvDialect, KnowsALineAboutTheTableFromItsNames) {
  for (const char* about : {"# rig 7, cold", "# rig 7, cold, dry", "% rig 7, cold", "rig 7, cold"}) {
    const CsvTable table = Parse(std::string(about) + "\ntime [s],force [kN]\n0,1.5\n1,2\n2,3\n");
    EXPECT_THAT(table.names(), ElementsAre("time", "force")) << about;
    EXPECT_THAT(table.units(), ElementsAre("s", "kN")) << about;
  }
  const CsvTable bare = Parse("# rig 7, cold\ntime,force\ns,kN\n0,1.5\n1,2\n2,3\n");
  EXPECT_THAT(bare.names(), ElementsAre("time", "force"));
  EXPECT_THAT(bare.units(), ElementsAre("s", "kN"));
}

TEST(CsvDialect, KnowsMarkedNamesAboveUnits) {
  for (const char* names : {"# time, force\ns, m/s\n", "# time, force\n# s, m/s\n", "#time,force\n[s],[m/s]\n"}) {
    const CsvTable table = Parse(std::string(names) + "0,1.5\n1,2\n2,3\n");
    EXPECT_THAT(table.names(), ElementsAre("time", "force")) << names;
    EXPECT_EQ(table.units().back(), "m/s") << names;
  }
}

TEST(CsvDialect, KeepsEmptyFieldsBetweenTabs) {
  const CsvTable table = Parse("a\tb\tc\n1\t\t3\n", CsvHeader::kNames);
  EXPECT_EQ(table.Text(0, 1), "");
  EXPECT_EQ(table.Text(0, 2), "3");
}

TEST(CsvDialect, TakesARowOfPureNumbersFor1) {
  const CsvTable table = Parse("time,share\ns,1\n0,0.5\n");
  EXPECT_THAT(table.units(), ElementsAre("s", "1"));
  EXPECT_EQ(table.rows(), 1u);
}

TEST(CsvDialectFault, TwoDecimalSigns) {
  EXPECT_THAT(Faults("time;F\ns;N\n0;1,5\n1;2.5\n"), Reports(kCsvNotANumber, 4, {"'2.5'"}));
  EXPECT_THAT(Faults("time;F\ns;N\n0;1.234,5\n1;2,5\n"), Reports(kCsvNotANumber, {"'1.234,5'"}));
}

TEST(CsvDialectFault, RowsOfAnotherLength) {
  EXPECT_THAT(Faults("time;F\ns;N\n0;1,5\n1\n"), ReportsOnly(kCsvRowLength, 4, {"1", "2"}));
  EXPECT_THAT(Faults("time;F;\ns;N;\n0;1,5;7\n"), ReportsOnly(kCsvRowLength, 3, {"3", "2"}));
}

TEST(CsvDialectFault, LinesAboveTheNames) {
  // Rows that begin with words do not show where the table begins.
  std::string rows = "quantity,F,x\n-,N,m\n";
  for (int i = 0; i < 100; ++i) rows += "load," + std::to_string(i) + ",2\n";
  EXPECT_THAT(Faults("Recorder 7\nof Monday\n" + rows), ReportsOnly(kCsvLinesAboveNames, 1, {"1", "3"}));
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseCsv("Recorder,7\n" + rows, "t.csv", diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kCsvLastColumnUnnamed, 1, {"2", "3"}));
  EXPECT_THAT(Faults("t,F,x\ns,N,m\n0,1\n1,1\n2,1\n"), ReportsOnly(kCsvTooManyNames, 1, {"3", "2"}));
  EXPECT_THAT(Faults("t,F\ns,N\n0,1,1,5\n0,2,2,5\n0,3,3,5\n"), ReportsOnly(kCsvDecimalCommas, 1, {"2", "4"}));
}

TEST(CsvDialectFault, AnotherSeparator) {
  EXPECT_THAT(Faults("time|F\ns|N\n0|1.5\n0.1 | 2\n"), ReportsOnly(kCsvSeparator, 1, {"'|'"}));
  EXPECT_THAT(Faults("time  F\n   s  N\n   0  1.5\n 0.1  2\n"), ReportsOnly(kCsvSeparator, 1));
}

TEST(CsvDialectFault, LinesThatEndWithCarriageReturns) {
  EXPECT_THAT(Faults("time,F\rs,N\r0,1.5\r0.1,2\r"), ReportsOnly(kCsvLineEnds, 0));
}

TEST(CsvDialectFault, Binary) {
  EXPECT_THAT(Faults(std::string("PK\x03\x04\n\0,\0\n,,", 11)), ReportsOnly(kCsvBinary, 0));
}

TEST(CsvDialectFault, Utf16) {
  EXPECT_THAT(Faults(std::string("\xFF\xFEt\0i\0", 6)), ReportsOnly(kCsvUtf16, 0, {"16", "8"}));
}

}  // namespace
}  // namespace fourpost::csv_dialect_test
