#pragma once

#include <functional>
#include <optional>
#include <string>

namespace fourpost {

/// What `work` answers in a process of its own, so that a library that crashes or hangs on a damaged file takes nothing
/// else with it; nothing when it did, or took longer than a minute. `work` must not throw. Throws std::system_error
/// where the system gives no process.
std::optional<std::string> AnswerOfChild(const std::function<std::string()>& work);

}  // namespace fourpost
