#include "identify/report/report_tables.h"

#include <gmock/gmock.h>

namespace fourpost::report_tables_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ModeTable, ShowsTheThreeLargestSharesAndTheRestOnDemand) {
  nlohmann::json mode = {{"name", "heave"}, {"energy", nlohmann::json::array()}};
  for (const double share : {0.1, 0.4, 0.2, 0.15, 0.15})
    mode["energy"].push_back({{"motion", "body"}, {"share", share}});
  EXPECT_THAT(ModeTableHtml(nlohmann::json::array({mode})),
              AllOf(HasSubstr("body 40\u00a0%, body 20\u00a0%, body 15\u00a0% <details"),
                    HasSubstr("<summary>2 more</summary>")));
}

}  // namespace
}  // namespace fourpost::report_tables_test
