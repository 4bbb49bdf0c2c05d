#include "desktop/panels/tool_bar.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <string>

#include "desktop/engine/tool_size.h"
#include "desktop/engine/tool_texts.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

QString tool_text(const char* english) {
  return QCoreApplication::translate("ToolActions", english);
}

QString qstring(std::string_view view) {
  return QString::fromUtf8(view.data(), qsizetype(view.size()));
}

QString action_name(std::string_view tool) {
  return QStringLiteral("tool.") + qstring(tool);
}

/// Changes an option of the current tool by one tenth. The option is a share, 0..1.
void change_share(Studio& studio, std::string_view option, bool up) {
  const ToolInfo& info = studio.session().tool().info();
  const auto row = std::find_if(info.options.begin(), info.options.end(),
                                [&](const OptionSpec& spec) { return spec.id == option; });
  if (row == info.options.end() || row->kind != OptionKind::kNumber) return;
  const std::string id = std::string(info.id) + "." + std::string(option);
  const Result<OptionValue> now = studio.session().option(id);
  if (!now) return;
  const double old = std::get<double>(*now);
  const double wanted = std::round((old + (up ? 0.1 : -0.1)) * 10.0) / 10.0;
  const double value = std::clamp(wanted, row->min, row->max);
  if (value != old) studio.apply(SetOption{id, value});
}

void add_tool(Actions& actions, Studio& studio, QActionGroup* group, const ToolInfo& info) {
  QList<QKeySequence> keys;
  if (info.shortcut != 0) {
    keys.push_back(QKeySequence(QString(QChar::fromLatin1(info.shortcut)).toUpper()));
  }
  const std::string id(info.id);
  QAction* action = actions.add(action_name(info.id), translated(info.label), keys,
                                translated(info.help), [&studio, id] {
                                  if (studio.session().tool().info().id == id) return;
                                  studio.apply(SelectTool{id});
                                });
  action->setCheckable(true);
  action->setIcon(icon_of(info.id));
  group->addAction(action);
}

void add_sizes(Actions& actions, Studio& studio) {
  const auto size = [&](const char* name, const QString& label, Qt::Key key, const QString& tip,
                        bool up) {
    return actions.add(QString::fromLatin1(name), label, {QKeySequence(key)}, tip,
                       [&studio, up] { step_tool_size(studio, up); });
  };
  size("tool.size_down", tool_text(QT_TRANSLATE_NOOP("ToolActions", "S&maller")),
       Qt::Key_BracketLeft,
       tool_text(QT_TRANSLATE_NOOP("ToolActions", "Makes the current tool smaller.")), false)
      ->setIcon(icon_of("size-down"));
  size("tool.size_up", tool_text(QT_TRANSLATE_NOOP("ToolActions", "&Larger")), Qt::Key_BracketRight,
       tool_text(QT_TRANSLATE_NOOP("ToolActions", "Makes the current tool larger.")), true)
      ->setIcon(icon_of("size-up"));
}

void add_strengths(Actions& actions, Studio& studio) {
  const auto strength = [&](const char* name, const QString& label, Qt::Key bracket,
                            const QString& tip, bool up) {
    return actions.add(QString::fromLatin1(name), label, {QKeySequence(Qt::SHIFT | bracket)}, tip,
                       [&studio, up] { change_share(studio, "strength", up); });
  };
  strength("tool.strength_down", tool_text(QT_TRANSLATE_NOOP("ToolActions", "Forces &weaker")),
           Qt::Key_BracketLeft,
           tool_text(QT_TRANSLATE_NOOP("ToolActions", "The current tool resists less.")), false)
      ->setIcon(icon_of("force-on"));
  strength("tool.strength_up", tool_text(QT_TRANSLATE_NOOP("ToolActions", "Forces &stronger")),
           Qt::Key_BracketRight,
           tool_text(QT_TRANSLATE_NOOP("ToolActions", "The current tool resists more.")), true)
      ->setIcon(icon_of("force-on"));
}

}  // namespace

void add_tool_actions(Actions& actions, Studio& studio) {
  auto* group = new QActionGroup(&actions);
  for (const auto& tool : studio.session().tools()) add_tool(actions, studio, group, tool->info());
  add_sizes(actions, studio);
  add_strengths(actions, studio);
  const auto follow = [&actions, &studio] {
    QAction* action = actions.find(action_name(studio.session().tool().info().id));
    if (action) action->setChecked(true);
  };
  QObject::connect(&studio, &Studio::tool_changed, group, follow);
  QObject::connect(&studio, &Studio::opened, group, follow);
  follow();
}

ToolBar::ToolBar(Studio& studio, const Actions& actions, QWidget* parent)
    : QToolBar(tr("Tools"), parent), studio_(studio), actions_(actions) {
  setObjectName(QStringLiteral("tool_bar"));
  setAccessibleName(tr("Tools"));
  setIconSize({24, 24});
  setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  int widest = 0;
  for (const auto& tool : studio.session().tools()) {
    QAction* action = actions.find(action_name(tool->info().id));
    if (!action) continue;
    addAction(action);
    auto* button = qobject_cast<QToolButton*>(widgetForAction(action));
    button->setAccessibleName(action->text());
    button->setFocusPolicy(Qt::TabFocus);
    widest = std::max(widest, button->sizeHint().width());
  }
  // All buttons get the width of the widest name, so that they align.
  for (QAction* action : this->actions()) widgetForAction(action)->setMinimumWidth(widest);
  connect(&studio, &Studio::tool_changed, this, &ToolBar::follow_tool);
  follow_tool();
}

void ToolBar::follow_tool() {
  const QString now = qstring(studio_.session().tool().info().id);
  const bool borrows = studio_.is_borrowing();
  if (!borrows) home_ = now;
  for (const auto& tool : studio_.session().tools()) {
    QWidget* button = widgetForAction(actions_.find(action_name(tool->info().id)));
    if (!button) continue;
    const QString id = qstring(tool->info().id);
    const bool comes_back = borrows && id == home_ && id != now;
    const bool is_lent = borrows && id == now && id != home_;
    QFont font = button->font();
    font.setItalic(is_lent);
    font.setUnderline(comes_back);
    button->setFont(font);
    button->setAccessibleDescription(is_lent      ? tr("active while the key is held")
                                     : comes_back ? tr("returns when the key is released")
                                     : id == now  ? tr("active")
                                                  : QString());
  }
}

}  // namespace felt::desktop
