#include "desktop/window/key_edit.h"

#include <QKeyEvent>

namespace felt::desktop {
namespace {

bool is_modifier(int key) {
  return key == Qt::Key_Shift || key == Qt::Key_Control || key == Qt::Key_Alt ||
         key == Qt::Key_Meta || key == Qt::Key_AltGr || key == Qt::Key_CapsLock || key == 0 ||
         key == Qt::Key_unknown;
}

bool moves_on(int key) {
  return key == Qt::Key_Tab || key == Qt::Key_Backtab;
}

}  // namespace

KeyEdit::KeyEdit(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setPlaceholderText(tr("Press a key"));
  setContextMenuPolicy(Qt::NoContextMenu);
}

void KeyEdit::set_key(const QKeySequence& key) {
  setText(key.toString(QKeySequence::NativeText));
}

bool KeyEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();  // the field uses the key even if it is a shortcut
    return true;
  }
  return QLineEdit::event(event);
}

void KeyEdit::keyPressEvent(QKeyEvent* event) {
  if (moves_on(event->key())) return QLineEdit::keyPressEvent(event);
  if (is_modifier(event->key())) return;
  const auto modifiers = event->modifiers() & ~Qt::KeypadModifier;
  const QKeySequence key(QKeyCombination(modifiers, Qt::Key(event->key())));
  set_key(key);
  Q_EMIT pressed(key);
}

}  // namespace felt::desktop
