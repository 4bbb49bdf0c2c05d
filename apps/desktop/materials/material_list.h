#pragma once

#include <QTreeWidget>

#include "desktop/materials/own_materials.h"

namespace felt::desktop {

/// Sheets and media, those that Feltline brings and one's own, in four groups. One's own that are
/// not saved have a dot and say so. Says which one is chosen, by mouse or keys.
class MaterialList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit MaterialList(QWidget* parent = nullptr);

  /// `known`: what a session has; `own`: a person's.
  void show_materials(const Materials& known, const OwnMaterials& own);
  void show_chosen(const MaterialKey& key);
  /// Of the rows, in their order.
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
