#include "desktop/panels/layers_model.h"

#include <QFont>
#include <string>

namespace felt::desktop {

LayersModel::LayersModel(Studio& studio, QObject* parent)
    : QAbstractListModel(parent), studio_(studio), thumbnails_(new LayerThumbnails(studio, this)) {
  connect(thumbnails_, &LayerThumbnails::painted, this,
          [this] { Q_EMIT dataChanged(index(0), index(rowCount() - 1), {kThumbnail}); });
  connect(&studio, &Studio::edited, this, [this](const Edit& edit) {
    if (!edit.layers.empty()) refresh();
  });
  connect(&studio, &Studio::opened, this, &LayersModel::refresh);
  connect(&studio, &Studio::layer_changed, this, &LayersModel::refresh);
}

void LayersModel::refresh() {
  beginResetModel();
  endResetModel();
  Q_EMIT refreshed();
}

LayerId LayersModel::layer_at(int row) const {
  const auto layers = studio_.session().document().layers();
  if (row < 0 || row >= static_cast<int>(layers.size())) return {};
  return layers[layers.size() - 1 - static_cast<std::size_t>(row)].id;
}

int LayersModel::row_of(LayerId id) const {
  const auto layers = studio_.session().document().layers();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].id == id) return static_cast<int>(layers.size() - 1 - i);
  }
  return -1;
}

int LayersModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(studio_.session().document().layers().size());
}

/// Returns the name to show. A name that the program has given is translated.
QString LayersModel::shown_name(const Layer& layer) {
  if (layer.name == "Ink") return tr("Ink");
  const QString name = QString::fromStdString(layer.name);
  constexpr auto kNumbered = "Layer ";
  bool is_number = false;
  const int number = name.startsWith(QLatin1String(kNumbered)) ? name.mid(6).toInt(&is_number) : 0;
  return is_number ? tr("Layer %1").arg(number) : name;
}

QString LayersModel::spoken(const Layer& layer) const {
  QString text = tr("%1, %2, %3")
                     .arg(shown_name(layer), layer.visible ? tr("visible") : tr("hidden"),
                          layer.locked ? tr("locked") : tr("unlocked"));
  if (layer.picture) text += tr(", picture");
  if (layer.opacity < 1.0) {
    text += tr(", opacity %1 %").arg(qRound(100.0 * layer.opacity));
  }
  if (layer.id == studio_.session().layer()) text += tr(", current");
  return text;
}

QVariant LayersModel::data(const QModelIndex& index, int role) const {
  const Layer* layer = studio_.session().document().layer(layer_at(index.row()));
  if (!layer) return {};
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return shown_name(*layer);
    case Qt::AccessibleTextRole:
      return spoken(*layer);
    case Qt::ToolTipRole:
      return tr("%1\nDouble-click to rename, drag to move").arg(spoken(*layer));
    case kVisible:
      return layer->visible;
    case kLocked:
      return layer->locked;
    case kInUse:
      return layer->id == studio_.session().layer();
    case kThumbnail:
      return thumbnails_->of(layer->id);
    case kHasPicture:
      return layer->picture != nullptr;
    default:
      return {};
  }
}

bool LayersModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const LayerId id = layer_at(index.row());
  const std::string name = value.toString().trimmed().toStdString();
  if (role != Qt::EditRole || !id || name.empty()) return false;
  const Layer* layer = studio_.session().document().layer(id);
  if (layer && shown_name(*layer).toStdString() == name) return true;  // unchanged
  return studio_.apply(LayerEvent{LayerEvent::Do::kRename, id, name});
}

Qt::ItemFlags LayersModel::flags(const QModelIndex& index) const {
  // Rows can be dropped only between rows, not onto a row.
  if (!index.isValid()) return Qt::ItemIsDropEnabled;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

bool LayersModel::moveRows(const QModelIndex&, int row, int count, const QModelIndex&, int before) {
  const LayerId id = layer_at(row);
  if (count != 1 || !id) return false;
  const int target = before > row ? before - 1 : before;
  const int place = rowCount() - 1 - target;
  if (target == row || place < 0) return false;
  return studio_.apply(LayerEvent{LayerEvent::Do::kMove, id, {}, static_cast<std::size_t>(place)});
}

}  // namespace felt::desktop
