#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "desktop/engine/studio.h"
#include "felt/session/pose_track.h"

namespace felt::desktop {

/// Plays an event script (docs/formats/events.md) on a studio that is not live: hand poses go
/// through its device and its haptic loop, everything else is applied as events, at the pace of
/// advance(). Used for the guided tour and the pictures of the documents.
///
///   Studio studio({.device = "simulated:touch", .live = false});
///   ScriptPlayer player(studio);
///   if (player.load("1-pencil", text)) while (!player.is_over()) player.advance(16'000'000);
///
/// The studio must outlive this. Qt's main thread.
class ScriptPlayer {
 public:
  explicit ScriptPlayer(Studio& studio) : studio_(studio) {}

  /// Loads a script, to play from now on, on the present drawing. The error is "NAME:LINE: reason".
  Result<void> load(const QString& name, std::string_view text);
  /// Advances the time by this much, in ticks of 1 ms, or until the script ends.
  void advance(std::int64_t ns);
  /// Plays the rest without waiting.
  void finish();
  [[nodiscard]] bool is_over() const noexcept { return played_ns_ >= length_ns_; }
  [[nodiscard]] std::int64_t length_ns() const noexcept { return length_ns_; }
  [[nodiscard]] std::int64_t played_ns() const noexcept { return played_ns_; }

 private:
  void tick();

  Studio& studio_;
  std::vector<Event> events_;
  std::optional<PoseTrack> track_;
  std::size_t next_ = 0;  // of events_
  std::int64_t played_ns_ = 0;
  std::int64_t length_ns_ = 0;
};

}  // namespace felt::desktop
