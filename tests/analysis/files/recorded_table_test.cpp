#include "analysis/files/recorded_table.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

namespace fourpost {
namespace {

RecordedTable TableOf(std::string_view text) {
  Diagnostics diagnostics;
  return RecordedTable(ParseCsv(text, "t.csv", diagnostics).value());
}

class RecordedColumns : public ::testing::Test {
 protected:
  std::string Check(std::string_view text) {
    Diagnostics diagnostics;
    const bool good = TableOf(text).CheckColumns(required_, optional_, diagnostics);
    EXPECT_EQ(good, !diagnostics.HasErrors());
    return diagnostics.Format();
  }

  const std::array<std::string_view, 2> required_ = {"frequency", "gain"};
  const std::array<std::string_view, 1> optional_ = {"phase"};
};

TEST_F(RecordedColumns, MayLackOptionalOnes) {
  EXPECT_EQ(Check("gain,frequency\n1,2\n"), "");
  EXPECT_EQ(Check("gain,phase,frequency\n1,2,3\n"), "");
}

TEST_F(RecordedColumns, MayNotLackRequiredOnes) {
  EXPECT_EQ(Check("phase\n1\n"),
            "t.csv:1: error: column 'frequency' is missing; add it\n"
            "t.csv:1: error: column 'gain' is missing; add it");
}

TEST_F(RecordedColumns, MayNotHaveOthers) {
  EXPECT_EQ(Check("gain,frequency,phsae,colour\n1,2,3,4\n"),
            "t.csv:1: error: unknown column 'phsae', did you mean 'phase'?\n"
            "t.csv:1: error: unknown column 'colour'; remove it");
}

TEST_F(RecordedColumns, AreOfOneLength) {
  const RecordedTable table("t.mat", {{.name = "frequency", .values = {1, 2}},
                                      {.name = "gain", .values = {1, 2, 3}},
                                      {.name = "phase", .values = {1, 2}}});
  Diagnostics diagnostics;
  EXPECT_FALSE(table.CheckColumns(required_, optional_, diagnostics));
  EXPECT_EQ(diagnostics.Format(), "t.mat: error: column 'gain' has 3 rows, column 'frequency' 2; give all the same");
}

TEST(RecordedTable, OfAMatFileHasRowsInPlaceOfLines) {
  const RecordedTable table("t.mat",
                            {{.name = "channel", .texts = {"body", "axle"}}, {.name = "gain", .values = {1, 2}}});
  EXPECT_EQ(table.WithRow(1, "is wrong"), "row 2: is wrong");
  EXPECT_TRUE(table.HoldsText(0));
  EXPECT_EQ(table.Text(1, 0), "axle");
  EXPECT_FALSE(table.Number(1, 0));
  EXPECT_EQ(table.Text(1, 1), "2");
  EXPECT_EQ(TableOf("a\n1\n").WithRow(0, "is wrong"), "is wrong");
}

}  // namespace
}  // namespace fourpost
