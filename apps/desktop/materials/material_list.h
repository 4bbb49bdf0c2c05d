#pragma once

#include <QTreeWidget>
#include <vector>

#include "desktop/materials/material_names.h"

namespace felt::desktop {

class MaterialEditorModel;

/// Lists surfaces and media, built-in and user-defined, in four groups. Unsaved user-defined
/// materials have a dot and are described as unsaved. Emits `chosen` when the user chooses a
/// material by mouse or keys.
class MaterialList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit MaterialList(QWidget* parent = nullptr);

  /// Shows these materials. `model` determines which of them are user-defined, and whether they are
  /// saved.
  void show_materials(const Materials& known, const MaterialEditorModel& model);
  void show_chosen(const MaterialKey& key);
  /// Returns the keys of the rows, from top to bottom.
  [[nodiscard]] std::vector<MaterialKey> keys() const;

 Q_SIGNALS:
  void chosen(const felt::desktop::MaterialKey& key);

 private:
  struct Row {
    MaterialKey key;
    QString name, words;
    bool is_own = false, is_changed = false;

    friend bool operator==(const Row&, const Row&) = default;
  };
  void fill();
  [[nodiscard]] QTreeWidgetItem* item_of(const MaterialKey& key) const;

  std::vector<Row> rows_;
};

}  // namespace felt::desktop
