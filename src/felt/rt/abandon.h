#pragma once

#include <tuple>
#include <utility>
#include <vector>

namespace felt {

/// Keeps these objects, passed as unique_ptrs, until the program ends and never accesses them
/// again. Use it if a thread still uses the objects because it hangs in a call of the vendor's
/// driver, which may return at any time (RealtimeThread::stop() returned false). The leak is
/// intended. Edit thread only.
///
///   if (!thread_->stop()) abandon(std::move(thread_), std::move(servo_), std::move(device_));
template <class... Owned>
void abandon(Owned&&... owned) {
  // The objects stay reachable and are never freed, so leak checkers report nothing.
  static auto* const kKept = new std::vector<void*>();
  kKept->push_back(new std::tuple<std::decay_t<Owned>...>(std::forward<Owned>(owned)...));
}

}  // namespace felt
