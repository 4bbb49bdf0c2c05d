#pragma once

#include <QObject>
#include <QString>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A key for each tool: a tap takes the tool for good; a key that is held while its tool is used
/// gives the former tool back when it is released ("hold to borrow"). What counts as held is
/// kHoldMs; a gesture that is still going on then is waited for. Losing the window counts as a
/// release.
///
/// "tool.swap" (X) borrows the eraser for as long as it is held, or the pencil from the eraser.
///
/// Adds the actions "tool.ID" where no other room has them, and watches the program's key events.
class ToolKeys : public QObject {
  Q_OBJECT

 public:
  /// Shorter is a tap.
  static constexpr int kHoldMs = 250;

  /// All must outlive this; `window` is where the keys count.
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
  QString before_;    // the tool in hand when that key was pressed
  int last_key_ = 0;  // the key event that is being turned into a shortcut
  QString owed_;      // the tool that comes back when the pen is lifted
};

}  // namespace felt::desktop
