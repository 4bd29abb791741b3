#include "analysis/process/child_process.h"

#include <signal.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace fourpost::child_process_test {
namespace {

TEST(AnswerOfChild, IsWhatTheWorkAnswers) {
  EXPECT_EQ(AnswerOfChild([] { return std::string(); }), "");
  const std::string long_text(3'000'000, 'x');
  EXPECT_EQ(AnswerOfChild([&] { return long_text; }), long_text);
  const pid_t here = getpid();
  EXPECT_NE(AnswerOfChild([] { return std::to_string(getpid()); }), std::to_string(here));
}

TEST(AnswerOfChild, IsNothingOfWorkThatCrashes) {
  for (const int crash : {SIGSEGV, SIGABRT, SIGALRM}) {
    const auto work = [&] {
      kill(getpid(), crash);
      return std::string("alive");
    };
    EXPECT_EQ(AnswerOfChild(work), std::nullopt) << crash;
  }
}

}  // namespace
}  // namespace fourpost::child_process_test
