#include "analysis/text/unit_spelling.h"

#include <gtest/gtest.h>

#include "analysis/text/units.h"

namespace fourpost::unit_spelling_test {
namespace {

TEST(UnitSpelling, OfWordsIsShort) {
  const struct {
    const char* text;
    const char* shorter;
  } cases[] = {{"inches", "in"},
               {"Newtons", "N"},
               {"METERS/second^2", "m/s^2"},
               {"feet/Second", "ft/s"},
               {"degrees/s", "deg/s"},
               {"percent", "%"},
               {"mm", "mm"},
               {"lbs", "lbs"},
               {"furlong", "furlong"},
               {"", ""}};
  for (const auto& [text, shorter] : cases) EXPECT_EQ(WithShortNames(text), shorter);
}

TEST(UnitSpelling, HintsAtWhatWasMeant) {
  const struct {
    const char* text;
    const char* hint;
  } cases[] = {{"KN", ", did you mean 'kN'?"},
               {"5 MM", ", did you mean 'mm'?"},
               {"Inches", ", did you mean 'in'?"},
               {"N-m", ", did you mean 'N*m'?"},
               {"M/S^2", ", did you mean 'm/s^2'?"},
               {"lb", ": pounds are a mass or a force, write 'lbm' or 'lbf'"},
               {"200 Pounds", ": pounds are a mass or a force, write 'lbm' or 'lbf'"},
               {"lbs/inch", ": pounds are a mass or a force, write 'lbm/in' or 'lbf/in'"},
               {"ft-lb", ": pounds are a mass or a force, write 'ft*lbm' or 'ft*lbf'"}};
  for (const auto& [text, hint] : cases) EXPECT_EQ(UnitHint(text), hint) << text;
}

// Nor at what is a unit already, such as a mega newton.
TEST(UnitSpelling, DoesNotGuess) {
  for (const char* text : {"", "5", "V", "furlong", "mm", "MN", "mN", "3 kN/m", "lbx", "-", "m-"})
    EXPECT_EQ(UnitHint(text), "") << text;
}

}  // namespace
}  // namespace fourpost::unit_spelling_test
