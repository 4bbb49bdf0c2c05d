#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "desktop/engine/pen_device.h"
#include "desktop/engine/studio_options.h"
#include "desktop/engine/tick_timer.h"
#include "felt/devices/simulated/pointer_hand.h"
#include "felt/document/sheet_page.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/material/material_file.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"
#include "felt/session/session.h"

namespace felt::desktop {

/// Where the pen is and what it feels, for the eye.
struct PenState {
  bool is_known = false;  ///< there has been a sample
  PenSample sample;       ///< the newest one that the session was told
  Point hand;             ///< where mouse or tablet want it; the sample's place without a hand
  Force asked;            ///< by the tool
  Force sent;             ///< to the device
};

/// A drawing on the desk, with all that works on it: session, haptic loop, device. What a window is
/// a window of. Everything that changes a drawing goes through here; widgets read session() and
/// draw what they see when a signal says that it changed.
///
///   Studio studio({});
///   studio.point({studio.now_ns(), {30, 40}, true, 0.5});   // mouse and tablet: where the hand is
///   studio.apply(SelectTool{"pull"});                       // everything else, as events
///   connect(&studio, &Studio::edited, ...);
///
/// Live, a real-time thread ticks the loop, and a timer drains its samples into the session: right
/// after each tick while the pen is near, after each fourth when it was moved a while ago, else
/// after each 16th. The loop wakes nobody. Where no motors push, loop and timer stop some seconds
/// after the last event, until the next one. Qt's main thread only.
class Studio : public QObject {
  Q_OBJECT

 public:
  explicit Studio(StudioOptions options, QObject* parent = nullptr);
  ~Studio() override;

  // --- The drawing
  [[nodiscard]] const Session& session() const noexcept { return *session_; }
  [[nodiscard]] const SheetPage& page() const noexcept { return page_; }
  /// Sheets and media that may be chosen: those that Feltline brings, a person's own, and those
  /// that the drawing brought along.
  [[nodiscard]] const Materials& materials() const noexcept { return materials_; }
  /// A person's own are these from now on. The session is told (UseMaterial) of each that is other
  /// than it was, so that hand, picture and ear have it at once; the page's paper follows.
  void know(const Materials& known);
  /// One at a time; none: {}.
  void listen(StudioListener listener);
  /// No step of undo, but a change that is to be saved. The session draws on the surface that it
  /// says; where it says none, or one that is not known here, on the one that was chosen before.
  /// Choosing a surface ("sheet.material") makes it the page's, and its usual colour the page's
  /// paper, where that still is the usual one of the surface before, or white; another paper is a
  /// person's own, and stays. Likewise when the page's surface gets another colour (know()).
  void set_page(const SheetPage& page);
  /// Another drawing takes the place of this one: history, selection and modification start anew;
  /// tool and options stay, and the surface where the page says none that is known.
  /// `materials`: texts of those that it brings along; one that cannot be read is left out, and
  /// `refused` says why. They hold here, also where a person's own of that name have other figures:
  /// `refused` names those. `ink` becomes the colour of new lines, before `opened` is emitted and
  /// without option_changed, because the drawing brings it and the user did not choose it.
  void open(Document document, const SheetPage& page, std::span<const std::string> materials = {},
            std::optional<Rgba> ink = {});
  /// There is something that a file has not got.
  [[nodiscard]] bool is_modified() const noexcept { return is_modified_; }
  void set_modified(bool modified);
  /// Identifies the present state, for a file that is written while the user may go on.
  [[nodiscard]] ChangeMark change_mark() const noexcept;
  /// A file has the state of `mark` now. Changes and undo since then are unsaved changes.
  void set_saved(const ChangeMark& mark);

  // --- What happens
  /// Does what an event does, now, after every sample that came before it. False: the session
  /// refuses; `refused` says why.
  bool apply(decltype(Event::what) what);
  /// What is being drawn is ended as if the pen were lifted, and is in the document then.
  void finish_gesture();
  /// Adds strokes as one step of undo. Likewise.
  bool import(const QString& path, std::span<const SketchStroke> strokes);
  /// Before import(): of the media that these strokes are of, those that are not known here are
  /// known from now on. `texts` are what the strokes' drawing brings along; one that cannot be read
  /// is left out. A medium that is another one here stays as it is: the labels of these are
  /// returned, each once.
  std::vector<std::string> bring(std::span<const std::string> texts,
                                 std::span<const SketchStroke> strokes);
  /// Another tool until give_back(): a key is held, the pen is turned over. Nested borrowing does
  /// nothing but count.
  void borrow_tool(const QString& id);
  void give_back_tool();
  [[nodiscard]] bool is_borrowing() const noexcept { return borrowed_ > 0; }

  // --- The hand
  /// Mouse, tablet or keys say where the hand is, and when it was there, on the clock of now_ns():
  /// events that come late or several at once are played in their own spacing, a few milliseconds
  /// later. Each of them is a sample where the device is exactly what the hand does.
  void point(const PointerEvent& event);
  /// How hard a hand presses that senses no pressure.
  void set_mouse_pressure(MousePressure mouse);
  /// The loop's clock.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// When the loop's next tick is due, on that clock. Not live: a period from now.
  [[nodiscard]] std::int64_t next_tick_ns() const noexcept;
  /// Feeds all samples that wait into the session and shows what came of it. The canvas calls it
  /// before it paints.
  void turn();
  /// Not live: time goes on by this much, tick by tick.
  void advance(std::int64_t ns);
  [[nodiscard]] const PenState& pen() const noexcept { return pen_; }

  // --- The loop
  /// Another device. False: it does not open; the one in use stays, `refused` says why. What is
  /// being drawn is ended as if the pen were lifted.
  bool use_device(const QString& id);
  /// One that is open already, and knows where it is. Returns the one that was in use, at rest: to
  /// be closed, or to be given back later; null where it hangs in its maker's call: then it is lost
  /// until the program is started anew.
  std::unique_ptr<PenDevice> use_device(std::unique_ptr<PenDevice> device);
  /// The device in use is seen through another profile: a new loop begins, from no force, and
  /// where motors move a hand forces are off.
  void follow(const DeviceProfile& profile);
  [[nodiscard]] PenDevice& device() noexcept { return *device_; }
  /// Whether this device, of any studio, hung in its maker's call when its loop was to end. It is
  /// given up then with all that the call may still use, mouse and pen stand in for it, and only
  /// another start of the program can use it again; given_up_words() says so to a person.
  [[nodiscard]] static bool is_given_up(const QString& device_id);
  [[nodiscard]] static QString given_up_words(const QString& device_label);
  /// How the device in use is, and whether its loop runs.
  [[nodiscard]] DeviceStatus device_status();
  /// Forces on or off. They are on from the start where no motors move a person's hand.
  void set_forces(bool on);
  [[nodiscard]] bool forces_are_on() const noexcept { return forces_on_; }
  /// Master strength of all forces, 0..1: what the models ask for times this. Kept when the device
  /// changes.
  void set_strength(double share);
  [[nodiscard]] double strength() const noexcept { return strength_; }
  /// The most that a person wants to feel, 0..SafetyLimits::peak_force_n, in N. A new limit ends
  /// the loop and begins another, from no force, and the session gets it as UseDevice: full width
  /// is a push within the limit (with_force_limit).
  void set_force_limit(double newton);
  [[nodiscard]] double force_limit() const noexcept { return force_limit_n_; }
  /// The newest tick.
  [[nodiscard]] const TickReport& tick() noexcept { return servo_->latest(); }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  /// How the loop keeps its time; null where it is not live.
  [[nodiscard]] RealtimeThread* loop() noexcept { return thread_.get(); }

 Q_SIGNALS:
  /// The document took this edit, undo's and redo's too; session().document() has it.
  void edited(const felt::Edit& edit);
  /// Preview, overlay or pen are not what they were: paint them again. At most once a turn.
  void shown();
  /// Another drawing is here (open()).
  void opened();
  void tool_changed();
  /// "pencil.snap", "sheet.color"
  void option_changed(const QString& id);
  void selection_changed();
  /// A sheet or a medium is new or other than it was.
  void materials_changed();
  /// The layer in use; what layers there are comes by `edited`.
  void layer_changed();
  void page_changed();
  void modified_changed(bool modified);
  void device_changed();
  /// The device's faults or its notice have changed: a new one, or an old one is over. The device
  /// in use is still the same.
  void device_status_changed(const felt::DeviceStatus& status);
  void forces_changed(bool on);
  void strength_changed(double share);
  /// A sentence for the status line.
  void refused(const QString& why);
  /// The session was told this sample: each of them, in order. Must be quick, and must not call
  /// back.
  void sampled(const felt::PenSample& sample);
  /// Every tick's report that the edit side saw, in order; not all ticks: for plots.
  void ticked(const felt::TickReport& report);

 private:
  void make_session(Document document, std::span<const std::string> materials);
  void take_materials(std::span<const std::string> texts);
  void follow_history();
  void tell_modified(bool modified);
  void take_first_options(std::int64_t now_ns);
  void gather_materials();
  void note_material(const std::string& text);
  void follow_color(const std::optional<AnyMaterial>& before, const AnyMaterial& now);
  [[nodiscard]] bool is_drawn_with(const AnyMaterial& material) const;
  bool take_page(const SheetPage& page);
  void name_surface();
  [[nodiscard]] UseDevice used_device() const;
  void start_loop();
  bool stop_loop();
  void give_up(std::unique_ptr<RealtimeThread> loop);
  [[nodiscard]] std::int64_t event_time_ns();
  bool drain();
  void take(PenSample& sample);
  void deselect_for_drawing(const PenSample& sample);
  void publish();
  void tell();
  void set_pace(bool has_samples);
  [[nodiscard]] bool may_sleep(std::int64_t now) const;
  void sleep();
  void wake();
  void wake_at(std::int64_t time_ns);
  void look_at_device();
  void begin_with_device();

  StudioOptions options_;
  StudioListener listener_;
  std::unique_ptr<PenDevice> device_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<RealtimeThread> thread_;
  std::unique_ptr<PointerHand> hand_;
  MousePressure mouse_pressure_ = MousePressure::kConstant;
  std::unique_ptr<Session> session_;
  SheetPage page_;
  Materials materials_;               // what may be chosen
  std::vector<AnyMaterial> brought_;  // by the drawing, other than known
  PenState pen_;
  TickTimer timer_;
  std::int64_t wake_ns_ = 0;  // when the timer comes
  int late_looks_ = 0;        // in a row, for a tick that is late
  std::int64_t virtual_ns_ = 0;
  std::int64_t clock_start_ns_ = 0;  // what the session's clock said when this loop began
  std::int64_t last_point_ns_ = 0;
  std::int64_t last_event_ns_ = 0;  // of the pointer, or a command
  std::int64_t told_ns_ = 0;        // of the session's last event
  QString given_up_label_;          // of a device, until a person has been told
  std::vector<Edit> edits_;         // that signals have not told yet
  QString home_tool_;               // while another is borrowed
  int borrowed_ = 0;
  bool is_modified_ = false;
  bool has_other_changes_ = false;    // than steps of the history: page, materials, a rescue
  std::uint64_t other_changes_ = 0;   // how many there were
  std::uint64_t saved_position_ = 0;  // of the history, when there were no changes
  bool forces_on_ = false;
  double strength_ = 1.0;
  double force_limit_n_ = SafetyLimits{}.peak_force_n;
  bool in_turn_ = false;
  bool has_news_ = false;
  // What the signals told last.
  SafetyState told_safety_ = SafetyState::kOff;
  std::string told_tool_;
  LayerId told_layer_;
  std::uint64_t told_selection_ = 0;
  std::uint64_t told_faults_ = 0;
  std::optional<DeviceFault> told_fault_;
  ShortText told_notice_;
  bool was_in_contact_ = false;
  std::string start_error_;  // why the loop does not run
  std::int64_t looked_at_device_ns_ = 0;
};

}  // namespace felt::desktop
