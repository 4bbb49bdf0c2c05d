#include "desktop/window/tool_keys.h"

#include <QApplication>
#include <QDateTime>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QWidget>
#include <utility>

#include "desktop/engine/text_of.h"
#include "desktop/engine/tool_texts.h"

namespace felt::desktop {
namespace {

qint64 now_ms() {
  static const QElapsedTimer kClock = [] {
    QElapsedTimer clock;
    clock.start();
    return clock;
  }();
  return kClock.elapsed();
}

}  // namespace

ToolKeys::ToolKeys(Actions& actions, Studio& studio, QWidget* window)
    : QObject(window), actions_(actions), studio_(studio), window_(window) {
  for (const auto& tool : studio.session().tools()) {
    const ToolInfo& info = tool->info();
    const QString id = text_of(info.id), name = QStringLiteral("tool.") + id;
    QAction* action = actions_.find(name);
    if (!action) {
      QList<QKeySequence> keys;
      if (info.shortcut) keys.push_back(QKeySequence(QChar::fromLatin1(info.shortcut).toUpper()));
      action = actions_.add(name, translated(info.label), keys, translated(info.help), [] {});
      action->setCheckable(true);
    }
    action->setAutoRepeat(false);
    // Connected after the action's own slot, so that holding the key works for any action.
    connect(action, &QAction::triggered, this, [this, id] { choose(id); });
  }
  QAction* swap = actions_.add(
      QStringLiteral("tool.swap"), tr("&Eraser while held"), {QKeySequence(Qt::Key_X)},
      tr("Uses the eraser while the key is held, or the pencil if the eraser is active"), [this] {
        const Session& session = studio_.session();
        const bool erases = session.tool().info().kind == ToolKind::kErases;
        const Tool* other = session.first_tool(erases ? ToolKind::kDraws : ToolKind::kErases);
        if (other) borrow(text_of(other->info().id), true);
      });
  swap->setAutoRepeat(false);
  connect(&studio_, &Studio::shown, this, &ToolKeys::note_use);
  const auto check = [this] {
    for (const auto& tool : studio_.session().tools()) {
      const QString id = text_of(tool->info().id);
      QAction* action = actions_.find(QStringLiteral("tool.") + id);
      if (action && action->isCheckable()) action->setChecked(id == tool_in_hand());
    }
  };
  connect(&studio_, &Studio::tool_changed, this, check);
  check();
  qApp->installEventFilter(this);
}

QString ToolKeys::tool_in_hand() const {
  return text_of(studio_.session().tool().info().id);
}

void ToolKeys::choose(const QString& tool) {
  borrow(tool, false);
}

/// Selects the tool. The release of the key determines whether it stays selected.
void ToolKeys::borrow(const QString& tool, bool always) {
  // The action may already have selected the tool.
  const QString former = held_.key ? held_.former : last_key_ ? before_ : tool_in_hand();
  owed_.clear();
  if (tool_in_hand() != tool) studio_.apply(SelectTool{tool.toStdString()});
  held_ = {};
  if (last_key_) held_ = {last_key_, former, now_ms(), false, always};
  if (!last_key_ && always) return;  // triggered from the menu: no key is held
}

void ToolKeys::note_use() {
  const bool is_down = in_contact(studio_.pen().sample) || studio_.session().gesture_in_progress();
  if (held_.key && is_down) held_.is_used = true;
  if (!owed_.isEmpty() && !is_down) give_back();
}

void ToolKeys::release() {
  const Held held = std::exchange(held_, {});
  const bool is_held = now_ms() - held.since_ms >= kHoldMs;
  if (!held.key || (!held.gives_back_always && !(is_held && held.is_used))) return;
  owed_ = held.former;
  note_use();
}

void ToolKeys::give_back() {
  const QString tool = std::exchange(owed_, {});
  if (tool != tool_in_hand()) studio_.apply(SelectTool{tool.toStdString()});
}

bool ToolKeys::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
      const auto* key = static_cast<QKeyEvent*>(event);
      last_key_ = key->isAutoRepeat() ? 0 : key->key();
      if (event->type() == QEvent::ShortcutOverride) before_ = tool_in_hand();
      break;
    }
    case QEvent::KeyRelease: {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->isAutoRepeat()) break;
      last_key_ = 0;
      if (held_.key == key->key()) release();
      break;
    }
    case QEvent::MouseButtonPress:
      last_key_ = 0;  // an action that is triggered now is triggered by a click and not by a key
      break;
    case QEvent::WindowDeactivate:
      if (watched == window_) {
        last_key_ = 0;
        release();
      }
      break;
    default:
      break;
  }
  return false;
}

}  // namespace felt::desktop
