#include "desktop/engine/actions.h"

#include <QWidget>
#include <utility>

#include "desktop/engine/key_setting_keys.h"
#include "desktop/engine/settings.h"

namespace felt::desktop {
namespace {

const QString kShortcutPrefix = QStringLiteral("shortcuts/");

QString key_of(const QString& name) {
  return kShortcutPrefix + name;
}

/// Returns the name under which older versions stored the shortcut of an action.
QString former_name(QString name) {
  return name.replace(QLatin1String("feel.surface_"), QLatin1String("feel.sheet_"));
}

/// Returns true for a letter, digit or sign, with or without Shift.
bool is_single_character(const QKeySequence& keys) {
  if (keys.count() != 1) return false;
  constexpr int kFirstNamedKey = 0x01000000;  // below it, the keys are Unicode characters
  const QKeyCombination key = keys[0];
  return !(key.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) &&
         key.key() > Qt::Key_Space && key.key() < kFirstNamedKey;
}

}  // namespace

Actions::Actions(QWidget* window) : QObject(window), window_(window) {
  // Every window has its own table, but a key that is set in one window applies to all.
  connect(&Settings::the(), &Settings::changed, this, [this](const QString& key) {
    if (key == key_keys::kSingleCharacters) {
      for (QAction* action : actions_) take_keys(action);
    }
    if (!key.startsWith(kShortcutPrefix)) return;
    if (QAction* action = find(key.mid(kShortcutPrefix.size()))) take_keys(action);
  });
}

void Actions::take_keys(QAction* action) {
  const QString name = action->objectName();
  QVariant chosen = Settings::the().value(key_of(name));
  if (!chosen.isValid()) chosen = Settings::the().value(key_of(former_name(name)));
  QList<QKeySequence> keys = defaults_[name];
  if (chosen.isValid()) keys = QKeySequence::listFromString(chosen.toString());
  keys.removeAll(QKeySequence());  // an empty text is read as an empty sequence
  if (!Settings::the().flag(key_keys::kSingleCharacters, true)) {
    keys.removeIf([](const QKeySequence& key) { return is_single_character(key); });
  }
  action->setShortcuts(keys);
  const QString tip = action->statusTip();
  const QString shown = action->shortcut().toString(QKeySequence::NativeText);
  action->setToolTip(shown.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shown));
  Q_EMIT keys_changed(name);
}

QAction* Actions::make(const QString& name, const QString& text, const QList<QKeySequence>& keys,
                       const QString& tip) {
  auto* action = new QAction(text, this);
  action->setObjectName(name);
  action->setStatusTip(tip);
  defaults_[name] = keys;
  take_keys(action);
  window_->addAction(action);
  actions_.push_back(action);
  return action;
}

QAction* Actions::add(const QString& name, const QString& text, const QList<QKeySequence>& keys,
                      const QString& tip, std::function<void()> run) {
  QAction* action = make(name, text, keys, tip);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  return action;
}

QAction* Actions::add_switch(const QString& name, const QString& text,
                             const QList<QKeySequence>& keys, const QString& tip, bool on,
                             std::function<void(bool)> run) {
  QAction* action = make(name, text, keys, tip);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, [run = std::move(run)](bool now) { run(now); });
  return action;
}

QAction* Actions::find(const QString& name) const {
  for (QAction* action : actions_) {
    if (action->objectName() == name) return action;
  }
  return nullptr;
}

QList<QKeySequence> Actions::default_keys(const QString& name) const {
  const auto found = defaults_.find(name);
  return found == defaults_.end() ? QList<QKeySequence>{} : found->second;
}

void Actions::set_keys(const QString& name, const QList<QKeySequence>& keys) {
  if (!find(name)) return;
  if (keys == default_keys(name)) return reset_keys(name);
  Settings::the().set(key_of(name), QKeySequence::listToString(keys));
}

void Actions::reset_keys(const QString& name) {
  Settings::the().reset(key_of(name));
}

QAction* Actions::owner_of(const QKeySequence& key, const QAction* but) const {
  for (QAction* action : actions_) {
    if (action != but && action->shortcuts().contains(key)) return action;
  }
  return nullptr;
}

}  // namespace felt::desktop
