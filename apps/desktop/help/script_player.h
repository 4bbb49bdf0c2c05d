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

/// Plays an event script (docs/formats/events.md) on a studio that is not live. The script's hand
/// poses move the studio's simulated hand; all other events are applied directly. The caller
/// determines the speed by its calls of advance(). Used for the guided tour and the pictures in the
/// documents.
///
///   Studio studio({.device = "simulated:touch", .live = false});
///   ScriptPlayer player(studio);
///   if (player.load("1-pencil", text)) while (!player.is_over()) player.advance(16'000'000);
///
/// The studio must outlive this object. Use it in Qt's main thread.
class ScriptPlayer {
 public:
  explicit ScriptPlayer(Studio& studio) : studio_(studio) {}

  /// Loads a script that starts now, on the present drawing. The error is "NAME:LINE: reason".
  Result<void> load(const QString& name, std::string_view text);
  /// Advances the time by `ns` in ticks of 1 ms, or until the script ends.
  void advance(std::int64_t ns);
  /// Plays the rest of the script without waiting.
  void finish();
  [[nodiscard]] bool is_over() const noexcept { return played_ns_ >= length_ns_; }
  [[nodiscard]] std::int64_t length_ns() const noexcept { return length_ns_; }
  [[nodiscard]] std::int64_t played_ns() const noexcept { return played_ns_; }

 private:
  void tick();

  Studio& studio_;
  std::vector<Event> events_;
  std::optional<PoseTrack> track_;
  std::size_t next_ = 0;  // index of the next event in events_
  std::int64_t played_ns_ = 0;
  std::int64_t length_ns_ = 0;
};

}  // namespace felt::desktop
