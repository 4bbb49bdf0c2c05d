#pragma once

#include <QLabel>
#include <QPushButton>
#include <optional>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// A line of text beside the end of a new line: how to pull it. A person who draws before reading
/// would otherwise not find the tool that this program is about. It appears after each of the first
/// lines, until this user has pulled a line once, and disappears when the pen touches the page. It
/// takes no clicks, so that one draws through it.
class PullHint : public QLabel {
  Q_OBJECT

 public:
  static constexpr int kMaxTimes = 5;  ///< how often it appears in one window

  /// `actions` has the tools' commands, whose keys the hint names. Both must outlive this object.
  PullHint(const Actions& actions, Canvas& canvas);

 private:
  void on_edit(const Edit& edit);
  void follow();
  void place();

  const Actions& actions_;
  Canvas& canvas_;
  Studio& studio_;
  std::optional<Point> at_;  // end of the new line
  int times_ = 0;
};

/// A button below the hints of the empty page that opens an example drawing, so that a new user has
/// something to pull.
class ExampleButton : public QPushButton {
  Q_OBJECT

 public:
  /// `example` is the command that opens the drawing. `canvas` must outlive this object.
  ExampleButton(QAction& example, Canvas& canvas);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Handles pens, which otherwise would draw on the canvas below.
  bool event(QEvent* event) override;

 private:
  void follow();

  Canvas& canvas_;
};

}  // namespace felt::desktop
