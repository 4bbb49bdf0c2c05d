#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "console.h"
#include "felt/base/result.h"
#include "felt/devices/simulated/hand_script.h"
#include "felt/io/events/event_reader.h"
#include "tremor.h"

namespace felt::cli {

/// What to do with a script.
struct FeedSink {
  /// The next thing that happens; times never run backwards, over all scripts.
  std::function<Result<void>(const Event&)> event;
  /// The next events draw a raw stroke. May be null.
  std::function<void()> stroke_begins{};
  /// All events of a raw stroke went out, and the hand has lifted the pen: `meant` is its path in
  /// mm. May be null.
  std::function<Result<void>(const std::vector<Point>& meant)> stroke_drawn{};
  /// How the hand draws raw strokes now, with the tool and sheet in use. May be null: then as the
  /// options say.
  std::function<HandScriptOptions()> hand{};
};

struct FeedOptions {
  double mm_per_unit = 1.0;
  /// How the hand draws raw strokes.
  HandScriptOptions hand;
  std::uint64_t seed = 0;  ///< of a tremor of its own; 0 = none
};

/// Reads scripts, events and raw strokes in any order, and gives events in the order of time.
///
/// A raw stroke is drawn when what stands before it is done: the hand moves there through the air,
/// lands, draws at the recorded pace, lifts. An event that follows comes at its own time, or when
/// the stroke is done where that is later. Times of a second script count from the end of the
/// first. Memory is that of the longest stroke.
class ScriptFeed {
 public:
  ScriptFeed(const FeedOptions& options, FeedSink sink);

  /// Reads a script through; its name is for errors. Stops at the first one, "NAME:LINE: reason".
  Result<void> read(const std::string& name, ReadBytes read);
  /// The loop starts afresh with the next event, which comes at this time or later: the hand waits
  /// above the first stroke until forces have faded in, so that this one feels like the others.
  void begin_play(std::int64_t from_ns) noexcept;
  /// Before a play: the hand that drew raw strokes stays a while, so that the pen, which follows
  /// it, comes to rest too.
  Result<void> rest();

  /// Time of the last event given.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] std::int64_t stroke_count() const noexcept { return strokes_; }

 private:
  Result<void> take_event(const Event& event);
  Result<void> take_stroke(const RawStroke& stroke);
  Result<void> travel_to(const Vec3& target);
  Result<void> put(const TimedAim& aim, std::int64_t start_ns);

  FeedOptions options_;
  FeedSink sink_;
  Tremor tremor_;
  std::int64_t file_start_ns_ = 0;  // of the times in this script
  std::int64_t now_ns_ = 0;
  std::optional<Vec3> hand_;  // where it was sent last
  std::int64_t strokes_ = 0;
  bool is_fresh_ = true;
};

}  // namespace felt::cli
