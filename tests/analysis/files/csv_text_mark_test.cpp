#include "analysis/files/csv_text_mark.h"

#include <gtest/gtest.h>

namespace fourpost::csv_text_mark_test {
namespace {

TEST(CsvTextMark, StandsBeforeWhatSpreadsheetsCompute) {
  EXPECT_EQ(WithTextMark("=1+1"), "'=1+1");
  EXPECT_EQ(WithTextMark("+a"), "'+a");
  EXPECT_EQ(WithTextMark("-a"), "'-a");
  EXPECT_EQ(WithTextMark("@a"), "'@a");
  for (const char* text : {"", "a=1", "'", "'a'", "a"}) EXPECT_EQ(WithTextMark(text), text);
}

TEST(CsvTextMark, IsReadAway) {
  for (const char* text : {"", "a", "=1", "'=1", "''=1", "'a", "'", "-a", "@"})
    EXPECT_EQ(WithoutTextMark(WithTextMark(text)), text);
}

}  // namespace
}  // namespace fourpost::csv_text_mark_test
