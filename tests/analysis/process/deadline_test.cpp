#include "analysis/process/deadline.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "analysis/process/thread_time.h"

namespace fourpost::deadline_test {
namespace {

TEST(Deadline, PassesInItsTime) {
  const auto start = std::chrono::steady_clock::now();
  const Deadline deadline = Deadline::In(0.02);
  EXPECT_NO_THROW(Deadline::In(60).Check());
  while (!deadline.HasPassed()) continue;
  // A thread computes no longer than it lasts; 500 ppm is the most by which the system's clock is steered.
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::microseconds(19'990));
  EXPECT_THROW(deadline.Check(), TimedOut);
}

TEST(Deadline, DoesNotPassWhileTheThreadWaits) {
  const Deadline deadline = Deadline::In(0.1);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  EXPECT_FALSE(deadline.HasPassed());
}

// As Ctrl-Z and fg do.
TEST(Deadline, DoesNotPassWhileTheProcessIsStopped) {
  const pid_t child = fork();
  if (child == 0) {
    const Deadline deadline = Deadline::In(0.1);
    std::raise(SIGSTOP);
    _exit(deadline.HasPassed() ? 1 : 0);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, WUNTRACED), child);
  ASSERT_TRUE(WIFSTOPPED(status));
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  ASSERT_EQ(kill(child, SIGCONT), 0);
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

// Threads share a process, and what one computes is not another's.
TEST(Deadline, DoesNotPassWhileAnotherThreadComputes) {
  const Deadline deadline = Deadline::In(0.1);
  std::thread([] {
    const Deadline longer = Deadline::In(0.15);
    while (!longer.HasPassed()) continue;
  }).join();
  EXPECT_FALSE(deadline.HasPassed());
}

TEST(Deadline, NeverPassesUnlessTold) {
  EXPECT_FALSE(Deadline().HasPassed());
  EXPECT_FALSE(Deadline::In(std::numeric_limits<double>::infinity()).HasPassed());
  EXPECT_FALSE(Deadline::In(1e300).HasPassed());
}

TEST(Deadline, RefusesTheNoTimeAndTheNotANumber) {
  EXPECT_THROW(Deadline::In(0), std::invalid_argument);
  EXPECT_THROW(Deadline::In(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

// Parts on two threads, one after the other.
TEST(SharedDeadline, HasLeftWhatPartsThatEndedDidNotTake) {
  SharedDeadline shared(Deadline::In(0.2));
  std::thread([&] {
    const double began_s = ThreadTime_s();
    const Deadline most = shared.Begin();
    for (const Deadline some = Deadline::In(0.15); !some.HasPassed();) EXPECT_FALSE(most.HasPassed());
    shared.End(began_s);
  }).join();
  const Deadline rest = shared.Begin();
  const double began_s = ThreadTime_s();
  while (!rest.HasPassed()) continue;
  EXPECT_LE(ThreadTime_s() - began_s, 0.051);
  EXPECT_FALSE(SharedDeadline(Deadline()).Begin().HasPassed());
}

}  // namespace
}  // namespace fourpost::deadline_test
