#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/cue_law.h"
#include "felt/material/materials.h"
#include "felt/replay/replay_stats.h"
#include "felt/rt/device.h"
#include "felt/session/cue_watch.h"
#include "felt/session/player.h"
#include "felt/session/session.h"
#include "felt/stroke/fit/width_map.h"

namespace felt {

/// The simulated pen of a replay, the hand that holds it, and the settings of the loop.
struct ReplaySettings {
  StylusPreset device;
  SimulatedHand hand;
  /// If set, this person draws instead of `hand`, and corrects what the pen does (FeedbackHand).
  std::optional<Person> person{};
  bool force = true;  ///< if false, the loop sends no forces
  /// How the hand draws raw strokes.
  HandScriptOptions script;
  /// Surfaces and media that options may name.
  Materials materials = Materials::built_in();
  /// Reads the strokes of a drawing that a script imports. If null, an import is an error.
  std::function<Result<VisibleInk>(const std::string& path)> read_import{};
};

/// Returns the settings for a preset and a hand. `rate_hz` and `delay_ticks` default to the
/// device's values.
///
/// The workspace is unlimited in x and y, as if the paper were moved under the device. Without
/// force nothing stops the hand at the surface, so contact and width follow from the pressure of
/// the hand instead of its depth.
ReplaySettings replay_settings(const StylusPreset& device, const SimulatedHand& hand, bool force,
                               std::optional<double> rate_hz, std::optional<int> delay_ticks);

/// One tick of the loop, as an observer sees it.
struct ReplayTick {
  const TickReport& report;
  std::optional<double> pressure;  ///< 0..1, determines the width
  std::optional<double> width_mm;  ///< of the ink at the pen; empty if the pen leaves no ink
};

/// Device, hand, loop, tools and document in one object. It plays events on a virtual clock and
/// counts the results (ReplayStats). The same events give the same ticks and the same document.
///
/// Adding a tool, option, material, guide or import event fails if the session would refuse it;
/// other events are checked when they are played. Added events are queued until `play`. Events that
/// are added after a play are played on a new loop.
class ReplayMachine {
 public:
  struct Observer {
    std::function<Result<void>(const ReplayTick&)> tick{};  ///< an error ends the play
    /// Called for each event that the session handles.
    std::function<void(const Event&)> event{};
    /// Called every 4 ms with the progress through the added events, 0..1.
    std::function<void(const Session& session, double fraction)> turn{};
    /// If set, stops the play at this time, accurate to 4 ms, even in the middle of a gesture.
    std::optional<std::int64_t> until_ns{};
    /// Called when the play stops at `until_ns`. Afterwards the gesture in progress is ended, as it
    /// is at the end of a script.
    std::function<void(const Session& session, const PenSample& pen)> stopped{};
  };

  ReplayMachine(const ReplaySettings& settings, Document document, Observer observer);
  ReplayMachine(const ReplayMachine&) = delete;
  ReplayMachine& operator=(const ReplayMachine&) = delete;

  /// Sets an option before the first event, for example "pencil.snap" to "off" or
  /// "surface.material" to "felt". The text is parsed as the option's kind of value.
  Result<void> set_option(const std::string& id, const std::string& text);

  /// Adds the next event. Requires that times do not decrease. Fails if an import cannot be read.
  Result<void> add(const Event& event);
  /// Begins a stroke: the next events draw it.
  void begin_stroke();
  /// Ends the stroke. The ink of the stroke is compared with the path `meant`. Ink that belongs to
  /// no such stroke is compared with the positions at which the hand aims while it presses.
  void stroke_drawn(const std::vector<Point>& meant);
  /// Returns true if so many events are queued that they should be played as soon as the pen is
  /// lifted.
  [[nodiscard]] bool is_full() const noexcept;
  /// Plays the added events. Has no effect after a play was stopped (Observer::until_ns).
  Result<void> play();
  /// Returns the earliest time that the next event may have.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return next_ns_; }

  /// Returns the counts since the last call, without the wall time. `strokes` and `segments`
  /// describe the current document.
  ReplayStats take_stats();

  /// Returns how the hand draws on the current surface with the current medium.
  [[nodiscard]] HandScriptOptions hand_options() const;
  /// Returns the friction that a hand meets that presses with half of the firm push: that of the
  /// device and, with forces, that of the medium on the surface, N.
  [[nodiscard]] double expected_friction_n() const;
  [[nodiscard]] const Session& session() const noexcept { return session_; }

 private:
  /// A path that the hand intended to draw, with its time interval.
  struct Meant {
    std::int64_t start_ns = 0;
    std::vector<Point> path;
  };
  struct Ink {
    std::int64_t time_ns = 0;
    Stroke stroke;
  };

  [[nodiscard]] PlayerOptions player_options();
  /// Returns true when the play is over.
  bool handle_turn();
  void handle_tick(const TickReport& report);
  void count_cues();
  void handle_edit(const Edit& edit);
  void add_aim(std::int64_t time_ns, const HandEvent& aim);
  void await_preview();
  void compare_ink();
  std::optional<double> width_at(const TickReport& report, std::optional<double> pressure);

  ReplaySettings settings_;
  Observer observer_;
  HandInput* hand_ = nullptr;  // that of stylus_
  std::unique_ptr<Device> stylus_;
  std::int64_t preview_ns_ = 0;  // how much later than an event the hand carries it out
  Session session_;
  Session probe_;  // has tools and options only; finds events that the session would refuse
  Player player_;
  std::vector<Event> events_;  // added, and not played yet
  std::vector<Meant> meant_;   // paths of the events in events_
  bool hand_is_down_ = false;
  bool in_stroke_ = false;
  std::vector<Ink> ink_;        // the ink of this play
  std::set<StrokeId> changed_;  // since take_stats
  PenSample pen_;               // the pen at the last tick
  CueLaw cue_law_;              // of a device that plays cues
  CueWatch cue_watch_;
  bool is_stopped_ = false;
  std::int64_t next_ns_ = 0;
  bool pen_is_down_ = false;
  WidthMap widths_;
  Result<void> observed_;  // the observer's first error
  ReplayStats stats_;
};

}  // namespace felt
