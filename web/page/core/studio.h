#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/pointer_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/drawing.h"
#include "felt/rt/servo.h"
#include "felt/session/pose_track.h"
#include "felt/session/session.h"

namespace felt::page {

/// A sample of a pointer, with its time on the clock of the caller.
struct PointerSample {
  std::int64_t time_ns = 0;
  Point position;
  bool touching = false;
  std::optional<double> pressure{}, tilt_deg{};
  std::uint32_t buttons = 0;
};

/// The newest sample that the session handled, where the pointer is, and the forces of the newest
/// tick.
struct PenState {
  bool is_known = false;
  PenSample sample;
  Point hand;
  Force asked, sent;
};

/// The drawing session of the page with its simulated pen and haptic loop, without threads: the
/// caller lets the time pass. Between two calls the loop is stepped once per millisecond of that
/// time, as the haptic thread of the desktop program does. The device "tablet" has no force: its
/// pen is exactly at the pointer.
class Studio {
 public:
  static constexpr std::string_view kTablet = "tablet";

  Studio();
  ~Studio();

  [[nodiscard]] const Session& session() const noexcept { return *session_; }
  [[nodiscard]] const Page& page() const noexcept { return page_; }
  void set_page(const Page& page);
  /// What the session does not use of the drawing that it began with, and a file keeps.
  struct Carried {
    Palette palette;
    std::optional<Viewport> view;
    std::shared_ptr<const DrawingExtras> extras;
    std::shared_ptr<const StrokeNames> names;
  };
  [[nodiscard]] const Carried& carried() const noexcept { return carried_; }
  /// Begins a session with this drawing. Options and tool stay, except that of the drawing's
  /// surface and colour. Returns false if the drawing's surface is not known here; then the present
  /// one stays.
  bool open(const Drawing& drawing);
  /// Begins a session with this document and the defaults of the library, applies the recorded
  /// events unchanged, and continues after the last of them. Stops at the first event that does not
  /// fit.
  Result<void> restore(const Drawing& drawing, std::span<const Event> events);
  /// Sets the initial options of those tools that no restored event names, because the first
  /// module, which recorded the events, does not have them.
  void complete_options(std::span<const Event> events);
  /// Called with each edit of the document, and when another session begins (null).
  std::function<void(const Edit*)> on_edit;
  /// Called with each event that the session handled, pen samples included.
  std::function<void(const Event&)> on_event;
  /// Called with each sample after the session handled it.
  std::function<void(const PenSample&)> on_sample;
  /// Called with the report of each tick.
  std::function<void(const TickReport&)> on_tick;

  /// Handles a sample of a pointer. The time passes to that of the sample.
  void point(PointerSample sample);
  Result<void> apply(decltype(Event::what) what);
  Result<void> import(const std::string& path, std::span<const StrokePtr> strokes,
                      std::span<const FillPtr> fills);
  /// Adds materials that come with a file, unless the session has one with this id: the present
  /// drawing keeps its look. Returns the labels of those that the session has with other values.
  std::vector<std::string> add_materials(std::span<const std::string> texts);
  /// Lets the time pass until this time of the caller's clock, at most kLongestNs of it; the rest
  /// is skipped.
  void advance_to(std::int64_t time_ns);
  /// Does the same, and handles all samples, so that the frame shows them: time may pass for one
  /// more tick, and for up to kMaxTicksAhead until a pen that was set down touches the paper.
  void end_frame(std::int64_t time_ns);
  static constexpr int kMaxTicksAhead = 3;
  static constexpr std::int64_t kLongestNs = 100'000'000;
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  void finish();
  /// True if the session refused a sample, or the end of a gesture.
  [[nodiscard]] bool has_refusal() const noexcept { return !refusal_; }
  /// Returns why the session refused the last of them, once.
  Result<void> take_refusal() { return std::exchange(refusal_, {}); }

  /// Chooses a device of devices(). Fails if there is none with this id.
  Result<void> use_device(std::string_view id);
  [[nodiscard]] const std::string& device() const noexcept { return device_id_; }
  [[nodiscard]] bool has_force() const noexcept { return stylus_->capabilities().has_force(); }
  void set_forces(bool on);
  [[nodiscard]] bool forces() const noexcept { return forces_; }
  void set_strength(double share);
  [[nodiscard]] double strength() const noexcept { return strength_; }
  [[nodiscard]] const PenState& pen() const noexcept { return pen_; }
  [[nodiscard]] const TickReport& tick() { return servo_->latest(); }
  /// The first force of a session needs the relief of the surface, which takes some 50 ms. Until
  /// this call there are no forces, so that the user can draw immediately.
  void begin_forces() { has_forces_ = true; }

  /// Lets the simulated hand play a script from now on, at `speed` times the speed of a hand. Fails
  /// if the script cannot be read.
  Result<void> play(const std::string& name, std::string_view text, double mm_per_unit,
                    double speed);
  [[nodiscard]] bool is_playing() const noexcept { return play_ != nullptr; }
  /// Returns how much of the script was played, 0..1.
  [[nodiscard]] double played() const noexcept;
  void stop_play();
  /// Returns why the last play ended early, once.
  std::string take_play_error() { return std::exchange(play_error_, {}); }

 private:
  struct Play;

  enum class Options { kFirst, kOfLastSession, kDefaults };
  void make_session(Document document, std::span<const std::string> materials, Options options);
  void apply_first_options();
  void apply_first_options(const Tool& tool);
  void use_surface_of_session(std::uint32_t before_rgb);
  void start_loop();
  void step();
  void step_play();
  void process();
  void handle(PenSample sample);
  void note(Result<void> done);
  void publish();
  [[nodiscard]] bool may_rest() const noexcept;
  [[nodiscard]] double play_speed() const noexcept;
  [[nodiscard]] std::int64_t event_time_ns();

  std::unique_ptr<Session> session_;
  Page page_;
  Carried carried_;
  std::string device_id_;
  std::unique_ptr<SimulatedStylus> stylus_;
  std::unique_ptr<PointerHand> hand_;
  HandScriptOptions hand_options_;
  std::unique_ptr<Servo> servo_;
  PenState pen_;
  std::int64_t now_ns_ = 0;
  std::int64_t ahead_ns_ =
      0;  // how far a fast play has brought the session ahead of the caller's clock
  std::int64_t start_ns_ = 0;       // when the loop started
  std::int64_t last_event_ns_ = 0;  // of the session
  std::int64_t awake_ns_ = 0;       // when the user last did something
  int ticks_to_process_ = 0;
  bool forces_ = true, has_forces_ = false;
  bool was_in_contact_ = false;
  bool has_point_ = false;     // a sample of the pointer was not handled yet
  bool touches_down_ = false;  // the pointer came down, and no frame has ended since
  double strength_ = 1.0;
  std::unique_ptr<Play> play_;
  std::string play_error_;
  Result<void> refusal_;
};

}  // namespace felt::page
