#pragma once

#include <tuple>
#include <utility>
#include <vector>

namespace felt {

/// Keeps these, their owners' unique_ptrs, for the life of the program and never touches them
/// again: a thread that hangs in a maker's call still uses them, and may come back at any time
/// (RealtimeThread::stop() that was false). Whoever gives something away here has lost it on
/// purpose. Edit thread.
///
///   if (!thread_->stop()) abandon(std::move(thread_), std::move(servo_), std::move(device_));
template <class... Owned>
void abandon(Owned&&... owned) {
  // Reachable and never freed: a tool that looks for leaks has nothing to say.
  static auto* const kKept = new std::vector<void*>();
  kKept->push_back(new std::tuple<std::decay_t<Owned>...>(std::forward<Owned>(owned)...));
}

}  // namespace felt
