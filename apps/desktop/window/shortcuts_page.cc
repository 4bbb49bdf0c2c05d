#include "desktop/window/shortcuts_page.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QHeaderView>
#include <QMessageBox>

#include "desktop/engine/key_setting_keys.h"
#include "desktop/engine/settings.h"
#include "desktop/window/menus.h"

namespace felt::desktop {
namespace {

constexpr int kNameRole = Qt::UserRole;

QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QChar(0x2026));
}

QString keys_text(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) {
    keys.push_back(key.toString(QKeySequence::NativeText));
  }
  return keys.join(QStringLiteral(", "));
}

}  // namespace

ShortcutsPage::ShortcutsPage(Actions& actions, QWidget* parent)
    : QWidget(parent),
      actions_(actions),
      search_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      key_(new KeyEdit(this)),
      remove_(new QPushButton(tr("&No key"), this)),
      reset_(new QPushButton(tr("&Reset"), this)),
      warning_(new QLabel(this)),
      take_(new QPushButton(tr("Reass&ign"), this)) {
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search the commands"));
  search_->setClearButtonEnabled(true);
  key_->setAccessibleName(tr("New key"));
  warning_->setWordWrap(true);
  auto* reset_all = new QPushButton(tr("Reset &all"), this);
  make_list();
  auto* label = new QLabel(tr("&Key:"), this);
  label->setBuddy(key_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(key_, 1);
  for (QPushButton* button : {remove_, reset_, reset_all}) row->addWidget(button);
  auto* clash = new QHBoxLayout;
  clash->addWidget(warning_, 1);
  clash->addWidget(take_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(make_switch());
  all->addWidget(search_);
  all->addWidget(list_, 1);
  all->addLayout(row);
  all->addLayout(clash);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::show_current);
  connect(key_, &KeyEdit::pressed, this, &ShortcutsPage::press);
  connect(take_, &QPushButton::clicked, this, &ShortcutsPage::take_over);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (QAction* action = current()) actions_.set_keys(action->objectName(), {});
  });
  connect(reset_, &QPushButton::clicked, this, [this] {
    if (QAction* action = current()) actions_.reset_keys(action->objectName());
  });
  connect(reset_all, &QPushButton::clicked, this, [this] {
    const auto answer = QMessageBox::question(this, tr("Reset all keys"),
                                              tr("Restore the default keys of all commands?"));
    if (answer != QMessageBox::Yes) return;
    for (QAction* action : actions_.all()) actions_.reset_keys(action->objectName());
  });
  connect(&actions_, &Actions::keys_changed, this, &ShortcutsPage::refresh);
  refresh();
  show_current();
}

/// Returns the switch for all keys that are a single character.
QWidget* ShortcutsPage::make_switch() {
  auto* letters = new QCheckBox(tr("&Letters, digits and signs alone are keys"), this);
  letters->setObjectName(QStringLiteral("single_characters"));
  letters->setToolTip(tr("Switch this off if speech input or accidental presses trigger commands"));
  letters->setChecked(Settings::the().flag(key_keys::kSingleCharacters, true));
  connect(letters, &QCheckBox::toggled, this,
          [](bool on) { Settings::the().set(key_keys::kSingleCharacters, on); });
  return letters;
}

void ShortcutsPage::make_list() {
  list_->setAccessibleName(tr("Commands and their keys"));
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->setUniformRowHeights(true);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(false);
  QMap<QString, QTreeWidgetItem*> groups;
  for (const QAction* action : actions_.all()) {
    const QString title = menu_title_of(action->objectName());
    if (title.isEmpty()) continue;
    QTreeWidgetItem*& group = groups[title];
    if (!group) {
      group = new QTreeWidgetItem(list_, {title});
      group->setFlags(Qt::ItemIsEnabled);
      group->setFirstColumnSpanned(true);
    }
    auto* item = new QTreeWidgetItem(group, {plain(action->text())});
    item->setData(0, kNameRole, action->objectName());
    item->setToolTip(0, action->statusTip());
  }
  list_->expandAll();
}

QAction* ShortcutsPage::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? actions_.find(item->data(0, kNameRole).toString()) : nullptr;
}

void ShortcutsPage::refresh() {
  for (QTreeWidgetItemIterator it(list_); *it; ++it) {
    const QAction* action = actions_.find((*it)->data(0, kNameRole).toString());
    if (!action) continue;
    (*it)->setText(1, keys_text(*action));
    QFont font = list_->font();
    font.setBold(action->shortcuts() != actions_.default_keys(action->objectName()));
    (*it)->setFont(1, font);
  }
  show_current();
}

void ShortcutsPage::show_current() {
  const QAction* action = current();
  for (QWidget* widget : {static_cast<QWidget*>(key_), static_cast<QWidget*>(remove_)}) {
    widget->setEnabled(action != nullptr);
  }
  reset_->setEnabled(action && action->shortcuts() != actions_.default_keys(action->objectName()));
  key_->set_key(action ? action->shortcut() : QKeySequence());
  set_conflict(nullptr, {});
}

void ShortcutsPage::filter(const QString& text) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* group = list_->topLevelItem(i);
    bool any = false;
    for (int k = 0; k < group->childCount(); ++k) {
      QTreeWidgetItem* item = group->child(k);
      const bool fits = item->text(0).contains(text, Qt::CaseInsensitive) ||
                        item->text(1).contains(text, Qt::CaseInsensitive);
      item->setHidden(!fits);
      any |= fits;
    }
    group->setHidden(!any);
  }
}

void ShortcutsPage::select(const QString& action) {
  for (QTreeWidgetItemIterator it(list_); *it; ++it) {
    if ((*it)->data(0, kNameRole).toString() == action) list_->setCurrentItem(*it);
  }
}

void ShortcutsPage::press(const QKeySequence& key) {
  QAction* action = current();
  if (!action || action->shortcuts().contains(key)) return;
  if (QAction* owner = actions_.owner_of(key, action)) return set_conflict(owner, key);
  actions_.set_keys(action->objectName(), {key});
}

void ShortcutsPage::set_conflict(QAction* action, const QKeySequence& key) {
  conflict_ = action;
  wanted_ = key;
  warning_->setText(action ? tr("%1 belongs to \u201c%2\u201d.")
                                 .arg(key.toString(QKeySequence::NativeText), plain(action->text()))
                           : QString());
  take_->setVisible(action != nullptr);
}

void ShortcutsPage::take_over() {
  QAction* action = current();
  if (!action || !conflict_) return;
  const QKeySequence key = wanted_;
  QList<QKeySequence> left = conflict_->shortcuts();
  left.removeAll(key);
  const QString name = action->objectName();
  actions_.set_keys(conflict_->objectName(), left);
  actions_.set_keys(name, {key});
}

}  // namespace felt::desktop
