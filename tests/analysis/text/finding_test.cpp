#include "analysis/text/finding.h"

#include <regex>

#include <gtest/gtest.h>

#include "tests/findings.h"

namespace fourpost::finding_test {
namespace {

const Finding kMassless{"test-massless", Severity::kError, "{} has no mass", "add <mass value=\"{}\"/>"};
const Finding kOdd{"test-odd", Severity::kWarning, "this is odd"};

TEST(Finding, PutsWordsInOrderIntoTextAndRemedy) {
  EXPECT_EQ(kMassless.Message({"link 'axle'", "80"}), "link 'axle' has no mass: add <mass value=\"80\"/>");
  EXPECT_EQ(kOdd.Message({}), "this is odd");
}

TEST(Finding, TakesAWordAsItIs) {
  EXPECT_EQ(kMassless.Message({"{}", "1"}), "{} has no mass: add <mass value=\"1\"/>");
}

TEST(Finding, RefusesAnotherNumberOfWords) {
  EXPECT_THROW(kMassless.Message({"one"}), std::logic_error);
  EXPECT_THROW(kMassless.Message({"one", "two", "three"}), std::logic_error);
}

TEST(Finding, HasAnIdOfItsOwn) { EXPECT_THROW(Finding("test-odd", Severity::kError, "again"), std::logic_error); }

TEST(Diagnostics, ReportFindingsWithIdAndPlace) {
  Diagnostics diagnostics;
  diagnostics.Report(kMassless, {"car.urdf", 12}, {"link 'axle'", "80"});
  EXPECT_THAT(diagnostics, Reports(kMassless, 12, {"'axle'", "80"}));
  EXPECT_THAT(diagnostics, testing::Not(Reports(kMassless, 13)));
  EXPECT_THAT(diagnostics, testing::Not(Reports(kMassless, 12, {"'beam'"})));
  EXPECT_THAT(diagnostics, testing::Not(Reports(kOdd, 12)));
}

TEST(Diagnostics, RefuseWithOneFinding) {
  EXPECT_THAT([] { Refuse(kOdd, Place::Option("--stroke")); }, Refuses(kOdd, "--stroke"));
}

}  // namespace
}  // namespace fourpost::finding_test
