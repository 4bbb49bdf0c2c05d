#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/formats/drawing_reader.h"
#include "felt/session/player.h"
#include "felt/session/session.h"
#include "felt/stroke/fit/width_map.h"
#include "replay_settings.h"
#include "replay_stats.h"

namespace felt::cli {

/// What a tick looks like from outside.
struct ReplayTick {
  const TickReport& report;
  std::optional<double> pressure;  ///< 0..1, what decides the width
  std::optional<double> width_mm;  ///< of the ink at the pen; none while there is none
};

/// Device, hand, loop, tools and document in one: events go in, are played on a virtual clock, and
/// what happens is counted. The same events give the same ticks and the same document.
///
/// An event that the session would refuse is an error when it is added. Events are kept until
/// `play`, after which the loop starts anew with what follows.
class ReplayMachine {
 public:
  struct Observer {
    std::function<Result<void>(const ReplayTick&)> tick{};  ///< an error ends the play
    std::function<void(const Event&)> event{};              ///< all that the session is told
    /// Each 4 ms: how far the play is in what was added, 0..1.
    std::function<void(const Session& session, double fraction)> turn{};
    /// The play stops here, to 4 ms, in the middle of whatever is in work ...
    std::optional<std::int64_t> until_ns{};
    /// ... and this sees what is in work, before it is ended as when a script ends.
    std::function<void(const Session& session, const PenSample& pen)> stopped{};
  };

  ReplayMachine(const ReplaySettings& settings, Document document, Observer observer);
  ReplayMachine(const ReplayMachine&) = delete;
  ReplayMachine& operator=(const ReplayMachine&) = delete;

  /// Sets an option before the first event, "pencil.snap" to "off" or "sheet.material" to "felt":
  /// the text is read as the kind of value that the option has.
  Result<void> set_option(const std::string& id, const std::string& text);

  /// The next event; times never run backwards. An import's path must be one that can be opened.
  Result<void> add(const Event& event);
  /// The next events draw a stroke ...
  void begin_stroke();
  /// ... of this path: what comes of it is compared with the path. Elsewhere the hand means its
  /// aims while it presses.
  void stroke_drawn(const std::vector<Point>& meant);
  /// So many events wait that they should be played as soon as the hand is in the air.
  [[nodiscard]] bool is_full() const noexcept;
  /// Plays what was added; nothing any more once it was stopped.
  Result<void> play();
  /// When the next event may come.
  [[nodiscard]] std::int64_t next_ns() const noexcept { return next_ns_; }

  /// What was counted since the last call, but for the wall time; strokes and segments are those of
  /// the document as it is.
  ReplayStats take_stats();

  /// How the hand draws with what has been chosen so far: friction and stiffness of the sheet.
  [[nodiscard]] HandScriptOptions hand_options() const;
  [[nodiscard]] const Session& session() const noexcept { return session_; }

 private:
  /// A path that the hand meant to draw, from when to when.
  struct Meant {
    std::int64_t start_ns = 0;
    std::vector<Point> path;
  };
  struct Ink {
    std::int64_t time_ns = 0;
    Stroke stroke;
  };

  [[nodiscard]] PlayerOptions player_options();
  /// True when the play is over.
  bool see_turn();
  void see_tick(const TickReport& report);
  void see_edit(const Edit& edit);
  void note_aim(std::int64_t time_ns, const HandEvent& aim);
  void compare_ink();
  std::optional<double> width_at(const TickReport& report, std::optional<double> pressure);

  ReplaySettings settings_;
  Observer observer_;
  SimulatedStylus stylus_;
  Session session_;
  Session probe_;  // knows tools and options only: says beforehand what the session would refuse
  Player player_;
  std::vector<Event> events_;  // not played yet
  std::vector<Meant> meant_;   // likewise
  bool hand_is_down_ = false;
  bool in_stroke_ = false;
  std::vector<Ink> ink_;        // of this play
  std::set<StrokeId> changed_;  // since take_stats
  PenSample pen_;               // of the last tick
  bool is_stopped_ = false;
  std::int64_t next_ns_ = 0;
  bool pen_is_down_ = false;
  WidthMap widths_;
  Result<void> observed_;  // the observer's first error
  ReplayStats stats_;
};

/// The strokes of a sketch file: .ndjson, .felt (of visible layers), .svg of ours. Messages begin
/// with "PATH:LINE: " or "PATH: ".
Result<Sketch> read_sketch(const std::string& path);

/// The same as a drawing: of a .felt file as it is, layers, ids and materials included; of lines
/// one layer.
Result<OpenedDrawing> read_start(const std::string& path);

}  // namespace felt::cli
