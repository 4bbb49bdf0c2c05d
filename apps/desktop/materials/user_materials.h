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

/// The user-defined surfaces and media of all windows: the files in the data folder
/// (feltline/materials/*.toml in XDG_DATA_HOME), and unsaved changes. Unsaved changes are stored in
/// the settings, so that a window can be closed without asking the user and without losing them. If
/// a stored change cannot be read, it is reported as a problem and stays stored.
///
/// Use it in Qt's main thread.
class UserMaterials : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    AnyMaterial now;
    std::optional<AnyMaterial> saved;  ///< content of the file; nullopt if it has no file yet
    std::string path = {};             ///< path of the file; "" if it has no file

    [[nodiscard]] bool is_changed() const { return !saved || *saved != now; }
  };

  /// Returns the object of this process, which uses material_folders(). The files are read at the
  /// first call.
  static UserMaterials& the();
  /// Uses these folders, which need not exist. Saves into the first folder.
  explicit UserMaterials(std::vector<std::string> folders, QObject* parent = nullptr);
  ~UserMaterials() override;

  /// Returns all entries, sorted by key: surfaces first.
  [[nodiscard]] std::vector<const Entry*> all() const;
  /// Returns null if no entry has this key.
  [[nodiscard]] const Entry* find(const MaterialKey& key) const;
  /// Returns the built-in materials, and the user-defined materials in their present state.
  [[nodiscard]] Materials known() const;
  /// Returns the problems of reading files and stored changes, such as "chalk.toml:7: ...". Each
  /// problem is returned only once.
  QStringList take_problems() { return std::exchange(problems_, {}); }
  /// Returns true if a built-in or user-defined surface or medium has this id.
  [[nodiscard]] bool is_taken(const std::string& id) const;

  /// Sets the present state of a material, unsaved. Requires that it is not built in.
  void put(const AnyMaterial& now);
  /// Restores the content of the material's file; removes the material if it has no file.
  void revert(const MaterialKey& key);
  /// Writes the material to its file in the user's folder, completely or not at all. Fails if
  /// writing fails. Also fails if the file was changed since it was last read or saved here,
  /// because replacing it would destroy someone's work. The error names the file and the reason;
  /// the material then stays unsaved.
  Result<void> save(const MaterialKey& key);
  /// Returns "" if remove() may delete the material. Otherwise returns a sentence that gives the
  /// reason: the file is in a folder for all users (XDG_DATA_DIRS).
  [[nodiscard]] QString kept_because(const MaterialKey& key) const;
  /// Deletes the material and its file. It is not an error if the file no longer exists. Fails if
  /// kept_because() returns a reason, if the file was changed since it was last read or saved here,
  /// or if the file cannot be deleted. The material then still exists.
  Result<void> remove(const MaterialKey& key);
  /// Writes unsaved changes to the settings now, without the usual delay.
  void keep_changes();

 Q_SIGNALS:
  /// A material was changed, added, saved or removed.
  void changed(const felt::desktop::MaterialKey& key);

 private:
  void read_changes();
  Result<void> remove_file(const Entry& entry) const;
  [[nodiscard]] std::string user_folder() const;

  std::vector<std::string> folders_;
  std::map<MaterialKey, Entry> entries_;
  QStringList problems_;
  QStringList unread_;  // stored changes that this version cannot read
  QTimer keep_;
};

}  // namespace felt::desktop
