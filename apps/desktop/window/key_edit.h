#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace felt::desktop {

/// A field that records the next key that is pressed in it, with its modifiers. Tab is not
/// recorded, because it moves the focus.
class KeyEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit KeyEdit(QWidget* parent = nullptr);

  void set_key(const QKeySequence& key);

 Q_SIGNALS:
  void pressed(const QKeySequence& key);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace felt::desktop
