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

/// A person's own sheets and media, of all windows: what lies in the data folder
/// (feltline/materials/*.toml in XDG_DATA_HOME), and what has been changed and not been saved. That
/// is kept, too: in the settings, from one start to the next, so that nobody is asked when a window
/// is closed, and nothing is lost. What is kept there and cannot be read is a problem, and is kept
/// on.
///
/// Qt's main thread.
class OwnMaterials : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    AnyMaterial now;
    std::optional<AnyMaterial> saved;  ///< what the file has; none: there is no file yet
    std::string path = {};             ///< of the file; "" where there is none

    [[nodiscard]] bool is_changed() const { return !saved || *saved != now; }
  };

  /// One per process, for material_folders(); read when first asked for.
  static OwnMaterials& the();
  /// For these folders, which need not exist; what is saved goes into the first.
  explicit OwnMaterials(std::vector<std::string> folders, QObject* parent = nullptr);
  ~OwnMaterials() override;

  /// By key: sheets first.
  [[nodiscard]] std::vector<const Entry*> all() const;
  /// Null where there is none.
  [[nodiscard]] const Entry* find(const MaterialKey& key) const;
  /// Those that Feltline brings, and one's own as they are now.
  [[nodiscard]] Materials known() const;
  /// What was wrong with files, and with what was kept, when they were read: "chalk.toml:7: ...",
  /// one each; told once.
  QStringList take_problems() { return std::exchange(problems_, {}); }
  /// Whether an id is one of those that Feltline brings or of one's own, of a sheet or a medium.
  [[nodiscard]] bool is_taken(const std::string& id) const;

  /// It is so from now on, and not saved. Requires one that is not built in.
  void put(const AnyMaterial& now);
  /// As in its file again; gone where it has none.
  void revert(const MaterialKey& key);
  /// Into its file in the person's folder, whole or not at all. A file there that is not as it was
  /// read or saved here last is somebody's work, and is not replaced. Error: that, or the disk's;
  /// says file and reason, and it stays unsaved.
  Result<void> save(const MaterialKey& key);
  /// "" for one that remove() may take away; else why it may not: its file is not the person's,
  /// but lies in a folder for all users (XDG_DATA_DIRS).
  [[nodiscard]] QString kept_because(const MaterialKey& key) const;
  /// Gone, its file too; a file that is gone already is no error. Error: kept_because, a file that
  /// is not as it was read or saved here last, or the disk's; then it is still there.
  Result<void> remove(const MaterialKey& key);
  /// What has changed is written to the settings now, not in a moment.
  void keep_changes();

 Q_SIGNALS:
  /// One is other than it was, new, saved or gone.
  void changed(const felt::desktop::MaterialKey& key);

 private:
  void read_changes();
  Result<void> remove_file(const Entry& entry) const;
  [[nodiscard]] std::string own_folder() const;

  std::vector<std::string> folders_;
  std::map<MaterialKey, Entry> entries_;
  QStringList problems_;
  QStringList unread_;  // what was kept and cannot be read, perhaps by this version only
  QTimer keep_;
};

}  // namespace felt::desktop
