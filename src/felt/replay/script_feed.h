#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/geometry/point.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/import.h"

namespace felt {

/// Receives the content of a script. All functions except `event` may be null.
struct FeedSink {
  /// Handles the next event. Times never decrease, even across scripts.
  std::function<Result<void>(const Event&)> event;
  /// Called before the events of a raw stroke.
  std::function<void()> stroke_begins{};
  /// Called after all events of a raw stroke were sent and the hand has lifted the pen. `meant` is
  /// the path of the stroke in mm.
  std::function<Result<void>(const std::vector<Point>& meant)> stroke_drawn{};
  /// Returns how the hand draws raw strokes with the current tool and surface. If null,
  /// FeedOptions::hand is used.
  std::function<HandScriptOptions()> hand{};
};

struct FeedOptions {
  double mm_per_unit = 1.0;
  /// How the hand draws raw strokes.
  HandScriptOptions hand;
  std::uint64_t seed = 0;  ///< seed of a Tremor; 0 = no tremor
};

/// Physiological tremor: a displacement of 0.03 mm rms on each axis at 8 to 12 Hz. It depends only
/// on the seed. Seed 0 means no tremor.
class Tremor {
 public:
  explicit Tremor(std::uint64_t seed);
  /// Returns the displacement at a time, in mm.
  [[nodiscard]] Vec at(std::int64_t time_ns) const noexcept;

 private:
  struct Tone {
    double hz = 0.0, phase_x = 0.0, phase_y = 0.0;
  };
  std::array<Tone, 5> tones_;
  double amplitude_mm_ = 0.0;
};

/// Reads scripts, with events and raw strokes in any order, and sends events in order of time.
///
/// A raw stroke is drawn after all earlier events and strokes: the hand moves to its start above
/// the surface, lands, draws at the recorded speed, and lifts the pen. An event that follows the
/// stroke in the script is sent at its own time, but not before the stroke has ended. The times in
/// each further script are relative to the end of the script before it. Memory use is proportional
/// to the longest stroke.
class ScriptFeed {
 public:
  ScriptFeed(const FeedOptions& options, FeedSink sink);

  /// Reads a whole script. `name` is used in errors. Stops at the first error, "NAME:LINE: reason".
  Result<void> read(const std::string& name, ReadBytes read);
  /// Call it when the loop starts again; the next event comes at `from_ns` or later. The hand waits
  /// above the first stroke until forces have faded in, so that the force is the same as for other
  /// strokes.
  void begin_play(std::int64_t from_ns) noexcept;
  /// Lets the hand rest for a moment after raw strokes, so that the pen, which follows it, comes to
  /// rest, too. Call it before a play.
  Result<void> rest();

  /// Returns the faults of the samples of raw strokes in the last script. Pressures count as 0 or
  /// 1; a stroke with times that are not those of a pen is drawn as if it had none.
  [[nodiscard]] const ImportReport& report() const noexcept { return report_; }
  /// Returns the time of the last event sent.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] std::int64_t stroke_count() const noexcept { return strokes_; }

 private:
  Result<void> add_event(const Event& event);
  RecordedPath path_of(const RawStroke& stroke);
  Result<void> add_stroke(const RawStroke& stroke);
  Result<void> travel_to(const Vec3& target);
  Result<void> put(const TimedAim& aim, std::int64_t start_ns);

  FeedOptions options_;
  FeedSink sink_;
  Tremor tremor_;
  std::int64_t file_start_ns_ = 0;  // the time to which the times in this script are relative
  std::int64_t now_ns_ = 0;
  std::optional<Vec3> hand_;  // the last aim
  std::int64_t strokes_ = 0;
  std::int64_t file_strokes_ = 0;  // of the current script
  ImportReport report_;
  bool is_fresh_ = true;
};

}  // namespace felt
