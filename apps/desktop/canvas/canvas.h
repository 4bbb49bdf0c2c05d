#pragma once

#include <QCursor>
#include <QElapsedTimer>
#include <QRegion>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "desktop/canvas/canvas_view.h"
#include "desktop/canvas/ink_view.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

struct PenMark;

/// The drawing area of the window: shows the paper, the ink, the wet ink, the tool's marks and the
/// pen. It only displays; the folder `pens` handles the pen with an event filter on this widget.
///
/// From bottom to top it paints the background and paper, marked spans as bands, dry ink (InkView),
/// wet ink, marks, and the nib. When the studio has changed, the canvas repaints only the part that
/// looks different.
class Canvas : public QWidget {
  Q_OBJECT

 public:
  explicit Canvas(Studio& studio, QWidget* parent = nullptr);
  ~Canvas() override;

  [[nodiscard]] Studio& studio() noexcept { return studio_; }
  [[nodiscard]] const CanvasView& view() const noexcept { return view_; }
  /// Sets the view and emits `view_changed`.
  void set_view(const CanvasView& view);
  /// Fits the whole page into the widget, and does so again after each resize until the user or the
  /// program changes the view.
  void fit_page();
  /// Fits the selection, or the whole page if nothing is selected.
  void fit_selection();
  /// Fits the ink of all visible layers, or the whole page if they have no ink.
  void fit_ink();
  /// Sets the zoom; 1 is life size. The point under anchor() keeps its position on the screen.
  void set_zoom(double zoom);
  [[nodiscard]] double zoom() const;
  void set_outline_mode(bool on);
  [[nodiscard]] InkView& ink() noexcept { return ink_; }
  /// Returns the point that stays fixed when keys zoom or turn the view: the pointer if it is over
  /// the widget, otherwise the middle of the widget.
  [[nodiscard]] QPointF anchor() const;

  /// Sets whether the nib is shown. Pass false when the pointer has left the canvas.
  void set_pen_visible(bool visible);
  /// Sets whether the user draws with a tablet pen instead of a mouse. Ink then appears exactly
  /// under the tip of the pen.
  void set_tablet_in_hand(bool tablet);
  [[nodiscard]] bool tablet_in_hand() const noexcept { return tablet_in_hand_; }
  /// Sets the translated message about the pen's pressure. The canvas shows it while the drawing is
  /// empty. If `status` is empty, the canvas derives the message from the samples.
  void set_pen_status(const QString& status);
  /// Sets marks that are shown besides those of the tool, for example the faults of a raised
  /// drawing.
  void set_notes(const Overlay& notes);
  /// Shows a document below the ink, such as the key drawings before and after the current one.
  void set_onion(const std::optional<Document>& onion);
  /// Moves the view so that this point is in the middle of the widget.
  void center_on(Point at);
  /// Hides the hints for a new user, which otherwise appear while the drawing is empty.
  void hide_first_hints();
  /// Returns true while the hints for a new user are shown.
  [[nodiscard]] bool shows_first_hints() const;
  /// Returns the rectangle of these hints.
  [[nodiscard]] QRect first_hints_area() const;
  /// Sets the name of the right mouse button's action, which the hint shows; "" if the button has
  /// no action.
  void set_right_button(const QString& what);
  /// Returns the canvas's own cursor, a small precise cross. Code that sets another cursor restores
  /// this one afterwards.
  [[nodiscard]] const QCursor& pen_cursor() const noexcept { return pen_cursor_; }

  /// Returns true if the widget got the focus by Tab, F6 or another key.
  [[nodiscard]] bool has_focus_by_key() const noexcept { return focus_by_key_; }

  /// Returns the hint for the status line: what the current tool does and with which modifiers.
  [[nodiscard]] QString hint() const;
  /// Returns the pen's position as "123.4, 56.7 mm"; empty if the nib is not shown.
  [[nodiscard]] QString place_text() const;
  /// Returns zoom and rotation as "100 %" or "50 %, 15°, mirrored".
  [[nodiscard]] QString view_text() const;
  /// Shows the present state of the studio without waiting for the event loop.
  void flush();

 Q_SIGNALS:
  void view_changed();
  void hint_changed();
  void place_changed();
  /// The hints for a new user appeared or disappeared.
  void first_hints_changed();
  /// The user clicked with the right button, or pressed a button with the role kPopup, at this
  /// pixel.
  void popup_wanted(QPointF px);
  /// The user holds the right button still, or a button with the role kRing, at this pixel.
  void ring_wanted(QPointF px);
  /// The pen or a finger was held still on the surface at this pixel, and still touches it.
  void ring_pressed(QPointF px);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Shown;

  void listen();
  void take_view(const CanvasView& view);
  void take_grain();
  void lay_out();
  void refresh_soon();
  void refresh();
  void on_edit(const Edit& edit);
  void on_ink(const QRect& part);
  void let_dry();
  void list_marks();
  PenMark pen_mark(const PenState& pen);
  [[nodiscard]] double nib_radius_px(double pull_n) const;
  void take_document();
  bool take_view_of_layers();
  void take_layers();
  void take_look();
  void take_status();
  void show_size(const QString& option_id);
  void add_size_ring();
  [[nodiscard]] bool shows_first_minute() const;
  void paint_ground(QPainter& painter, const QRegion& region);
  void paint_marks(QPainter& painter, const QRegion& region);

  Studio& studio_;
  CanvasView view_;
  InkView ink_;
  std::unique_ptr<Shown> shown_;
  QCursor pen_cursor_;
  QString pen_status_;
  QString right_button_;
  QTimer pace_;  // runs until the next refresh is allowed, if refreshes are slow
  QElapsedTimer clock_;
  QRegion painting_;          // the region being painted
  double paint_ms_ = 0.0;     // duration of the last paint
  double dpr_ = 0.0;          // device pixel ratio of the cached pictures
  bool is_stale_ = true;      // the studio has changed
  bool pen_visible_ = false;  // becomes true when the pointer enters
  bool tablet_in_hand_ = false;
  bool pressure_seen_ = false;
  bool keeps_page_fitted_ = true;
  bool focus_by_key_ = false;
  bool has_first_hints_ = true;
};

}  // namespace felt::desktop
