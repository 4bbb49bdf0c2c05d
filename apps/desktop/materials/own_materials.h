#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "desktop/materials/material_names.h"
#include "felt/base/result.h"

namespace felt::desktop {

/// The user-defined surfaces and media of all windows: the files of the data folder
/// (feltline/materials/*.toml in XDG_DATA_HOME), and unsaved changes. The changes are kept in the
/// settings between starts, so that closing a window asks nothing and loses nothing. A stored
/// change that cannot be read is reported as a problem, and stays stored.
///
/// Qt's main thread.
class OwnMaterials : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    AnyMaterial now;
    std::optional<AnyMaterial> saved;  ///< content of the file; none: there is no file yet
    std::string path = {};             ///< of the file; "" if there is none

    [[nodiscard]] bool is_changed() const { return !saved || *saved != now; }
  };

  /// Returns the one of the process, for material_folders(); read at the first call.
  static OwnMaterials& the();
  /// Uses these folders, which need not exist; saves into the first.
  explicit OwnMaterials(std::vector<std::string> folders, QObject* parent = nullptr);
  ~OwnMaterials() override;

  /// Returns all entries, sorted by key: surfaces first.
  [[nodiscard]] std::vector<const Entry*> all() const;
  /// Returns null if there is none.
  [[nodiscard]] const Entry* find(const MaterialKey& key) const;
  /// Returns the built-in materials, and the user-defined ones in their present state.
  [[nodiscard]] Materials known() const;
  /// Returns the problems of reading files and stored changes, "chalk.toml:7: ...", one each. A
  /// second call returns none of them again.
  QStringList take_problems() { return std::exchange(problems_, {}); }
  /// Returns true if the id is that of a built-in or user-defined surface or medium.
  [[nodiscard]] bool is_taken(const std::string& id) const;

  /// Sets the present state of a material, unsaved. Requires that it is not built in.
  void put(const AnyMaterial& now);
  /// Restores the content of its file; removes it if it has no file.
  void revert(const MaterialKey& key);
  /// Writes it to its file in the user's folder, whole or not at all. Does not replace a file that
  /// was changed since it was last read or saved here, because that is someone's work. Fails in
  /// that case, or with an error of the disk; names file and reason, and it stays unsaved.
  Result<void> save(const MaterialKey& key);
  /// Returns "" if remove() may delete it; otherwise the reason: its file is not the user's, but in
  /// a folder for all users (XDG_DATA_DIRS).
  [[nodiscard]] QString kept_because(const MaterialKey& key) const;
  /// Deletes it and its file; a file that is already gone is no error. Fails for the reason of
  /// kept_because(), for a file that was changed since it was last read or saved here, or with an
  /// error of the disk; then it still exists.
  Result<void> remove(const MaterialKey& key);
  /// Writes unsaved changes to the settings now, without the usual delay.
  void keep_changes();

 Q_SIGNALS:
  /// One was changed, added, saved or removed.
  void changed(const felt::desktop::MaterialKey& key);

 private:
  void read_changes();
  Result<void> remove_file(const Entry& entry) const;
  [[nodiscard]] std::string own_folder() const;

  std::vector<std::string> folders_;
  std::map<MaterialKey, Entry> entries_;
  QStringList problems_;
  QStringList unread_;  // stored changes that this version cannot read, but another may
  QTimer keep_;
};

}  // namespace felt::desktop
