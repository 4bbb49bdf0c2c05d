#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "felt/document/visible_strokes.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"

namespace felt {

struct PlayerOptions {
  /// Loop period, 0.2..4 ms (R50).
  std::int64_t period_ns = 1'000'000;
  /// Interval at which the player does the work of the edit thread: it drains the loop's samples
  /// and publishes a force (docs/design/loop.md#data-flow, step 6). At least one period.
  std::int64_t edit_period_ns = 4'000'000;
  /// If true, arms the loop at the start. If false, the same script is played without any force
  /// (R51).
  bool forces = true;
  /// The user's force limit, 0..3 N.
  double force_limit_n = 3.0;
  /// Maximum duration of a script from first to last event. A longer script is an error.
  std::int64_t longest_ns = std::int64_t{24} * 3600 * 1'000'000'000;

  /// Called at each tick of the loop, for example to write the CSV file of forces or to make plots.
  std::function<void(const TickReport&)> on_tick = {};
  /// Reads the strokes and fills that an import event names. Without it, import events are errors.
  std::function<Result<VisibleInk>(const ImportEvent&)> read_import = {};
  /// Called every edit_period_ns. If it returns true, the play ends with the ink drawn so far.
  std::function<bool()> is_cancelled = {};
};

/// The results of a play, in numbers that do not depend on the machine.
struct PlayReport {
  std::uint64_t ticks = 0;
  std::uint64_t samples = 0;  ///< pen samples that the session processed
  std::uint64_t events = 0;   ///< events of the script, including poses
  std::uint64_t edits = 0;    ///< edits of the document, including those of undo and redo
  std::uint64_t turns = 0;    ///< how often the work of the edit thread was done (edit_period_ns)
  std::uint64_t unread = 0;   ///< ticks whose sample could not be read or was not accepted
  std::int64_t start_ns = 0;  ///< time of the first tick
  std::int64_t end_ns = 0;    ///< time of the last tick
  double largest_asked_n = 0.0;
  double largest_sent_n = 0.0;
  SafetyReport safety;  ///< the safety report at the end
  bool cancelled = false;

  friend bool operator==(const PlayReport&, const PlayReport&) = default;
};

/// Plays a script on a virtual clock: its poses go through the device and the haptic loop, and all
/// other events go directly to the session (decision 0006). It is deterministic: the same script,
/// device and options give the same document, report and forces, byte for byte.
///
///   SimulatedStylus stylus(...);
///   Session session(make_tools(), {.device = stylus.capabilities()});
///   Player player(stylus, &stylus, session, {});
///   const Result<PlayReport> report = player.play(events);
///
/// docs/formats/events.md defines the poses between events and when the other events take effect.
/// After the last event the pen is lifted, a gesture that is still in progress is committed
/// (Session::finish), forces are switched off and the device is stopped.
///
/// If the script moves the pen (pen events), the pen draws even if the safety chain rejects its
/// jumps, so that the document is the same with and without forces.
class Player {
 public:
  /// Makes a player. Device, hand and session must outlive it. `hand` is usually the device itself,
  /// or null if no hand is simulated.
  Player(Device& device, HandInput* hand, Session& session, PlayerOptions options);

  /// Plays the whole script. It may be called again: the next script continues with the current
  /// state of the session, on a new loop.
  ///
  /// Fails before playing if times run backwards, the script is too long, or it has hand events but
  /// the player has no hand. Fails at an event that the session refuses, and ends the play there:
  /// "event 12, at 80 ms: no tool ...".
  Result<PlayReport> play(std::span<const Event> events);

 private:
  class Run;

  Device& device_;
  HandInput* hand_;
  Session& session_;
  PlayerOptions options_;
};

}  // namespace felt
