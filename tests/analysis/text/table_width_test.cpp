#include "analysis/text/table_width.h"

#include <limits>

#include <gtest/gtest.h>

#include "analysis/text/text_table.h"

namespace fourpost::table_width_test {
namespace {

class TableWidth : public testing::Test {
 protected:
  ~TableWidth() override { SetTableWidth(std::numeric_limits<std::size_t>::max()); }

  static std::string Table() {
    TextTable table({"name", "first", "second", "third"});
    table.Add({"a", "1", "2", "3"});
    return table.Format();
  }
};

TEST_F(TableWidth, IsUnlimitedAtFirst) {
  EXPECT_EQ(Table(),
            "name  first  second  third\n"
            "a         1       2      3\n");
}

TEST_F(TableWidth, PartsColumnsAndRepeatsTheFirst) {
  SetTableWidth(19);
  EXPECT_EQ(Table(),
            "name  first  second\n"
            "a         1       2\n"
            "\n"
            "name  third\n"
            "a         3\n");
}

TEST_F(TableWidth, LeavesAColumnThatIsWiderAlone) {
  SetTableWidth(3);
  EXPECT_EQ(Table(),
            "name  first\n"
            "a         1\n"
            "\n"
            "name  second\n"
            "a          2\n"
            "\n"
            "name  third\n"
            "a         3\n");
}

}  // namespace
}  // namespace fourpost::table_width_test
