#include "identify/run/remade_study.h"

#include <gtest/gtest.h>

namespace fourpost::remade_study_test {
namespace {

Addition Offered(const std::string& mechanism, const std::string& words, int variant) {
  return {.mechanism = mechanism, .elements = {"damper"}, .words = words, .variant = variant};
}

GrowthAddition Wanted(const std::string& mechanism, const std::string& words, int variant) {
  return {.words = words, .mechanism = mechanism, .elements = {"damper"}, .variant = variant};
}

TEST(RemadeStudy, MakesTheSameOfSeveralAlternatives) {
  const std::vector<Addition> offered = {Offered("friction", "beside", 0), Offered("knee", "both", 0),
                                         Offered("knee", "bump", 1), Offered("knee", "both", 2)};
  EXPECT_EQ(PlaceOf(Wanted("knee", "both", 0), offered), 1u);
  EXPECT_EQ(PlaceOf(Wanted("knee", "both", 2), offered), 3u);
  EXPECT_EQ(PlaceOf(Wanted("knee", "bump", 1), offered), 2u);
  EXPECT_EQ(PlaceOf(Wanted("stop", "bump", 1), offered), std::nullopt);
  GrowthAddition elsewhere = Wanted("knee", "both", 0);
  elsewhere.elements = {"other"};
  EXPECT_EQ(PlaceOf(elsewhere, offered), std::nullopt);
}

// Friction behind a mount was the only one to be added while there was friction beside it.
TEST(RemadeStudy, KnowsAnAlternativeByItsWordsWhereOthersAreOfferedBeforeIt) {
  const std::vector<Addition> offered = {Offered("friction", "beside", 0), Offered("friction", "behind", 1)};
  EXPECT_EQ(PlaceOf(Wanted("friction", "behind", 0), offered), 1u);
}

// The second part on mounts is the first where the other is taken back; a mount has no friction to take along.
TEST(RemadeStudy, TakesTheOneThatIsLeft) {
  EXPECT_EQ(PlaceOf(Wanted("part", "second", 1), {Offered("part", "first", 0), Offered("part", "first", 1)}), 1u);
  EXPECT_EQ(PlaceOf(Wanted("mount", "with friction", 1), {Offered("mount", "alone", 0)}), 0u);
}

}  // namespace
}  // namespace fourpost::remade_study_test
