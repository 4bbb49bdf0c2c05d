#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "desktop/engine/haptic_loop.h"
#include "desktop/engine/studio_options.h"
#include "felt/document/page.h"
#include "felt/geometry/triangle_tree.h"
#include "felt/material/material_file.h"
#include "felt/session/session.h"

namespace felt::desktop {

/// Position and force of the pen, for display.
struct PenState {
  bool is_known = false;  ///< false before the first sample
  PenSample sample;       ///< the newest sample that the session handled
  Point hand;             ///< position from mouse or tablet; if these do not move the hand, the
                          ///< position of the sample
  Force asked;            ///< force that the tool asked for
  Force sent;             ///< force that was sent to the device
};

/// The drawing of a window, with its session, page and materials. Every change of a drawing is made
/// here. Widgets read session() and repaint when a signal reports a change. Pen samples reach the
/// session through loop(), the haptic loop.
///
///   Studio studio({});
///   studio.point({studio.now_ns(), {30, 40}, true, 0.5});   // mouse and tablet: where the hand is
///   studio.apply(SelectTool{"pull"});                       // everything else, as events
///   connect(&studio, &Studio::edited, ...);
///
/// Use it only in Qt's main thread.
class Studio : public QObject {
  Q_OBJECT

 public:
  explicit Studio(StudioOptions options, QObject* parent = nullptr);
  ~Studio() override;

  // --- The drawing
  [[nodiscard]] const Session& session() const noexcept { return *session_; }
  [[nodiscard]] const Page& page() const noexcept { return page_; }
  /// Returns the surfaces and media that can be chosen: Feltline's, the user's, and those that
  /// came with the drawing.
  [[nodiscard]] const Materials& materials() const noexcept { return materials_; }
  /// Sets the user-defined materials. The session receives each material that changed
  /// (UseMaterial), so that forces, picture and sound use it immediately. The page's paper colour
  /// is updated.
  void set_user_materials(const Materials& known);
  /// Sets the page. This is not a step of undo, but it is an unsaved change. The session uses the
  /// page's surface; if the page names no surface or an unknown surface, the session keeps its
  /// surface. When the user chooses a surface ("surface.material"), that surface becomes the
  /// page's. If the paper is white or has the usual colour of the previous surface, the paper gets
  /// the usual colour of the new surface; a paper colour that the user chose stays. The paper's
  /// colour is also updated in this way if the usual colour of the page's surface changes
  /// (set_user_materials()).
  void set_page(const Page& page);
  /// Replaces the drawing. History and selection become empty, and the drawing has no unsaved
  /// changes. The tool and its options stay. The surface stays, too, unless the page names a known
  /// surface. `materials` are the texts of the materials that come with the drawing. A text that
  /// cannot be read is skipped, and `refused` says why. The drawing's materials are used even if a
  /// user-defined material of the same name has other values; in this case `refused` names the
  /// material. `ink` becomes the colour of new lines before `opened` is emitted. option_changed is
  /// not emitted for this colour, because it comes with the drawing and the user did not choose it.
  void open(Document document, const Page& page, std::span<const std::string> materials = {},
            std::optional<Rgba> ink = {});
  /// Replaces the drawing by an empty one, as open() does, and gives all options the values of a
  /// new studio.
  void start_over(const Page& page);
  /// Returns true if the drawing has unsaved changes.
  [[nodiscard]] bool is_modified() const noexcept { return is_modified_; }
  void set_modified(bool modified);
  /// Returns a mark that identifies the present state. The mark is needed because the user may
  /// continue to edit while a file is written.
  [[nodiscard]] ChangeMark change_mark() const noexcept;
  /// Must be called when a file with the state of `mark` was written. Changes since that state,
  /// including an undo, count as unsaved changes.
  void set_saved(const ChangeMark& mark);

  // --- Events
  /// Handles all waiting samples and then applies an event to the session. Returns false if the
  /// session refuses the event; then `refused` says why.
  bool apply(decltype(Event::what) what);
  /// Ends the gesture as if the pen had been lifted and commits its result.
  void finish_gesture();
  /// Adds strokes as one step of undo. Returns false if the session refuses them, as apply() does.
  bool import(const QString& path, std::span<const StrokePtr> strokes,
              std::span<const FillPtr> fills = {});
  /// Adds those media of the strokes that are not known yet; call it before import(). `texts` are
  /// the materials that come with the strokes; a text that cannot be read is skipped. If a medium
  /// is already known but with other values, the known medium stays. Returns the labels of such
  /// media, each once.
  std::vector<std::string> add_media(std::span<const std::string> texts,
                                     std::span<const StrokePtr> strokes);
  /// Selects another tool until give_back_tool() is called, for example while a key is held or the
  /// pen is turned over. Calls may be nested; the inner calls do nothing.
  void borrow_tool(const QString& id);
  void give_back_tool();
  [[nodiscard]] bool is_borrowing() const noexcept { return borrowed_ > 0; }

  // --- The pen
  [[nodiscard]] HapticLoop& loop() noexcept { return loop_; }
  [[nodiscard]] const HapticLoop& loop() const noexcept { return loop_; }
  /// Opens another device. Returns false if the device does not open; then the previous device
  /// stays in use, and `refused` says why. A gesture ends as if the pen had been lifted.
  bool use_device(const QString& id);
  /// Handles a position of the hand from mouse, tablet or keys. Event times are on the clock of
  /// now_ns(). Events may arrive late, or several together; the hand then still moves at the
  /// events' own intervals, with a delay of a few milliseconds. If the device follows the hand
  /// exactly, each event becomes a sample.
  void point(const PointerEvent& event);
  /// While the pen is lent, for example to a dialog, it does not touch the drawing: the session
  /// sees a pen above the paper, and pen() has the pen as it is. A touch that began meanwhile stays
  /// above the paper until it ends. A gesture in progress ends as if the pen had been lifted.
  void lend_pen(bool lent);
  /// Returns true while the pen is lent or feels bodies, and afterwards until it is up: its samples
  /// draw nothing.
  [[nodiscard]] bool is_pen_elsewhere() const noexcept {
    return bodies_ || is_pen_lent_ || is_held_from_ink_;
  }
  /// Returns the time on the clock of the session and of the haptic loop.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return loop_.now_ns(); }
  /// Handles all waiting samples, publishes the resulting force, and emits the signals for what
  /// changed. The haptic loop's timer calls it.
  void process();
  /// Advances the time tick by tick. Requires that the studio is not live.
  void advance(std::int64_t ns);
  [[nodiscard]] const PenState& pen() const noexcept { return pen_; }
  /// Lets the pen feel these bodies (SolidSurface) instead of the page, with the material of the
  /// page. Their triangles are in mm in the frame of the page. Null ends it, or nothing if it has
  /// not begun. It is not an event of the session: meanwhile the session gets the samples of a pen
  /// above the page, and afterwards until the pen is up, so that nothing is drawn, and the same
  /// tool continues. A gesture ends as if the pen had been lifted. Afterwards the force is
  /// zero until the pen is up, because it may be far below the page.
  void touch(std::shared_ptr<const TriangleTree> bodies);
  /// Returns true while the pen feels bodies.
  [[nodiscard]] bool is_touching() const noexcept { return bodies_ != nullptr; }
  /// Returns the point on the bodies that stands for the pen, mm on the page; nullopt without
  /// bodies, or if the pen has not yet been in front of them.
  [[nodiscard]] std::optional<Vec3> proxy();

 Q_SIGNALS:
  // --- Signals about the session, emitted immediately and in order, for code that stores or
  // records. Slots must be quick, and must not call functions of the studio.
  /// A session with this document begins; its events follow. Emitted when the studio is made and
  /// for each open(). To receive the first emission, connect in StudioOptions::connect_early.
  void session_began(const felt::Document& document);
  /// The session handled this event; pen samples are passed as PenEvent. The first events set the
  /// device and the options that differ from the defaults, so that the events alone give the same
  /// drawing in another session.
  void event_applied(const felt::Event& event);
  /// The document applied this edit, which may be an undo or redo.
  void edit_applied(const felt::Edit& edit);
  /// The session handled this sample.
  void sampled(const felt::PenSample& sample);

  // --- Signals about changes, for the window. Slots may call any function of the studio.
  /// The document applied this edit, which may be an undo or redo; session().document() contains
  /// it.
  void edited(const felt::Edit& edit);
  /// The preview, the overlay or the pen must be painted again. Emitted at most once for each
  /// process().
  void shown();
  /// Another drawing was opened by open().
  void opened();
  void tool_changed();
  /// An option such as "pencil.snap" or "ink.color" changed.
  void option_changed(const QString& id);
  void selection_changed();
  /// A surface or a medium was added or changed.
  void materials_changed();
  /// Another layer is in use. Changes of the layers themselves are reported by `edited`.
  void layer_changed();
  void page_changed();
  void modified_changed(bool modified);
  /// is_pen_elsewhere() is another value. Samples of the haptic loop draw nothing while it is true.
  void elsewhere_changed(bool elsewhere);
  /// A menu at the pen asks for a tick, which cue devices play.
  void tick_wanted();
  /// Reports a sentence for the status line.
  void refused(const QString& why);

 private:
  void connect_loop();
  enum class InitialOptions { kFirst, kOfLastSession };
  void make_session(Document document, std::span<const std::string> materials,
                    InitialOptions options);
  void open(Document document, const Page& page, std::span<const std::string> materials,
            std::optional<Rgba> ink, InitialOptions options);
  void apply_first_options(std::int64_t now_ns);
  void update_modified();
  void report_modified(bool modified);
  [[nodiscard]] std::int64_t event_time_ns();
  bool drain();
  void handle_sample(PenSample& sample);
  void deselect_for_drawing(const PenSample& sample);
  void publish();
  void lift_if_elsewhere(PenSample& sample);
  void report_elsewhere();
  [[nodiscard]] double height_of_bodies_mm(Point at) const;
  void report_changes();
  [[nodiscard]] HapticLoop::PenActivity pen_activity() const;

  // Functions for materials and page, in studio_materials.cc.
  void add_materials_of_drawing(std::span<const std::string> texts);
  void add_material(const std::string& text);
  void gather_materials();
  void update_paper(const std::optional<AnyMaterial>& before, const AnyMaterial& now);
  [[nodiscard]] bool is_drawn_with(const AnyMaterial& material) const;
  bool apply_page(const Page& page);
  void set_surface_of_page();

  StudioOptions options_;
  HapticLoop loop_;
  std::unique_ptr<Session> session_;
  Page page_;
  Materials materials_;                  // all materials that can be chosen
  std::vector<AnyMaterial> of_drawing_;  // materials that came with the drawing and differ from
                                         // options_.materials
  PenState pen_;
  bool touches_for_ring_ = false;               // the pen has touched while a ring was open
  bool is_pen_lent_ = false;                    // lend_pen()
  std::shared_ptr<const TriangleTree> bodies_;  // null: the pen feels the page
  std::uint32_t bodies_number_ = 0;
  bool is_held_from_ink_ = false;  // a touch that began on bodies or while the pen was lent
  bool is_below_page_ = false;     // the pen has felt bodies there, and has not been up since
  bool reported_elsewhere_ = false;
  std::int64_t last_event_ns_ = 0;  // time of the last event of the session
  std::vector<Edit> edits_;         // edits that `edited` has not reported yet
  QString home_tool_;               // the tool to select again while another one is borrowed
  int borrowed_ = 0;
  bool is_modified_ = false;
  bool has_other_changes_ = false;    // changes outside of the history: page, materials, a
                                      // recovered drawing
  std::uint64_t other_changes_ = 0;   // number of changes outside of the history
  std::uint64_t saved_position_ = 0;  // position in the history when the drawing was last saved
  bool in_process_ = false;
  bool has_news_ = false;
  bool was_in_contact_ = false;
  // The values that the signals reported last.
  std::string reported_tool_;
  LayerId reported_layer_;
  std::uint64_t reported_selection_ = 0;
};

}  // namespace felt::desktop
