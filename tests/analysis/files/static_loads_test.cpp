#include "analysis/files/static_loads.h"

#include <gtest/gtest.h>

#include "analysis/files/findings.h"
#include "tests/analysis/faults_of.h"
#include "tests/analysis/files/mat_writer.h"
#include "tests/findings.h"
#include "tests/temporary_folder.h"

namespace fourpost::static_loads_test {
namespace {

const char kGood[] =
    "quantity,unit,value,sd\n"
    "load_FL,kN,4.971,0.02\n"
    "wheelbase,mm,2794,1.3\n"
    "wheelpan_mass,kg,25,0\n";

Diagnostics Faults(const std::string& text) { return FaultsOf("static.csv", text, ReadStaticLoads); }

TEST(StaticLoads, AreInSi) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto loads = ReadStaticLoads(folder.Write("static.csv", kGood), diagnostics);
  ASSERT_TRUE(loads) << diagnostics.Format();
  ASSERT_EQ(loads->size(), 3);
  EXPECT_EQ((*loads)[0].name, "load_FL");
  EXPECT_EQ((*loads)[0].value, 4971);
  EXPECT_EQ((*loads)[0].sd, 20);
  EXPECT_EQ((*loads)[0].dimension, kForce);
  EXPECT_EQ((*loads)[1].value, 2.794);
  // Not 1.3 * 0.001, which is another double.
  EXPECT_EQ((*loads)[1].sd, 0.0013);
  EXPECT_EQ((*loads)[2].dimension, kMass);
}

TEST(StaticLoads, MayHaveDecimalCommas) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  const auto loads =
      ReadStaticLoads(folder.Write("static.csv", "quantity;unit;value;sd\nload;kN;4,971;0,02\n"), diagnostics);
  ASSERT_TRUE(loads) << diagnostics.Format();
  EXPECT_EQ(loads->front().value, 4971);
  EXPECT_EQ(loads->front().sd, 20);
}

TEST(StaticLoads, MayBeAMatFile) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "static.mat").string();
  {
    MatWriter mat(file, MAT_FT_MAT5);
    mat.Add(MatWriter::Cells("quantity", {"load_FL", "wheelbase"}));
    mat.Add(MatWriter::Cells("unit", {"kN", "mm"}));
    mat.Add(MatWriter::Column("value", {4.971, 2794}));
    mat.Add(MatWriter::Column("sd", {0.02, 1.3}));
  }
  Diagnostics diagnostics;
  const auto loads = ReadStaticLoads(file, diagnostics);
  ASSERT_TRUE(loads) << diagnostics.Format();
  ASSERT_EQ(loads->size(), 2);
  EXPECT_EQ((*loads)[0].value, 4971);
  EXPECT_EQ((*loads)[1].name, "wheelbase");
  EXPECT_EQ((*loads)[1].sd, 0.0013);
}

TEST(StaticLoads, OfTheLandRoverAreRead) {
  Diagnostics diagnostics;
  const auto loads = ReadStaticLoads(FOURPOST_SOURCE_DIR "/studies/landrover110/static.csv", diagnostics);
  ASSERT_TRUE(loads) << diagnostics.Format();
  EXPECT_EQ(loads->front().name, "static_load_FL");
  EXPECT_EQ(loads->front().value, 4971);
}

TEST(StaticLoadsFault, MissingColumn) {
  EXPECT_THAT(Faults("quantity,unit,value\nload,N,1\n"), ReportsOnly(kColumnMissing, 1, {"'sd'"}));
}

TEST(StaticLoadsFault, UnknownColumn) {
  EXPECT_THAT(Faults("quantity,unit,value,sd,note\nload,N,1,0,x\n"), ReportsOnly(kColumnSuperfluous, 1, {"'note'"}));
}

TEST(StaticLoadsFault, QuantityTwice) {
  EXPECT_THAT(Faults(Replace(kGood, "wheelpan_mass", "load_FL")), ReportsOnly(kQuantityTwice, 4, {"2"}));
}

TEST(StaticLoadsFault, QuantityWithoutName) {
  EXPECT_THAT(Faults(Replace(kGood, "wheelbase", "")), ReportsOnly(kQuantityNameless, 3));
}

TEST(StaticLoadsFault, UnknownUnit) {
  EXPECT_THAT(Faults(Replace(kGood, "mm", "inch")), ReportsOnly(kQuantityUnit, 3, {"'inch', did you mean 'in'?", "1"}));
}

TEST(StaticLoadsFault, MissingUnit) {
  EXPECT_THAT(Faults(Replace(kGood, "mm", "")), ReportsOnly(kQuantityUnit, 3, {"''", "1"}));
}

TEST(StaticLoadsFault, MissingValue) {
  EXPECT_THAT(Faults(Replace(kGood, "2794", "")), ReportsOnly(kQuantityMissing, 3));
}

TEST(StaticLoadsFault, ValueThatIsNotANumber) {
  EXPECT_THAT(Faults(Replace(kGood, "2794", "NaN")), ReportsOnly(kQuantityNotANumber, 3, {"'NaN'"}));
}

TEST(StaticLoadsFault, ValueThatIsTooLargeInSi) {
  EXPECT_THAT(Faults(Replace(kGood, "4.971", "1e308")), ReportsOnly(kQuantityTooLarge, 2, {"'1e308'"}));
}

TEST(StaticLoadsFault, NegativeDeviation) {
  EXPECT_THAT(Faults(Replace(kGood, "1.3", "-1.3")), ReportsOnly(kDeviationNegative, 3));
}

TEST(StaticLoadsFault, AllAreReportedAtOnce) {
  EXPECT_THAT(Faults(Replace(Replace(kGood, "0.02", "x"), "kg", "stone")),
              AllOf(Reports(kQuantityNotANumber, 2, {"'x'"}), Reports(kQuantityUnit, 4, {"'stone'", "1"})));
}

}  // namespace
}  // namespace fourpost::static_loads_test
