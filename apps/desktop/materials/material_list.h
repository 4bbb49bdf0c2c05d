#pragma once

#include <QTreeWidget>
#include <vector>

#include "desktop/materials/material_names.h"

namespace felt::desktop {

class MaterialDesk;

/// Sheets and media, those that Feltline brings and one's own, in four groups. One's own that are
/// not saved have a dot and say so. Says which one is chosen, by mouse or keys.
class MaterialList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit MaterialList(QWidget* parent = nullptr);

  /// `known`: what may be chosen; `desk` knows which of them are a person's own, and how they are.
  void show_materials(const Materials& known, const MaterialDesk& desk);
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
