#include "analysis/text/utf8.h"

#include <gtest/gtest.h>

namespace fourpost::utf8_test {
namespace {

TEST(ValidUtf8, LeavesCharactersOfAnyLengthAsTheyAre) {
  for (const char* text : {"", "plain", "Stoßdämpfer", "\u0080\u07FF\u0800\uD7FF\uE000\uFFFF\U00010000\U0010FFFF"})
    EXPECT_EQ(ValidUtf8(text), text);
  EXPECT_EQ(ValidUtf8(std::string_view("a\0b", 3)), std::string("a\0b", 3));
}

TEST(ValidUtf8, ReplacesEachByteThatBelongsToNone) {
  EXPECT_EQ(ValidUtf8("Sto\xDF"
                      "d\xE4mpfer"),
            "Sto\uFFFDd\uFFFDmpfer");
  // A lonely end, a beginning alone, an end too few.
  EXPECT_EQ(ValidUtf8("\x80|\xC3|\xE2\x82"), "\uFFFD|\uFFFD|\uFFFD\uFFFD");
  // '/' in two bytes, half of a surrogate pair, beyond Unicode.
  EXPECT_EQ(ValidUtf8("\xC0\xAF"), "\uFFFD\uFFFD");
  EXPECT_EQ(ValidUtf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(ValidUtf8("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(Utf8OfEither, TakesOtherTextForLatin1) {
  EXPECT_EQ(Utf8OfEither("Kraftme\u00DFdose"), "Kraftme\u00DFdose");
  EXPECT_EQ(Utf8OfEither("Kraftme\xDF"
                         "dose \xB0"
                         "C"),
            "Kraftme\u00DFdose \u00B0C");
}

}  // namespace
}  // namespace fourpost::utf8_test
