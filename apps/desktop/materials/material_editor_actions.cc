// The actions and dialogs of the material editor.
#include <QCoreApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QToolButton>
#include <utility>

#include "desktop/materials/material_editor.h"
#include "desktop/panels/tool_icons.h"
#include "felt/io/picture/png.h"

namespace felt::desktop {
namespace {

constexpr auto kIconName = "icon_name";

QString qstring(const std::string& text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

}  // namespace

QAction* MaterialEditor::action(const char* name) const {
  for (QAction* action : actions_) {
    if (action->objectName() == QLatin1String(name)) return action;
  }
  return nullptr;
}

QAction* MaterialEditor::add_action(const char* name, const QString& text, const QString& tip,
                                    const QList<QKeySequence>& keys, const char* icon,
                                    std::function<void()> run) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setShortcuts(keys);
  action->setToolTip(keys.isEmpty() ? tip
                                    : QStringLiteral("%1 (%2)").arg(
                                          tip, keys.front().toString(QKeySequence::NativeText)));
  action->setProperty(kIconName, QString::fromLatin1(icon));
  connect(action, &QAction::triggered, this, std::move(run));
  addAction(action);
  actions_.push_back(action);
  return action;
}

void MaterialEditor::make_actions() {
  add_action("undo", tr("Undo"), tr("Undo"), {QKeySequence(Qt::CTRL | Qt::Key_Z)}, "undo",
             [this] { model_.steps().undo(); });
  add_action("redo", tr("Redo"), tr("Redo"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
             "redo", [this] { model_.steps().redo(); });
  add_action("revert", tr("Revert"),
             tr("Restores all values as they were at first, or when last saved"), {}, "reset",
             [this] { model_.revert(); });
  add_action("flip", tr("Compare: %1").arg(QLatin1Char('A')), {}, {QKeySequence(Qt::Key_B)}, "",
             [this] { model_.flip(); });
  add_action("copy_to_other", tr("Copy %1 to %2").arg(QLatin1Char('A')).arg(QLatin1Char('B')),
             tr("Copies these values to the other material"), {}, "",
             [this] { model_.copy_to_other(); });
  add_action("save", tr("Save"), tr("Save to your own file"), {QKeySequence(Qt::CTRL | Qt::Key_S)},
             "save",
             [this] { report(model_.save(), tr("%1 was saved.").arg(name_of(model_.now()))); });
  add_action("save_as", tr("Save as\u2026"), tr("Save under another name, as your own"),
             {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}, "save", [this] { ask_save_as(); });
  add_action("rename", tr("Rename\u2026"), tr("Changes the name"), {QKeySequence(Qt::Key_F2)},
             "rename", [this] { ask_rename(); });
  add_action("delete", tr("Delete"), tr("Deletes the material and its file; undo restores both"),
             {}, "delete", [this] {
               const QString name = name_of(model_.now());
               report(model_.remove(), tr("%1 was deleted. Undo restores it.").arg(name));
             });
  add_action("import", tr("Import\u2026"), tr("Add a material from a file"), {}, "import",
             [this] { ask_import(); });
  add_action("export", tr("Export\u2026"), tr("Write a file to share"), {}, "export",
             [this] { ask_export(); });
}

QToolBar* MaterialEditor::make_bar() {
  auto* bar = new QToolBar(this);
  bar->setIconSize(QSize(18, 18));
  bar->setWindowTitle(tr("Materials"));
  const auto add = [&](const char* name, Qt::ToolButtonStyle style) {
    bar->addAction(action(name));
    auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action(name)));
    button->setToolButtonStyle(style);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action(name)->text());
  };
  for (const char* name : {"undo", "redo", "revert"}) add(name, Qt::ToolButtonIconOnly);
  bar->addSeparator();
  add("flip", Qt::ToolButtonTextOnly);
  add("copy_to_other", Qt::ToolButtonTextOnly);
  bar->addSeparator();
  add("save", Qt::ToolButtonTextBesideIcon);
  auto* more = new QToolButton(bar);
  more->setText(tr("More"));
  more->setAccessibleName(tr("More commands"));
  more->setPopupMode(QToolButton::InstantPopup);
  more->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(more);
  menu->setToolTipsVisible(true);  // the tool tip of a disabled entry gives the reason
  for (const char* name : {"save_as", "rename", "delete"}) menu->addAction(action(name));
  menu->addSeparator();
  for (const char* name : {"import", "export"}) menu->addAction(action(name));
  more->setMenu(menu);
  bar->addWidget(more);
  draw_icons();
  return bar;
}

void MaterialEditor::draw_icons() {
  for (QAction* action : actions_) {
    const QString icon = action->property(kIconName).toString();
    if (!icon.isEmpty()) action->setIcon(icon_of(icon.toStdString()));
  }
}

void MaterialEditor::ask_relief() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Relief from a picture"), {}, tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  const Result<HeightPicture> picture = read_height_png(path.toStdString());
  if (!picture) return report(qstring(picture.error().message));
  report(model_.take_relief(*picture), {});
}

void MaterialEditor::ask_save_as() {
  bool ok = false;
  const QString name = QInputDialog::getText(this, tr("Save as"), tr("Name:"), QLineEdit::Normal,
                                             name_of(model_.now()), &ok);
  if (!ok || name.trimmed().isEmpty()) return;
  report(model_.save_as(name), tr("%1 was saved.").arg(name));
}

void MaterialEditor::ask_rename() {
  if (!model_.is_own()) return;
  bool ok = false;
  const QString name = QInputDialog::getText(this, tr("Rename"), tr("Name:"), QLineEdit::Normal,
                                             name_of(model_.now()), &ok);
  if (ok) model_.rename(name);
}

void MaterialEditor::ask_import() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Import"), {}, tr("Materials (*.toml)"));
  if (path.isEmpty()) return;
  report(model_.import_file(path), tr("It is yours now, but not saved yet."));
}

void MaterialEditor::ask_export() {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export"), qstring(model_.key().id + ".toml"), tr("Materials (*.toml)"));
  if (path.isEmpty()) return;
  report(model_.export_file(path), tr("%1 was exported.").arg(path));
}

/// Handles undo keys in a number field. They undo a step of the editor, because typed numbers have
/// no steps of undo.
bool MaterialEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace felt::desktop
