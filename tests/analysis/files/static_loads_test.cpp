#include "analysis/files/static_loads.h"

#include <gtest/gtest.h>

#include "tests/analysis/faults_of.h"
#include "tests/analysis/files/mat_writer.h"
#include "tests/temporary_folder.h"

namespace fourpost {
namespace {

const char kGood[] =
    "quantity,unit,value,sd\n"
    "load_FL,kN,4.971,0.02\n"
    "wheelbase,mm,2794,1.3\n"
    "wheelpan_mass,kg,25,0\n";

std::string Faults(const std::string& text) { return FaultsOf("static.csv", text, ReadStaticLoads); }

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
  EXPECT_EQ(Faults("quantity,unit,value\nload,N,1\n"), "static.csv:1: error: column 'sd' is missing; add it");
}

TEST(StaticLoadsFault, UnknownColumn) {
  EXPECT_EQ(Faults("quantity,unit,value,sd,note\nload,N,1,0,x\n"),
            "static.csv:1: error: unknown column 'note'; remove it");
}

TEST(StaticLoadsFault, QuantityTwice) {
  EXPECT_EQ(Faults(Replace(kGood, "wheelpan_mass", "load_FL")),
            "static.csv:4: error: load_FL is in line 2 already; remove one of the two");
}

TEST(StaticLoadsFault, QuantityWithoutName) {
  EXPECT_EQ(Faults(Replace(kGood, "wheelbase", "")),
            "static.csv:3: error: the quantity has no name; write one or remove the row");
}

TEST(StaticLoadsFault, UnknownUnit) {
  EXPECT_EQ(Faults(Replace(kGood, "mm", "inch")),
            "static.csv:3: error: wheelbase: the unit 'inch' is not known; write one like N, kg, mm, or 1");
}

TEST(StaticLoadsFault, MissingUnit) {
  EXPECT_EQ(Faults(Replace(kGood, "mm", "")),
            "static.csv:3: error: wheelbase: the unit '' is not known; write one like N, kg, mm, or 1");
}

TEST(StaticLoadsFault, MissingValue) {
  EXPECT_EQ(Faults(Replace(kGood, "2794", "")), "static.csv:3: error: wheelbase: value is missing; write a number");
}

TEST(StaticLoadsFault, ValueThatIsNotANumber) {
  EXPECT_EQ(Faults(Replace(kGood, "2794", "NaN")),
            "static.csv:3: error: wheelbase: value 'NaN' is not a finite number; correct it");
}

TEST(StaticLoadsFault, ValueThatIsTooLargeInSi) {
  EXPECT_EQ(Faults(Replace(kGood, "4.971", "1e308")),
            "static.csv:2: error: load_FL: value '1e308' is too large; correct it");
}

TEST(StaticLoadsFault, NegativeDeviation) {
  EXPECT_EQ(Faults(Replace(kGood, "1.3", "-1.3")),
            "static.csv:3: error: wheelbase: sd must not be negative; correct it");
}

TEST(StaticLoadsFault, AllAreReportedAtOnce) {
  EXPECT_EQ(Faults(Replace(Replace(kGood, "0.02", "x"), "kg", "stone")),
            "static.csv:2: error: load_FL: sd 'x' is not a finite number; correct it\n"
            "static.csv:4: error: wheelpan_mass: the unit 'stone' is not known; write one like N, kg, mm, or 1");
}

}  // namespace
}  // namespace fourpost
