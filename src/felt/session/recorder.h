#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "felt/session/event.h"

namespace felt {

/// Keeps what a session receives, so that it can be played again: every event, every pen sample
/// with its exact numbers. Told to another session, or written, read and told, the same document
/// comes out.
///
///   Recorder recorder([&](std::span<const Event> events) { ...append_event_line... });
///   options.on_event = std::ref(recorder);
///   ...
///   recorder.flush();
///
/// Memory is bounded: whatever it holds goes to the sink in batches, in order. Times that run
/// backwards (an event that was made before samples that waited in the ring) are set to the last
/// one, for an order of its own is what a script has. Edit thread.
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

  /// Hands over what is held.
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
