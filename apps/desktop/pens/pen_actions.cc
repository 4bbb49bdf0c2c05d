#include "desktop/pens/pen_actions.h"

#include <QCoreApplication>

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("PenActions", source);
}

void hold(PenInput& input, std::uint32_t bit, bool on) {
  const std::uint32_t others = input.hand().locked() & ~bit;
  input.hand().set_locked(on ? others | bit : others);
}

}  // namespace

void add_pen_actions(Actions& actions, PenInput& input) {
  const QString key = QString::fromLatin1(pen_keys::kPressureOn);
  QAction* pressure = actions.add_switch(
      QStringLiteral("feel.pressure"), text(QT_TRANSLATE_NOOP("PenActions", "&Pen pressure")), {},
      text(QT_TRANSLATE_NOOP(
          "PenActions",
          "Press harder to draw a wider line. If off, every line has the same width.")),
      Settings::the().flag(key, pen_keys::kPressureOnDefault),
      [key](bool on) { Settings::the().set(key, on); });
  QObject::connect(&Settings::the(), &Settings::changed, pressure,
                   [pressure, key](const QString& changed) {
                     if (changed != key) return;
                     pressure->setChecked(Settings::the().flag(key, pen_keys::kPressureOnDefault));
                   });
  actions.add_switch(QStringLiteral("feel.hold_first"),
                     text(QT_TRANSLATE_NOOP("PenActions", "Hold the &first modifier")),
                     {QKeySequence(Qt::Key_Comma)},
                     text(QT_TRANSLATE_NOOP(
                         "PenActions", "Acts as if Shift were held, until you choose this again.")),
                     false, [&input](bool on) { hold(input, kFirstModifier, on); });
  actions.add_switch(QStringLiteral("feel.hold_second"),
                     text(QT_TRANSLATE_NOOP("PenActions", "Hold the &second modifier")),
                     {QKeySequence(Qt::Key_Period)},
                     text(QT_TRANSLATE_NOOP(
                         "PenActions", "Acts as if Ctrl were held, until you choose this again.")),
                     false, [&input](bool on) { hold(input, kSecondModifier, on); });
}

}  // namespace felt::desktop
