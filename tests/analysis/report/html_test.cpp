#include "analysis/report/html.h"

#include <gmock/gmock.h>

#include "analysis/files/sha256.h"
#include "analysis/report/report_document.h"

namespace fourpost::html_test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kHostile = "</script><b a='x' c=\"y\">&";

TEST(Html, EscapesText) {
  EXPECT_EQ(html::Escaped(kHostile), "&lt;/script&gt;&lt;b a=&#39;x&#39; c=&quot;y&quot;&gt;&amp;");
  EXPECT_EQ(html::Escaped(std::string("a\x01\tb\nc")), "a  b\nc");
  EXPECT_EQ(html::TextCell("<i>").html, "&lt;i&gt;");
}

TEST(Html, IsValidUtf8WhateverTheText) { EXPECT_EQ(html::Escaped("Sto\xDF <"), "Sto\uFFFD &lt;"); }

TEST(Html, JsonCannotEndItsElement) {
  EXPECT_EQ(html::ScriptJson(R"({"a":"</script><!--&"})"), R"({"a":"\u003c/script\u003e\u003c!--\u0026"})");
}

TEST(Html, APictureEscapesAllThatCouldEndIt) {
  EXPECT_EQ(
      html::Picture("<svg a='1'>%\"</svg>", "a \"b\""),
      "<img class=\"still\" alt=\"a &quot;b&quot;\" src=\"data:image/svg+xml,%3Csvg a=%271%27%3E%25%22%3C/svg%3E\">\n");
}

TEST(Html, TableHasAClassPerColumnInItsHead) {
  const std::string table = html::Table({"name", "mass"}, {{html::TextCell("body"), html::NumberCell("7")}});
  EXPECT_THAT(table, HasSubstr("<th scope=\"col\">name</th><th scope=\"col\" class=\"n\">mass</th>"));
  EXPECT_THAT(table, HasSubstr("<td>body</td><td class=\"n\">7</td>"));
}

TEST(ReportDocument, HoldsAllItNeedsAndFetchesNothing) {
  const std::string page = ReportDocument(kHostile, "<main></main>", R"({"name":"</script>"})");
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  // The script is named by its digest, so that no other one runs.
  const std::size_t script = page.find("<script>") + 8;
  Sha256 digest;
  digest.AddBytes(std::string_view(page).substr(script, page.rfind("</script>") - script));
  EXPECT_THAT(page, HasSubstr("; script-src 'sha256-" + digest.Base64() + "';"));
  EXPECT_THAT(page, HasSubstr("id=\"data\">{\"name\":\"\\u003c/script\\u003e\"}</script>"));
  // The scripts' licences and the style.
  EXPECT_THAT(page, HasSubstr("three.js authors"));
  EXPECT_THAT(page, HasSubstr(".u-over"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  // One end for each of the two scripts: of the data and of what draws them.
  std::size_t ends = 0;
  for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++ends;
  EXPECT_EQ(ends, 2u);
  // Fixed parts of a page are bounded.
  EXPECT_LT(page.size(), 250'000u);
}

TEST(ReportDocument, NamesTheScriptThatDrawsAVehicleOnlyWhereOneIsDrawn) {
  EXPECT_THAT(ReportDocument("car", "", "{}"), Not(HasSubstr("id=\"stage\"")));
  const std::string page = ReportDocument("car", "", "{}", {.draws_vehicle = true});
  EXPECT_THAT(page, HasSubstr("id=\"stage\">H4sI"));
  EXPECT_THAT(page, ContainsRegex("script-src 'sha256-[^']*' 'sha256-[^']*';"));
  EXPECT_LT(page.size(), 420'000u);
}

TEST(ReportDocument, AllowsWebAssemblyOnlyWhereItHasSome) {
  EXPECT_THAT(ReportDocument("car", "", "{}"), Not(HasSubstr("wasm")));
  const std::string page = ReportDocument("car", "", "{}", {.live = "H4sI"});
  EXPECT_THAT(page, HasSubstr("' 'wasm-unsafe-eval'; style-src"));
  EXPECT_THAT(page, HasSubstr("id=\"program\">H4sI</script>"));
}

}  // namespace
}  // namespace fourpost::html_test
