#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/window/key_edit.h"

namespace felt::desktop {

/// All actions and their keys, to search and to change. A key that another action has is taken only
/// when the person says so; that one has no key then.
class ShortcutsPage : public QWidget {
  Q_OBJECT

 public:
  ShortcutsPage(Actions& actions, QWidget* parent = nullptr);

  /// Shows that action in the list.
  void select(const QString& action);
  /// What is pressed in the key field.
  void press(const QKeySequence& key);
  /// The key belongs to another action, which is named in the conflict line.
  [[nodiscard]] bool has_conflict() const noexcept { return conflict_ != nullptr; }
  /// Takes it from there.
  void take_over();

 private:
  void make_list();
  void refresh();
  void show_current();
  void filter(const QString& text);
  void set_conflict(QAction* action, const QKeySequence& key);
  [[nodiscard]] QAction* current() const;

  Actions& actions_;
  QLineEdit* search_;
  QTreeWidget* list_;
  KeyEdit* key_;
  QPushButton* remove_;
  QPushButton* reset_;
  QLabel* warning_;
  QPushButton* take_;
  QAction* conflict_ = nullptr;
  QKeySequence wanted_;
};

}  // namespace felt::desktop
