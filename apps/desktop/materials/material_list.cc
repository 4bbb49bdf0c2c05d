#include "desktop/materials/material_list.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>

#include "desktop/materials/material_editor_model.h"

namespace felt::desktop {
namespace {

constexpr int kSurfaceRole = Qt::UserRole, kMaterialIdRole = Qt::UserRole + 1;

}  // namespace

MaterialList::MaterialList(QWidget* parent) : QTreeWidget(parent) {
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(12);
  setExpandsOnDoubleClick(false);
  setItemsExpandable(false);
  setUniformRowHeights(true);
  setAccessibleName(tr("Surfaces and media"));
  setTextElideMode(Qt::ElideRight);
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (!item || item->data(0, kMaterialIdRole).isNull()) return;
    Q_EMIT chosen({item->data(0, kSurfaceRole).toBool(),
                   item->data(0, kMaterialIdRole).toString().toStdString()});
  });
}

void MaterialList::show_materials(const Materials& known, const MaterialEditorModel& model) {
  std::vector<Row> rows;
  const auto add = [&](const AnyMaterial& material) {
    const MaterialKey key = key_of(material);
    const UserMaterials::Entry* entry = model.own_of(key);
    rows.push_back({key, name_of(entry ? entry->now : material),
                    words_of(entry ? entry->now : material), !is_built_in(key),
                    entry && entry->is_changed()});
  };
  for (const SurfaceMaterial& surface : known.surfaces()) add(surface);
  // The built-in eraser is not listed, because it is a tool.
  for (const Medium& medium : known.media()) {
    if (medium.draws || model.own_of({false, medium.id})) add(medium);
  }
  if (rows == rows_) return;
  rows_ = std::move(rows);
  fill();
}

void MaterialList::fill() {
  const QTreeWidgetItem* current = currentItem();
  const MaterialKey chosen_now{
      current && current->data(0, kSurfaceRole).toBool(),
      current ? current->data(0, kMaterialIdRole).toString().toStdString() : std::string()};
  const QSignalBlocker quiet(this);
  clear();
  struct Group {
    QString name;
    bool is_surface, is_own;
  };
  for (const Group& group :
       {Group{tr("Surfaces"), true, false}, Group{tr("My surfaces"), true, true},
        Group{tr("Media"), false, false}, Group{tr("My media"), false, true}}) {
    QTreeWidgetItem* head = nullptr;
    for (const Row& row : rows_) {
      if (row.key.is_surface != group.is_surface || row.is_own != group.is_own) continue;
      if (!head) {
        head = new QTreeWidgetItem(this, {group.name});
        head->setFlags(Qt::ItemIsEnabled);
        QFont font = this->font();
        font.setBold(true);
        head->setFont(0, font);
      }
      auto* item = new QTreeWidgetItem(head);
      item->setText(0, row.is_changed ? tr("%1 \u2022 not saved").arg(row.name) : row.name);
      item->setToolTip(0, row.words);
      item->setData(0, kSurfaceRole, row.key.is_surface);
      item->setData(0, kMaterialIdRole, QString::fromStdString(row.key.id));
    }
  }
  expandAll();
  setCurrentItem(item_of(chosen_now));
}

QTreeWidgetItem* MaterialList::item_of(const MaterialKey& key) const {
  for (int group = 0; group < topLevelItemCount(); ++group) {
    for (int i = 0; i < topLevelItem(group)->childCount(); ++i) {
      QTreeWidgetItem* item = topLevelItem(group)->child(i);
      if (item->data(0, kSurfaceRole).toBool() == key.is_surface &&
          item->data(0, kMaterialIdRole).toString().toStdString() == key.id) {
        return item;
      }
    }
  }
  return nullptr;
}

void MaterialList::show_chosen(const MaterialKey& key) {
  const QSignalBlocker quiet(this);
  QTreeWidgetItem* item = item_of(key);
  setCurrentItem(item);
  if (item) scrollToItem(item);
}

std::vector<MaterialKey> MaterialList::keys() const {
  std::vector<MaterialKey> keys;
  for (const Row& row : rows_) keys.push_back(row.key);
  return keys;
}

}  // namespace felt::desktop
