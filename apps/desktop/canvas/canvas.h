#pragma once

#include <QWidget>
#include <optional>

#include "desktop/canvas/canvas_view.h"
#include "desktop/canvas/ink_view.h"
#include "desktop/engine/studio.h"
#include "felt/tools/overlay.h"

namespace felt::desktop {

/// The sheet in the window: paper, ink, wet ink, what the tool shows, the pen. Looks only; what the
/// pen does comes from the room `pens`, which filters this widget's events.
class Canvas : public QWidget {
  Q_OBJECT

 public:
  explicit Canvas(Studio& studio, QWidget* parent = nullptr);

  [[nodiscard]] Studio& studio() noexcept { return studio_; }
  [[nodiscard]] const CanvasView& view() const noexcept { return view_; }
  /// Shows it from there; `view_changed` follows.
  void set_view(const CanvasView& view);
  void fit_page();
  void fit_selection();
  void fit_ink();
  /// 1: life size.
  void set_zoom(double zoom);
  [[nodiscard]] double zoom() const;
  void set_outline_mode(bool on);
  [[nodiscard]] InkView& ink() noexcept { return ink_; }
  /// Where the pen is not seen (the pointer left): no nib.
  void set_pen_visible(bool visible);

 Q_SIGNALS:
  void view_changed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void refresh();

  Studio& studio_;
  CanvasView view_;
  InkView ink_;
  Overlay overlay_;
  bool pen_visible_ = true;
  bool was_fitted_ = false;
};

}  // namespace felt::desktop
