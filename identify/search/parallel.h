#pragma once

#include <cstddef>
#include <functional>

namespace fourpost {

/// `threads`, or one per processor for 0. Throws std::invalid_argument for less.
int ThreadCount(int threads);

/// Calls body(0) .. body(count - 1), up to `threads` of them at once, each as soon as a thread is free: their times may
/// differ widely. In order, and on the calling thread, for one thread.
void ForEachInParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// To be called from a body of ForEachInParallel(): calls body(0) .. body(count - 1), some of them on threads of that
/// loop which have nothing left to do. The calling thread takes up nothing else meanwhile.
void ForEachOnIdleThreads(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace fourpost
