#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/window/key_edit.h"

namespace felt::desktop {

/// The page of all actions and their keys, with search and editing. If a key belongs to another
/// action, it is reassigned only after the user confirms; the other action then has no key.
class ShortcutsPage : public QWidget {
  Q_OBJECT

 public:
  ShortcutsPage(Actions& actions, QWidget* parent = nullptr);

  /// Selects that action in the list.
  void select(const QString& action);
  /// Handles a key that was pressed in the key field.
  void press(const QKeySequence& key);
  /// Returns true if the key belongs to another action, which the conflict line names.
  [[nodiscard]] bool has_conflict() const noexcept { return conflict_ != nullptr; }
  /// Assigns the key to the selected action and removes it from the other one.
  void take_over();

 private:
  QWidget* make_switch();
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
