#pragma once

#include <QObject>
#include <QString>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A key for each tool. A tap selects the tool permanently. A key that is held while its tool is
/// used gives the former tool back when it is released ("hold to borrow"). A key counts as held
/// after kHoldMs; a gesture in progress is finished first. Losing the focus of the window counts as
/// a release.
///
/// "tool.swap" (X) borrows the eraser while it is held, or the pencil if the eraser is selected.
///
/// Adds the actions "tool.ID" that no other folder has added, and watches the program's key events.
class ToolKeys : public QObject {
  Q_OBJECT

 public:
  /// A shorter press is a tap.
  static constexpr int kHoldMs = 250;

  /// All arguments must outlive this; the keys work in `window`.
  ToolKeys(Actions& actions, Studio& studio, QWidget* window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Held {
    int key = 0;     // 0: none
    QString former;  // the tool before it
    qint64 since_ms = 0;
    bool is_used = false;
    bool gives_back_always = false;
  };

  void choose(const QString& tool);
  void borrow(const QString& tool, bool always);
  void note_use();
  void release();
  void give_back();
  [[nodiscard]] QString tool_in_hand() const;

  Actions& actions_;
  Studio& studio_;
  QWidget* window_;
  Held held_;
  QString before_;    // the current tool when that key was pressed
  int last_key_ = 0;  // the key event that may trigger a shortcut now
  QString owed_;      // the tool to give back when the pen is lifted
};

}  // namespace felt::desktop
