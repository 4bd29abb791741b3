#include "analysis/files/csv_dialect.h"

#include <gmock/gmock.h>

#include "analysis/files/csv.h"

namespace fourpost {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CsvTable Parse(std::string_view text, CsvHeader header = CsvHeader::kNamesAndUnits) {
  Diagnostics diagnostics;
  std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, header);
  if (!table) throw std::runtime_error(diagnostics.Format());
  return *table;
}

std::string Faults(std::string_view text) {
  Diagnostics diagnostics;
  const std::optional<CsvTable> table = ParseCsv(text, "t.csv", diagnostics, CsvHeader::kNamesAndUnits);
  if (table) table->Numbers(1, diagnostics);
  return diagnostics.Format();
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
  EXPECT_THAT(Faults("time;F\ns;N\n0;1,5\n1;2.5\n"), HasSubstr("t.csv:4: error: F '2.5' is not a finite number"));
  EXPECT_THAT(Faults("time;F\ns;N\n0;1.234,5\n1;2,5\n"), HasSubstr("F '1.234,5' is not a finite number"));
}

TEST(CsvDialectFault, RowsOfAnotherLength) {
  EXPECT_EQ(Faults("time;F\ns;N\n0;1,5\n1\n"), "t.csv:4: error: the row has 1 field, the header 2");
  EXPECT_EQ(Faults("time;F;\ns;N;\n0;1,5;7\n"), "t.csv:3: error: the row has 3 fields, the header 2");
}

TEST(CsvDialectFault, LinesAboveTheNames) {
  std::string rows = "time,F,x\ns,N,m\n";
  for (int i = 0; i < 100; ++i) rows += "0," + std::to_string(i) + ",2\n";
  EXPECT_EQ(Faults("Recorder 7\nof Monday\n" + rows),
            "t.csv:1: error: the names have 1 column, the rows below 3: remove the lines above the names");
  Diagnostics diagnostics;
  EXPECT_FALSE(ParseCsv("Recorder,7\n" + rows, "t.csv", diagnostics));
  EXPECT_EQ(diagnostics.Format(),
            "t.csv:1: error: the names have 2 columns, the rows below 3: remove the lines above the names, or name the "
            "last column, which may be empty");
  EXPECT_EQ(Faults("t,F,x\ns,N,m\n0,1\n1,1\n2,1\n"),
            "t.csv:1: error: the names have 3 columns, the rows below 2: name as many columns as there are");
  EXPECT_EQ(Faults("t,F\ns,N\n0,1,1,5\n0,2,2,5\n0,3,3,5\n"),
            "t.csv:1: error: the names have 2 columns, the rows below 4: remove the lines above the names; or separate "
            "columns by semicolons where decimals have commas");
}

TEST(CsvDialectFault, AnotherSeparator) {
  EXPECT_EQ(Faults("time|F\ns|N\n0|1.5\n0.1 | 2\n"),
            "t.csv:1: error: separates its columns by '|'; save it with commas, semicolons or tabs");
  EXPECT_EQ(Faults("time  F\n   s  N\n   0  1.5\n 0.1  2\n"),
            "t.csv:1: error: separates its columns by blanks; save it with commas, semicolons or tabs");
}

TEST(CsvDialectFault, LinesThatEndWithCarriageReturns) {
  EXPECT_EQ(Faults("time,F\rs,N\r0,1.5\r0.1,2\r"),
            "t.csv: error: ends its lines with CR alone; save it with line ends of Unix (LF) or Windows (CRLF)");
}

TEST(CsvDialectFault, Binary) {
  EXPECT_EQ(Faults(std::string("PK\x03\x04\n\0,\0\n,,", 11)),
            "t.csv: error: is no text but a binary file; export the table as CSV, or as MAT and name it .mat");
}

TEST(CsvDialectFault, Utf16) {
  EXPECT_EQ(Faults(std::string("\xFF\xFEt\0i\0", 6)), "t.csv: error: is written in UTF-16; save it as UTF-8");
}

}  // namespace
}  // namespace fourpost
