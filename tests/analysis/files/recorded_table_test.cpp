#include "analysis/files/recorded_table.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "tests/findings.h"

namespace fourpost::recorded_table_test {
namespace {

RecordedTable TableOf(std::string_view text) {
  Diagnostics diagnostics;
  return RecordedTable(ParseCsv(text, "t.csv", diagnostics).value());
}

class RecordedColumns : public ::testing::Test {
 protected:
  Diagnostics Check(std::string_view text) {
    Diagnostics diagnostics;
    const bool good = TableOf(text).CheckColumns(required_, optional_, diagnostics);
    EXPECT_EQ(good, !diagnostics.HasErrors());
    return diagnostics;
  }

  const std::array<std::string_view, 2> required_ = {"frequency", "gain"};
  const std::array<std::string_view, 1> optional_ = {"phase"};
};

TEST_F(RecordedColumns, MayLackOptionalOnes) {
  EXPECT_THAT(Check("gain,frequency\n1,2\n").items(), testing::IsEmpty());
  EXPECT_THAT(Check("gain,phase,frequency\n1,2,3\n").items(), testing::IsEmpty());
}

TEST_F(RecordedColumns, MayNotLackRequiredOnes) {
  EXPECT_THAT(Check("phase\n1\n"),
              AllOf(Reports(kColumnMissing, 1, {"'frequency'"}), Reports(kColumnMissing, 1, {"'gain'"})));
}

TEST_F(RecordedColumns, MayNotHaveOthers) {
  EXPECT_THAT(Check("gain,frequency,phsae,colour\n1,2,3,4\n"),
              AllOf(Reports(kColumnUnknown, 1, {"'phsae'", "'phase'"}), Reports(kColumnSuperfluous, 1, {"'colour'"})));
}

TEST_F(RecordedColumns, AreOfOneLength) {
  const RecordedTable table("t.mat", {{.name = "frequency", .values = {1, 2}},
                                      {.name = "gain", .values = {1, 2, 3}},
                                      {.name = "phase", .values = {1, 2}}});
  Diagnostics diagnostics;
  EXPECT_FALSE(table.CheckColumns(required_, optional_, diagnostics));
  EXPECT_THAT(diagnostics, ReportsOnly(kColumnLength, 0, {"'gain'", "'frequency'", "3", "2"}));
}

TEST(RecordedTable, OfAMatFileHasRowsInPlaceOfLines) {
  const RecordedTable table("t.mat",
                            {{.name = "channel", .texts = {"body", "axle"}}, {.name = "gain", .values = {1, 2}}});
  Diagnostics diagnostics;
  table.Report(kQuantityNameless, 1, {}, diagnostics);
  EXPECT_THAT(diagnostics, ReportsOnly(kQuantityNameless, 0, {"row 2: "}));
  EXPECT_TRUE(table.HoldsText(0));
  EXPECT_EQ(table.Text(1, 0), "axle");
  EXPECT_FALSE(table.Number(1, 0));
  EXPECT_EQ(table.Text(1, 1), "2");
  TableOf("a\n1\n").Report(kQuantityNameless, 0, {}, diagnostics);
  EXPECT_THAT(diagnostics, Reports(kQuantityNameless, 2));
}

}  // namespace
}  // namespace fourpost::recorded_table_test
