#include "analysis/text/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::diagnostics_test {
namespace {

using ::testing::EndsWith;

const Finding kWrong{"test-wrong", Severity::kError, "{}"};
const Finding kUnusual{"test-unusual", Severity::kWarning, "{}"};
const Finding kGrave{"test-grave", Severity::kWarning, "this is grave", "", Weight::kGrave};

TEST(Diagnostic, HasTheFormEditorsUnderstand) {
  EXPECT_EQ(Format({"mass", Severity::kError, {"car.urdf", 12}, "no mass"}), "car.urdf:12: error: no mass [mass]");
  EXPECT_EQ(Format({"", Severity::kWarning, {"car.urdf"}, "no mass"}), "car.urdf: warning: no mass");
  EXPECT_EQ(Format({"", Severity::kError, {}, "no mass"}), "error: no mass");
  EXPECT_EQ(Format({"", Severity::kError, Place::Option("--stroke"), "no length"}), "--stroke: error: no length");
}

TEST(Diagnostics, HasNoErrorsWithWarningsOnly) {
  Diagnostics diagnostics;
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Report(kUnusual, {"a.csv", 1}, {"odd"});
  EXPECT_FALSE(diagnostics.HasErrors());
  diagnostics.Report(kWrong, {"a.csv", 2}, {"wrong"});
  EXPECT_TRUE(diagnostics.HasErrors());
  EXPECT_EQ(diagnostics.items().size(), 2);
}

TEST(Diagnostics, StandByFileErrorsFirstThenByLineAndElseAsTheyCame) {
  Diagnostics diagnostics;
  diagnostics.Report(kUnusual, {"a.csv", 1}, {"sixth"});
  diagnostics.Report(kWrong, {"c.csv", 1}, {"fifth"});
  diagnostics.Report(kWrong, {"b.csv", 10}, {"third"});
  diagnostics.Report(kWrong, {"b.csv", 9}, {"first"});
  diagnostics.Report(kWrong, {"b.csv", 9}, {"second"});
  diagnostics.Report(kUnusual, {"b.csv", 2}, {"fourth"});
  EXPECT_EQ(diagnostics.Format(),
            "b.csv:9: error: first [test-wrong]\n"
            "b.csv:9: error: second [test-wrong]\n"
            "b.csv:10: error: third [test-wrong]\n"
            "b.csv:2: warning: fourth [test-unusual]\n"
            "c.csv:1: error: fifth [test-wrong]\n"
            "a.csv:1: warning: sixth [test-unusual]");
}

TEST(Diagnostics, StandWithGraveWarningsFirst) {
  Diagnostics diagnostics;
  diagnostics.Report(kUnusual, {"a.csv", 1}, {"second"});
  diagnostics.Report(kGrave, {"a.csv", 2});
  EXPECT_EQ(diagnostics.Format(),
            "a.csv:2: warning: this is grave [test-grave]\na.csv:1: warning: second [test-unusual]");
  diagnostics.Report(kWrong, {"a.csv", 3}, {"first"});
  std::vector<std::string> ids;
  for (const Diagnostic& item : diagnostics.ByWeight()) ids.push_back(item.id);
  EXPECT_THAT(ids, testing::ElementsAre("test-wrong", "test-grave", "test-unusual"));
}

const Finding kStill{"test-still", Severity::kWarning, "'{}' of '{}' stands still at {}", "check its cable"};
const Finding kLost{"test-lost", Severity::kError, "'{}' is lost"};

TEST(Diagnostics, OfOneCauseAreOneThatListsWhatItIsOf) {
  Diagnostics diagnostics;
  diagnostics.Report(kStill, {"a.yaml", 4}, {"x", "run1", "3 mm"});
  diagnostics.Report(kUnusual, {"a.yaml"}, {"between"});
  diagnostics.Report(kStill, {"a.yaml", 5}, {"y", "run1", "4 mm"});
  diagnostics.Report(kStill, {"a.yaml", 4}, {"x", "run2", "3 mm"});
  diagnostics.Report(kStill, {"a.yaml", 4}, {"x", "run2", "3 mm"});
  diagnostics.Report(kStill, {"b.yaml", 4}, {"x", "run1", "3 mm"});
  EXPECT_EQ(
      diagnostics.Format(),
      "a.yaml: warning: between [test-unusual]\n"
      "a.yaml:4: warning: 'x' of 'run1' stands still at 3 mm: check its cable; likewise 'y' of 'run1' (4 mm, line "
      "5) and 'x' of 'run2' [test-still]\n"
      "b.yaml:4: warning: 'x' of 'run1' stands still at 3 mm: check its cable [test-still]");
  EXPECT_EQ(diagnostics.ByWeight().size(), 3);
  // Those who count them have each.
  EXPECT_EQ(diagnostics.items().size(), 6);
}

const Finding kSwapped{"test-swapped", Severity::kWarning, "'{}' of '{}' is like '{}'"};

TEST(Diagnostics, OfOneCauseButAnotherRemedyStandAlone) {
  Diagnostics diagnostics;
  diagnostics.Report(kSwapped, {"a.yaml"}, {"x", "run", "y"});
  diagnostics.Report(kSwapped, {"a.yaml"}, {"y", "run", "x"});
  diagnostics.Report(kSwapped, {"a.yaml"}, {"z", "run", "x"});
  EXPECT_EQ(diagnostics.Format(),
            "a.yaml: warning: 'x' of 'run' is like 'y' [test-swapped]\n"
            "a.yaml: warning: 'y' of 'run' is like 'x'; likewise 'z' [test-swapped]");
}

const Finding kUnheard{"test-unheard", Severity::kWarning, "there is no '{}'{}"};
const Finding kShort{"test-short", Severity::kWarning, "{} of '{}' ends at {}"};

TEST(Diagnostics, OfOneCauseHaveNoHoles) {
  Diagnostics diagnostics;
  diagnostics.Report(kUnheard, {"a.yaml"}, {"x", ""});
  diagnostics.Report(kUnheard, {"a.yaml"}, {"leafs", ", did you mean 'leaf'?"});
  diagnostics.Report(kUnheard, {"a.yaml"}, {"z", ""});
  diagnostics.Report(kShort, {"b.yaml"}, {"heave", "rear", "3 mm"});
  diagnostics.Report(kShort, {"b.yaml"}, {"roll", "rear", "4 mm"});
  EXPECT_EQ(diagnostics.Format(),
            "a.yaml: warning: there is no 'x'; likewise 'leafs' (did you mean 'leaf'?) and 'z' [test-unheard]\n"
            "b.yaml: warning: heave of 'rear' ends at 3 mm; likewise roll, 4 mm [test-short]");
}

TEST(Diagnostics, OfManyChannelsAreCounted) {
  Diagnostics diagnostics;
  for (int i = 0; i < 40; ++i) diagnostics.Report(kLost, {"a.csv", 1}, {"x" + std::to_string(i)});
  EXPECT_THAT(diagnostics.Format(), EndsWith("'x23', 'x24' and 15 more [test-lost]"));
}

TEST(Diagnostics, ErrorsKeepTheirLines) {
  Diagnostics diagnostics;
  diagnostics.Report(kLost, {"a.csv", 4}, {"x"});
  diagnostics.Report(kLost, {"a.csv", 5}, {"y"});
  diagnostics.Report(kLost, {"a.csv", 5}, {"z"});
  EXPECT_EQ(diagnostics.Format(),
            "a.csv:4: error: 'x' is lost [test-lost]\na.csv:5: error: 'y' is lost; likewise 'z' [test-lost]");
}

TEST(Diagnostics, AreEmptyTextWhenThereAreNone) { EXPECT_EQ(Diagnostics().Format(), ""); }

TEST(Diagnostics, OfOneFileDoNotBuryThoseOfAnother) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 103; ++line) diagnostics.Report(kWrong, {"a.csv", line}, {"wrong"});
  diagnostics.Report(kWrong, {"b.csv", 1}, {"wrong"});
  EXPECT_THAT(diagnostics.Format(),
              EndsWith("a.csv:100: error: wrong [test-wrong]\na.csv: 3 more\nb.csv:1: error: wrong [test-wrong]"));
}

TEST(Diagnostics, OfOneFileAreAllShownUpToAHundred) {
  Diagnostics diagnostics;
  for (int line = 1; line <= 100; ++line) diagnostics.Report(kWrong, {"a.csv", line}, {"wrong"});
  EXPECT_THAT(diagnostics.Format(), EndsWith("a.csv:100: error: wrong [test-wrong]"));
}

TEST(Diagnostics, KeepBeginningAndEndOfMessagesOfMegabytes) {
  Diagnostics diagnostics;
  diagnostics.Report(kWrong, {"a.csv", 1}, {"unknown '" + std::string(5'000'000, 'n') + "'; remove it"});
  EXPECT_LT(diagnostics.Format().size(), 2100u);
  EXPECT_THAT(diagnostics.Format(), testing::StartsWith("a.csv:1: error: unknown 'nnn"));
  EXPECT_THAT(diagnostics.Format(), EndsWith("nnn'; remove it [test-wrong]"));
}

TEST(FaultyInput, SaysWhatTheDiagnosticsSay) {
  Diagnostics diagnostics;
  diagnostics.Report(kWrong, {"a.csv", 2}, {"wrong"});
  const FaultyInput error(diagnostics);
  EXPECT_STREQ(error.what(), "a.csv:2: error: wrong [test-wrong]");
  EXPECT_EQ(error.diagnostics().items().size(), 1);
}

}  // namespace
}  // namespace fourpost::diagnostics_test
