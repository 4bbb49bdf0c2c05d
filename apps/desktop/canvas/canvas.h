#pragma once

#include <QCursor>
#include <QElapsedTimer>
#include <QRegion>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "desktop/canvas/canvas_view.h"
#include "desktop/canvas/ink_view.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

struct PenMark;

/// The sheet in the window: paper, ink, wet ink, what the tool shows, the pen. Looks only; what the
/// pen does comes from the room `pens`, which filters this widget's events.
///
/// From the ground up: desk and paper, marked spans as bands, dry ink (InkView), wet ink, marks,
/// the nib. After each turn of the studio it works out what looks otherwise than before and has
/// that part painted, and nothing else.
class Canvas : public QWidget {
  Q_OBJECT

 public:
  explicit Canvas(Studio& studio, QWidget* parent = nullptr);
  ~Canvas() override;

  [[nodiscard]] Studio& studio() noexcept { return studio_; }
  [[nodiscard]] const CanvasView& view() const noexcept { return view_; }
  /// Shows it from there; `view_changed` follows.
  void set_view(const CanvasView& view);
  /// The whole sheet, and so whenever the widget changes its size, until the view is changed.
  void fit_page();
  /// What is selected; the whole sheet where nothing is.
  void fit_selection();
  /// All ink of visible layers; the whole sheet where there is none.
  void fit_ink();
  /// 1: life size. What is under anchor() stays there.
  void set_zoom(double zoom);
  [[nodiscard]] double zoom() const;
  void set_outline_mode(bool on);
  [[nodiscard]] InkView& ink() noexcept { return ink_; }
  /// What stays in its place when keys zoom or turn: the pointer, or the middle.
  [[nodiscard]] QPointF anchor() const;

  /// Where the pen is not seen (the pointer left): no nib.
  void set_pen_visible(bool visible);
  /// A tablet's pen leads the hand, no mouse: ink must be right under its tip.
  void set_tablet_in_hand(bool tablet);
  /// What the empty sheet says of pressure, translated. Empty: what is known from the samples.
  void set_pen_status(const QString& status);
  /// What the right button of the mouse does, for the hint; "" for nothing.
  void set_right_button(const QString& what);
  /// A small exact cross; for whoever has set another cursor for a while.
  [[nodiscard]] const QCursor& pen_cursor() const noexcept { return pen_cursor_; }

  /// The focus came by Tab, F6 or another key.
  [[nodiscard]] bool has_focus_by_key() const noexcept { return focus_by_key_; }

  /// For the status line: what the tool in hand does, and with which modifiers.
  [[nodiscard]] QString hint() const;
  /// "123.4, 56.7 mm"; empty where the pen is not seen.
  [[nodiscard]] QString place_text() const;
  /// "100 %", "50 %, 15°, mirrored"
  [[nodiscard]] QString view_text() const;
  /// Shows what the studio has now, without waiting for its turn in the event loop.
  void flush();

 Q_SIGNALS:
  void view_changed();
  void hint_changed();
  void place_changed();

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
  QTimer pace_;  // until the next refresh, where they are dear
  QElapsedTimer clock_;
  QRegion painting_;          // this is being painted
  double paint_ms_ = 0.0;     // the last one
  double dpr_ = 0.0;          // that the pictures are made for
  bool is_stale_ = true;      // the studio has news
  bool pen_visible_ = false;  // until the pointer comes
  bool tablet_in_hand_ = false;
  bool pressure_seen_ = false;
  bool keeps_page_fitted_ = true;
  bool focus_by_key_ = false;
};

}  // namespace felt::desktop
