#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "felt/session/event.h"

namespace felt {

/// Records the input of a session: every event, and every pen sample with its exact numbers. If the
/// recording is passed to another session, directly or via a file, the result is the same document.
///
///   Recorder recorder([&](std::span<const Event> events) { ...append_event_line... });
///   options.on_event = std::ref(recorder);
///   ...
///   recorder.flush();
///
/// Memory is bounded: the events go to the sink in batches, in order. If an event has an earlier
/// time than the event before it (for example because pen samples waited in a queue), it gets the
/// time of the event before it, because times in a script must not run backwards. Use it on the
/// edit thread only.
class Recorder {
 public:
  using Sink = std::function<void(std::span<const Event>)>;

  explicit Recorder(Sink sink, std::size_t batch = 1024)
      : sink_(std::move(sink)), batch_(std::max<std::size_t>(batch, 1)) {
    held_.reserve(batch_);
  }

  void operator()(const Event& event) {
    last_ns_ = std::max(last_ns_, event.time_ns);
    held_.push_back(event);
    held_.back().time_ns = last_ns_;
    if (held_.size() >= batch_) flush();
  }

  /// Passes the buffered events to the sink.
  void flush() {
    if (!held_.empty()) sink_(held_);
    held_.clear();
  }

 private:
  Sink sink_;
  std::size_t batch_;
  std::vector<Event> held_;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt
