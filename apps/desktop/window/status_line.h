#pragma once

#include <QLabel>
#include <QStatusBar>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// The status bar. The left part describes the current tool's effect and modifiers. The right part
/// shows the pen position, zoom, rotation, pressure and device, and whether and where the drawing
/// is saved.
/// Messages of Studio::refused are shown for some seconds, or until the user does something else,
/// without moving the focus.
class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  StatusLine(Studio& studio, Canvas& canvas, QWidget* parent = nullptr);

  /// Sets the file of the drawing, or "" if it has none. While the drawing is saved, the status bar
  /// shows the name of its folder as a link that opens the folder.
  void set_file(const QString& path);
  /// Shows what is under the pen of the tool Read instead of the hint; "" shows the hint again.
  void show_reading(const QString& words);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_tool();
  void show_pen();
  void show_view();
  void show_device();
  void show_saved();
  QLabel* field(const QString& name, const QString& widest);
  void elide_hint();
  void end_message();

  Studio& studio_;
  Canvas& canvas_;
  QString hint_text_;
  QString reading_;
  QString file_;
  bool is_message_new_ = false;  // the studio has not shown its state since the message
  bool is_pen_down_ = false;
  QLabel* hint_;
  QLabel* place_;
  QLabel* pressure_;
  QLabel* zoom_;
  QLabel* angle_;
  QLabel* device_;
  QLabel* saved_;
};

}  // namespace felt::desktop
