#include "desktop/testing/accessible_names.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QScrollBar>
#include <QTextEdit>

namespace felt::desktop {
namespace {

template <class... T>
bool is_one_of(const QWidget* widget) {
  return (... || (qobject_cast<const T*>(widget) != nullptr));
}

bool is_control(const QWidget* widget) {
  return is_one_of<QAbstractButton, QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox,
                   QLineEdit, QPlainTextEdit, QProgressBar, QTextEdit>(widget);
}

/// Returns true if Qt made this widget as a part of one of Feltline's controls.
bool is_part(const QWidget* widget) {
  if (is_one_of<QScrollBar, QHeaderView>(widget)) return true;
  if (widget->objectName().startsWith(QStringLiteral("qt_"))) return true;
  for (const QWidget* up = widget->parentWidget(); up; up = up->parentWidget()) {
    if (is_one_of<QAbstractSpinBox, QComboBox, QLineEdit>(up)) return true;
    const QString name = QString::fromLatin1(up->metaObject()->className());
    if (name == QStringLiteral("QTabBar") || name == QStringLiteral("QMenuBar")) return true;
    // Skips the corner of a table, and the buttons of its header.
    if (qobject_cast<const QAbstractItemView*>(up) &&
        qobject_cast<const QAbstractButton*>(widget)) {
      return true;
    }
  }
  return false;
}

QString place_of(const QWidget* widget) {
  QString place = QString::fromLatin1(widget->metaObject()->className());
  if (!widget->objectName().isEmpty()) place += QStringLiteral(" \"%1\"").arg(widget->objectName());
  for (const QWidget* up = widget->parentWidget(); up; up = up->parentWidget()) {
    const QString name = QString::fromLatin1(up->metaObject()->className());
    if (name.startsWith(QLatin1Char('Q'))) continue;
    return place + QStringLiteral(" in ") + name;
  }
  return place;
}

}  // namespace

QStringList nameless_controls(QWidget& root) {
  QStringList nameless;
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    if (!is_control(widget) || is_part(widget)) continue;
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
    if (!seen || seen->text(QAccessible::Name).trimmed().isEmpty()) {
      nameless.push_back(place_of(widget));
    }
  }
  return nameless;
}

}  // namespace felt::desktop
