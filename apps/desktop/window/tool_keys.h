#pragma once

#include <QObject>
#include <QString>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Handles a key for each tool. Pressing the key selects the tool. If the key is held for at least
/// kHoldMs and the tool is used meanwhile, the release of the key selects the former tool again
/// ("hold to borrow"); otherwise the tool stays selected. A gesture that is in progress at the
/// release is finished first. When the window loses the focus, the key counts as released.
///
/// "tool.swap" (X) borrows the eraser, or the pencil if the eraser is selected. The release of this
/// key always selects the former tool again.
///
/// For each tool without an action "tool.ID", this class adds this action.
class ToolKeys : public QObject {
  Q_OBJECT

 public:
  /// A press that is shorter than kHoldMs is a tap.
  static constexpr int kHoldMs = 250;

  /// All arguments must outlive this object. The keys work in `window`.
  ToolKeys(Actions& actions, Studio& studio, QWidget* window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Held {
    int key = 0;     // 0: no key
    QString former;  // the tool that was selected before
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
  QString before_;    // the tool that was current when `last_key_` was pressed
  int last_key_ = 0;  // the key that was pressed last and whose event may trigger an action now; 0:
                      // none
  QString owed_;      // the tool to select again when the pen is lifted
};

}  // namespace felt::desktop
