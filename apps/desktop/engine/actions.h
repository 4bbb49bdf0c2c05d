#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <map>

namespace felt::desktop {

/// The table of a window's commands by name: "edit.undo", "view.fit_page". The menus, the tool bar,
/// the shortcut sheet, the page for changing shortcuts and the monkey test all use this table, so
/// that each of them reaches every command. Each folder adds its commands; the window puts them
/// into menus.
///
/// A name is menu "." command. The user's shortcuts are stored in the settings "shortcuts/NAME" and
/// replace the default keys. Use this class in Qt's main thread.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  /// Adds a command to the window; its keys work in every widget of the window. `text` is
  /// translated and contains the mnemonic; `tip` is one sentence.
  QAction* add(const QString& name, const QString& text, const QList<QKeySequence>& keys,
               const QString& tip, std::function<void()> run);
  /// Adds a command that is switched on or off.
  QAction* add_switch(const QString& name, const QString& text, const QList<QKeySequence>& keys,
                      const QString& tip, bool on, std::function<void(bool)> run);
  /// Returns null if no command has that name.
  [[nodiscard]] QAction* find(const QString& name) const;
  /// Returns all commands, in the order in which they were added.
  [[nodiscard]] const QList<QAction*>& all() const noexcept { return actions_; }
  /// Returns the default keys of a command, which were passed when it was added.
  [[nodiscard]] QList<QKeySequence> default_keys(const QString& name) const;
  /// Sets the user's keys for a command and stores them, so that they apply in every window. An
  /// empty list means no keys.
  void set_keys(const QString& name, const QList<QKeySequence>& keys);
  /// Restores the default keys of a command.
  void reset_keys(const QString& name);
  /// Returns the command that this key triggers now, or null if there is none. Ignores the command
  /// `but`.
  [[nodiscard]] QAction* owner_of(const QKeySequence& key, const QAction* but = nullptr) const;

 Q_SIGNALS:
  void keys_changed(const QString& name);

 private:
  QAction* make(const QString& name, const QString& text, const QList<QKeySequence>& keys,
                const QString& tip);
  void take_keys(QAction* action);

  QWidget* window_;
  QList<QAction*> actions_;
  std::map<QString, QList<QKeySequence>> defaults_;
};

}  // namespace felt::desktop
