#pragma once

#include <QMenu>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/materials/media_pictures.h"
#include "desktop/panels/swatch_view.h"

namespace felt::desktop {

/// The menu at the pointer: a palette with the tools, the media and the recently used colours, the
/// presets, and the commands for the selected lines. It opens when the canvas emits popup_wanted:
/// after a click of the right button, or for a button or key that is set to do so.
class CanvasPopup : public QMenu {
  Q_OBJECT

 public:
  /// The arguments must outlive this object. `actions` must be complete.
  CanvasPopup(const Actions& actions, Canvas& canvas, const MediaPictures& pictures,
              QWidget* parent);

  /// Opens the menu at a pixel of the canvas. Does nothing while a line is drawn.
  void open_at(QPointF px);

 Q_SIGNALS:
  /// The user chose "Paste here".
  void wants_paste(felt::Point at);

 private:
  void build(const MediaPictures& pictures);
  QWidget* make_tools();
  void add_actions(const QStringList& names);
  void set_color(Rgba color);

  const Actions& actions_;
  Canvas& canvas_;
  Studio& studio_;
  const MediaPictures& pictures_;
  SwatchView* recent_ = nullptr;
  Point at_;
};

/// Adds edit.popup (key Menu), which opens the popup at the pointer, or in the middle of the canvas
/// if the pointer is elsewhere. Both arguments must outlive the action.
void add_popup_action(Actions& actions, Canvas& canvas);

}  // namespace felt::desktop
