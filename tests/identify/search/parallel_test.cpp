#include "identify/search/parallel.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fourpost::parallel_test {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(Parallel, OneThreadWorksInOrderOnItsOwn) {
  std::vector<std::size_t> order;
  const std::thread::id here = std::this_thread::get_id();
  ForEachInParallel(2, 1, [&](std::size_t i) {
    ForEachOnIdleThreads(2, [&](std::size_t part) {
      EXPECT_EQ(std::this_thread::get_id(), here);
      order.push_back(10 * i + part);
    });
  });
  EXPECT_THAT(order, ElementsAre(0, 1, 10, 11));
}

// Each part waits until the other one has begun.
TEST(Parallel, PartsOfALoneBodyGoToIdleThreads) {
  std::atomic<int> begun = 0;
  std::atomic<bool> met = true;
  ForEachInParallel(1, 2, [&](std::size_t) {
    ForEachOnIdleThreads(2, [&](std::size_t) {
      ++begun;
      const auto start = std::chrono::steady_clock::now();
      while (begun < 2 && met)
        if (std::chrono::steady_clock::now() - start > std::chrono::seconds(20)) met = false;
    });
  });
  EXPECT_TRUE(met);
}

TEST(Parallel, PartsOfManyBodiesAreAllDone) {
  std::vector<std::atomic<int>> done(64);
  ForEachInParallel(8, 2,
                    [&](std::size_t i) { ForEachOnIdleThreads(8, [&](std::size_t part) { ++done[8 * i + part]; }); });
  EXPECT_THAT(std::vector<int>(done.begin(), done.end()), Each(1));
}

TEST(Parallel, WhatAPartThrowsArrives) {
  const auto fail = [](std::size_t part) {
    if (part == 1) throw std::runtime_error("part");
  };
  for (const int threads : {1, 2})
    EXPECT_THROW(ForEachInParallel(1, threads, [&](std::size_t) { ForEachOnIdleThreads(2, fail); }),
                 std::runtime_error);
}

}  // namespace
}  // namespace fourpost::parallel_test
