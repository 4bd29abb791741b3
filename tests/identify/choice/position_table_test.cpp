#include "identify/choice/position_table.h"

#include <gmock/gmock.h>

#include "identify/choice/findings.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::position_table_test {
namespace {

using testing::ElementsAre;

TEST(PositionTable, InterpolatesBetweenNumbersAndNotBetweenNames) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const std::optional<PositionTable> clicks =
      ReadPositionTable(folder.Write("clicks.csv", "click,rate\n,kN*s/m\n1,1\n3,2\n10,3\n"), diagnostics);
  ASSERT_TRUE(clicks) << diagnostics.Format();
  EXPECT_EQ(clicks->RowOf("3"), 1);
  EXPECT_EQ(clicks->RowOf("2"), 0.5);
  EXPECT_EQ(clicks->At(0, *clicks->RowOf("2")), 1500);
  EXPECT_EQ(clicks->At(0, *clicks->RowOf("10")), 3000);
  EXPECT_FALSE(clicks->RowOf("0"));
  EXPECT_FALSE(clicks->RowOf("11"));
  EXPECT_FALSE(clicks->RowOf("soft"));
  EXPECT_EQ(clicks->RangeText(), "1 .. 10");
  const std::optional<PositionTable> springs =
      ReadPositionTable(folder.Write("springs.csv", "spring,rate\n,N/m\nsoft,10\nhard,20\n"), diagnostics);
  ASSERT_TRUE(springs) << diagnostics.Format();
  EXPECT_EQ(springs->RowOf("hard"), 1);
  EXPECT_FALSE(springs->RowOf("1"));
  EXPECT_EQ(springs->RangeText(), "soft, hard");
}

constexpr const char* kDamper = R"(<robot name="bench" xmlns:fp="urn:fourpost:vehicle:1"><link name="tube"/>
<link name="rod"><inertial><mass value="1"/><inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="stroke" type="prismatic"><parent link="tube"/><child link="rod"/><origin xyz="0.4 0 0"/><axis xyz="1 0 0"/>
<limit lower="-1" upper="1" effort="0" velocity="0"/></joint>
<fp:parameter name="c" value="500 N*s/m" lower="0.1 kN*s/m" upper="3 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:parameter name="c_at_1" value="900 N*s/m" lower="0.1 kN*s/m" upper="3 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:parameter name="c_at_2" value="1500 N*s/m" lower="0.1 kN*s/m" upper="3 kN*s/m" precision="1 N*s/m" source="fit"/>
<fp:damper name="mr" parent="tube" child="rod"><linear rate="$c"/></fp:damper>
</robot>)";

// As the fit of a damper at three settings leaves it.
TEST(PositionTable, OfARunHasTheFittedValuesAtItsSettings) {
  const TemporaryFolder folder;
  folder.Write("vehicle.urdf", kDamper);
  folder.Write(
      "study.yaml",
      "vehicle: vehicle.urdf\ncontrol: {c: per setting}\nbench:\n  recordings:\n"
      "    - {file: 0.csv, control: 0 A}\n    - {file: 1.csv, control: 1 A}\n    - {file: 2.csv, control: 2 A}\n");
  Diagnostics diagnostics;
  const std::optional<PositionTable> table = PositionTableOfRun(folder.path(), diagnostics);
  ASSERT_TRUE(table) << diagnostics.Format();
  EXPECT_THAT(table->rows, ElementsAre("0", "1", "2"));
  const std::optional<std::size_t> column = table->FindColumn("c");
  ASSERT_TRUE(column);
  EXPECT_THAT(table->columns[*column].values, ElementsAre(500, 900, 1500));
  EXPECT_EQ(table->At(*column, *table->RowOf("1.5")), 1200);
  folder.Write("study.yaml", "vehicle: vehicle.urdf\nbench:\n  recordings: [0.csv]\n");
  EXPECT_FALSE(PositionTableOfRun(folder.path(), diagnostics));
  EXPECT_THAT(diagnostics, Reports(kPositionsNoControl));
}

}  // namespace
}  // namespace fourpost::position_table_test
