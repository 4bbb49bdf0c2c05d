#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "felt/rt/servo.h"
#include "felt/session/session.h"

namespace felt {

struct PlayerOptions {
  /// Loop period, 0.2..4 ms (R50).
  std::int64_t period_ns = 1'000'000;
  /// How often the edit side drains the loop's samples and publishes a force (architecture section
  /// 4, step 6). At least one period.
  std::int64_t edit_period_ns = 4'000'000;
  /// Arms the loop at the start; off plays the same script without any force (R51).
  bool forces = true;
  /// The user's limit of the force, 0..3 N.
  double force_limit_n = 3.0;
  /// Longest script, first event to last; beyond it is an error.
  std::int64_t longest_ns = std::int64_t{24} * 3600 * 1'000'000'000;

  /// Sees each tick of the loop: for the CSV of forces and for plots.
  std::function<void(const TickReport&)> on_tick = {};
  /// Reads the strokes that an import event names. Without it, import events are errors.
  std::function<Result<std::vector<StrokePtr>>(const ImportEvent&)> read_import = {};
  /// Asked on each turn of the edit side; true ends the play there, with the ink so far.
  std::function<bool()> is_cancelled = {};
};

/// What happened, in numbers that do not depend on the machine.
struct PlayReport {
  std::uint64_t ticks = 0;
  std::uint64_t samples = 0;  ///< that the session was told
  std::uint64_t events = 0;   ///< of the script, poses included
  std::uint64_t edits = 0;    ///< that the document took, undo's and redo's too
  std::uint64_t turns = 0;    ///< of the edit side
  std::uint64_t unread = 0;   ///< ticks in which the device could not be read or believed
  std::int64_t start_ns = 0;  ///< of the first tick
  std::int64_t end_ns = 0;    ///< of the last
  double largest_asked_n = 0.0;
  double largest_sent_n = 0.0;
  SafetyReport safety;  ///< at the end
  bool cancelled = false;

  friend bool operator==(const PlayReport&, const PlayReport&) = default;
};

/// Plays a script: its poses through the device and the haptic loop, everything else to the
/// session, on a virtual clock (decision 0006). Deterministic: the same script, device and options
/// give the same document, report and forces, byte for byte.
///
///   SimulatedStylus stylus(...);
///   Session session(make_tools(), {.device = stylus.capabilities()});
///   Player player(stylus, &stylus, session, {});
///   const Result<PlayReport> report = player.play(events);
///
/// How poses come between events, and when the others take effect: docs/formats/events.md. After
/// the last event the pen is lifted; what gesture is in work even then is ended (Session::finish),
/// forces are switched off and the device is stopped.
///
/// A pen that the script moves (pen events) draws whatever the safety chain thinks of its jumps, so
/// that the document is the same with and without forces.
class Player {
 public:
  /// Device, hand and session must outlive this. `hand` is as a rule the device itself; null where
  /// there is none.
  Player(Device& device, HandInput* hand, Session& session, PlayerOptions options);

  /// Plays it all. May be called again: the next script goes on with the session as it is, on a
  /// loop of its own.
  ///
  /// Error: times that run backwards, a script that is too long, hand events without a hand; then
  /// nothing was played. Or an event that the session refuses: "event 12, at 80 ms: no tool ...";
  /// then the play ends there.
  Result<PlayReport> play(std::span<const Event> events);

 private:
  class Run;

  Device& device_;
  HandInput* hand_;
  Session& session_;
  PlayerOptions options_;
};

}  // namespace felt
