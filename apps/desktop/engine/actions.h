#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <functional>
#include <map>

namespace felt::desktop {

/// Everything that can be asked of a window, by name: "edit.undo", "view.fit_page". Menus, tool
/// bar, shortcut sheet, remapping and the monkey test all go by this table, so that nothing can be
/// done in one way only. Each room adds what it can do; the window puts it into menus.
///
/// Names: menu "." command. The shortcuts a person chose are settings "shortcuts/NAME", and replace
/// the ones given here. Qt's main thread.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QWidget* window);

  /// Adds one, on the window, so that its keys work wherever the focus is. `text` is translated and
  /// has its mnemonic; `tip` one sentence.
  QAction* add(const QString& name, const QString& text, const QList<QKeySequence>& keys,
               const QString& tip, std::function<void()> run);
  /// The same, on or off.
  QAction* add_switch(const QString& name, const QString& text, const QList<QKeySequence>& keys,
                      const QString& tip, bool on, std::function<void(bool)> run);
  /// Null where there is none.
  [[nodiscard]] QAction* find(const QString& name) const;
  /// In the order of adding.
  [[nodiscard]] const QList<QAction*>& all() const noexcept { return actions_; }
  /// The keys that it came with.
  [[nodiscard]] QList<QKeySequence> default_keys(const QString& name) const;
  /// Chosen by a person; kept, and so in every window. Empty: no keys.
  void set_keys(const QString& name, const QList<QKeySequence>& keys);
  /// The keys that it came with, again.
  void reset_keys(const QString& name);
  /// The one that has this key now, or null; `but` is not looked at.
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
