#include "analysis/text/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost {
namespace {

using ::testing::EndsWith;

TEST(Diagnostic, HasTheFormEditorsUnderstand) {
  EXPECT_EQ(Format({"mass", Severity::kError, {"car.urdf", 12}, "no mass"}), "car.urdf:12: error: no mass [mass]");
  EXPECT_EQ(Format({"", Severity::kWarning, {"car.urdf"}, "no mass"}), "car.urdf: warning: no mass");
  EXPECT_EQ(Format({"", Severity::kError, {}, "no mass"}), "error: no mass");
  EXPECT_EQ(Format({"", Severity::kError, Place::Option("--stroke"), "no length"}), "--stroke: error: no length");
}

TEST(Diagnostics, HasNoErrorsWithWarningsOnly) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Warning("a.csv", 1, "odd");
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Error("a.csv", 2, "wrong");
  EXPECT_TRUE(diagnostics.HasErrors());
  EXPECT_EQ(diagnostics.items().size(), 2);
}

TEST(Diagnostics, StandByFileErrorsFirstThenByLineAndElseAsTheyCame) {
  Diagnostics diagnostics;
  diagnostics.Warning("a.csv", 1, "sixth");
  diagnostics.Error("c.csv", 1, "fifth");
  diagnostics.Error("b.csv", 10, "third");
  diagnostics.Error("b.csv", 9, "first");
  diagnostics.Error("b.csv", 9, "second");
  diagnostics.Warning("b.csv", 2, "fourth");
  EXPECT_EQ(diagnostics.Format(),
            "b.csv:9: error: first\n"
            "b.csv:9: error: second\n"
            "b.csv:10: error: third\n"
            "b.csv:2: warning: fourth\n"
            "c.csv:1: error: fifth\n"
            "a.csv:1: warning: sixth");
}

TEST(Diagnostics, AreEmptyTextWhenThereAreNone) { EXPECT_EQ(Diagnostics().Format(), ""); }

TEST(Diagnostics, OfOneFileDoNotBuryThoseOfAnother) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 103; ++line) diagnostics.Error("a.csv", line, "wrong");
  diagnostics.Error("b.csv", 1, "wrong");
  EXPECT_THAT(diagnostics.Format(), EndsWith("a.csv:100: error: wrong\na.csv: 3 more\nb.csv:1: error: wrong"));
}

TEST(Diagnostics, OfOneFileAreAllShownUpToAHundred) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 100; ++line) diagnostics.Error("a.csv", line, "wrong");
  EXPECT_THAT(diagnostics.Format(), EndsWith("a.csv:100: error: wrong"));
}

TEST(Diagnostics, KeepBeginningAndEndOfMessagesOfMegabytes) {
  Diagnostics diagnostics;
  diagnostics.Error("a.csv", 1, "unknown '" + std::string(5'000'000, 'n') + "'; remove it");
  EXPECT_LT(diagnostics.Format().size(), 2100u);
  EXPECT_THAT(diagnostics.Format(), testing::StartsWith("a.csv:1: error: unknown 'nnn"));
  EXPECT_THAT(diagnostics.Format(), EndsWith("nnn'; remove it"));
}

TEST(FaultyInput, SaysWhatTheDiagnosticsSay) {
  Diagnostics diagnostics;
  diagnostics.Error("a.csv", 2, "wrong");
  const FaultyInput error(diagnostics);
  EXPECT_STREQ(error.what(), "a.csv:2: error: wrong");
  EXPECT_EQ(error.diagnostics().items().size(), 1);
}

}  // namespace
}  // namespace fourpost
