#include "desktop/panels/layers_model.h"

#include <QFont>
#include <algorithm>
#include <string>

namespace felt::desktop {
namespace {

using Do = LayerEvent::Do;

/// Returns a name that the program has given, such as "Layer 3", translated.
QString numbered(const QString& name, QLatin1String prefix, const QString& translated) {
  bool is_number = false;
  const int number = name.startsWith(prefix) ? name.mid(prefix.size()).toInt(&is_number) : 0;
  return is_number ? translated.arg(number) : name;
}

template <class State>
QString look_text(const State& state) {
  QString text;
  if (state.opacity < 1.0) {
    text += LayersModel::tr(", opacity %1 %").arg(qRound(100.0 * state.opacity));
  }
  if (state.blend == BlendMode::kMultiply) text += LayersModel::tr(", multiplies");
  return text;
}

}  // namespace

LayersModel::LayersModel(Studio& studio, QObject* parent)
    : QAbstractListModel(parent), studio_(studio), thumbnails_(new LayerThumbnails(studio, this)) {
  connect(thumbnails_, &LayerThumbnails::painted, this,
          [this] { Q_EMIT dataChanged(index(0), index(rowCount() - 1), {kThumbnail}); });
  connect(&studio, &Studio::edited, this, [this](const Edit& edit) {
    if (!edit.layers.empty()) refresh();
  });
  connect(&studio, &Studio::opened, this, [this] {
    collapsed_.clear();
    refresh();
  });
  connect(&studio, &Studio::layer_changed, this, &LayersModel::refresh);
  list_rows();
}

void LayersModel::refresh() {
  beginResetModel();
  list_rows();
  endResetModel();
  Q_EMIT refreshed();
}

void LayersModel::list_rows() {
  rows_.clear();
  const auto layers = studio_.session().document().layers();
  LayerGroupPtr last;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    if (layer->group && !same_group(layer->group, last)) rows_.push_back({layer->group->id, {}});
    last = layer->group;
    if (!last || !is_collapsed(last->id)) rows_.push_back({{}, layer->id});
  }
}

void LayersModel::set_collapsed(GroupId group, bool on) {
  if (is_collapsed(group) == on) return;
  on ? static_cast<void>(collapsed_.insert(group)) : static_cast<void>(collapsed_.erase(group));
  refresh();
}

LayerId LayersModel::layer_at(int row) const {
  return row < 0 || row >= rowCount() ? LayerId{} : rows_[static_cast<std::size_t>(row)].layer;
}

GroupId LayersModel::group_at(int row) const {
  return row < 0 || row >= rowCount() ? GroupId{} : rows_[static_cast<std::size_t>(row)].group;
}

int LayersModel::row_of(LayerId id) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [id](const Row& r) { return id && r.layer == id; });
  if (found != rows_.end()) return static_cast<int>(found - rows_.begin());
  const Layer* layer = studio_.session().document().layer(id);
  return layer && layer->group ? row_of_group(layer->group->id) : -1;
}

int LayersModel::row_of_group(GroupId id) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [id](const Row& r) { return id && r.group == id; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int LayersModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

/// Returns the name to show. A name that the program has given is translated.
QString LayersModel::shown_name(const Layer& layer) {
  if (layer.name == "Ink") return tr("Ink");
  return numbered(QString::fromStdString(layer.name), QLatin1String("Layer "), tr("Layer %1"));
}

QString LayersModel::shown_name(const LayerGroup& group) {
  return numbered(QString::fromStdString(group.name), QLatin1String("Group "), tr("Group %1"));
}

QString LayersModel::spoken(const Layer& layer) const {
  QString text = tr("%1, %2, %3")
                     .arg(shown_name(layer), layer.own_visible ? tr("visible") : tr("hidden"),
                          layer.own_locked ? tr("locked") : tr("unlocked"));
  if (layer.picture) text += tr(", picture");
  text += look_text(layer.state());
  if (layer.group) text += tr(", in the group %1").arg(shown_name(*layer.group));
  if (layer.own_visible && !layer.visible) text += tr(", hidden by its group");
  if (!layer.own_locked && layer.locked) text += tr(", locked by its group");
  if (layer.id == studio_.session().layer()) text += tr(", current");
  return text;
}

QString LayersModel::spoken(const LayerGroup& group) const {
  return tr("%1 (group), %2, %3, %4")
             .arg(shown_name(group), group.visible ? tr("visible") : tr("hidden"),
                  group.locked ? tr("locked") : tr("unlocked"),
                  is_collapsed(group.id) ? tr("collapsed") : tr("expanded")) +
         look_text(group);
}

QVariant LayersModel::data(const QModelIndex& index, int role) const {
  const Document& document = studio_.session().document();
  if (const LayerGroupPtr group = document.group(group_at(index.row()))) {
    return group_data(*group, role);
  }
  const Layer* layer = document.layer(layer_at(index.row()));
  return layer ? layer_data(*layer, role) : QVariant();
}

QVariant LayersModel::layer_data(const Layer& layer, int role) const {
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return shown_name(layer);
    case Qt::AccessibleTextRole:
      return spoken(layer);
    case Qt::ToolTipRole:
      return tr("%1\nDouble-click to rename, drag to move").arg(spoken(layer));
    case kVisible:
      return layer.own_visible;
    case kShown:
      return layer.visible;
    case kLocked:
      return layer.own_locked;
    case kInUse:
      return layer.id == studio_.session().layer();
    case kThumbnail:
      return thumbnails_->of(layer.id);
    case kHasPicture:
      return layer.picture != nullptr;
    case kIndented:
      return layer.group != nullptr;
    default:
      return {};
  }
}

QVariant LayersModel::group_data(const LayerGroup& group, int role) const {
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return shown_name(group);
    case Qt::AccessibleTextRole:
      return spoken(group);
    case Qt::ToolTipRole:
      return tr("%1\nDouble-click to rename, drag to move, drag layers into it").arg(spoken(group));
    case kVisible:
    case kShown:
      return group.visible;
    case kLocked:
      return group.locked;
    case kIsGroup:
      return true;
    case kCollapsed:
      return is_collapsed(group.id);
    case kInUse: {  // a collapsed group stands for its layers
      const Layer* layer = studio_.session().document().layer(studio_.session().layer());
      return is_collapsed(group.id) && layer && layer->group && layer->group->id == group.id;
    }
    default:
      return {};
  }
}

bool LayersModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::string name = value.toString().trimmed().toStdString();
  if (role != Qt::EditRole || !index.isValid() || name.empty()) return false;
  if (data(index, Qt::EditRole).toString().toStdString() == name) return true;  // unchanged
  LayerEvent event{Do::kRename, layer_at(index.row()), name};
  if (!event.layer) event.group = group_at(index.row());
  return studio_.apply(event);
}

Qt::ItemFlags LayersModel::flags(const QModelIndex& index) const {
  // Rows can be dropped only between rows, not onto a row.
  if (!index.isValid()) return Qt::ItemIsDropEnabled;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

/// Returns the number of layers below the upper edge of a row, without those that are moved.
std::size_t LayersModel::layers_below(int before, const Row& moved) const {
  const auto layers = studio_.session().document().layers();
  std::size_t count = 0;
  for (const Layer& layer : layers) {
    const bool is_moved =
        moved.layer ? layer.id == moved.layer : layer.group && layer.group->id == moved.group;
    if (!is_moved && row_of(layer.id) >= before) ++count;
  }
  return count;
}

/// Returns the group that a layer joins if it is dropped at the upper edge of a row. At the lower
/// edge of a group, the layer stays in it or outside, as it was.
GroupId LayersModel::group_between(int before, const Layer& moved) const {
  const Document& document = studio_.session().document();
  const auto group_of = [&](int row) -> GroupId {
    const Layer* layer = document.layer(layer_at(row));
    return layer && layer->group ? layer->group->id : GroupId{};
  };
  if (const GroupId above = group_at(before - 1)) return is_collapsed(above) ? GroupId{} : above;
  const GroupId above = group_of(before - 1);
  const bool was_in = moved.group && moved.group->id == above;
  return above && (group_of(before) == above || was_in) ? above : GroupId{};
}

bool LayersModel::move_group(int row, int before) {
  const Row moved = rows_[static_cast<std::size_t>(row)];
  int end = row + 1;  // the rows of its layers
  while (end < rowCount()) {
    const Layer* layer = studio_.session().document().layer(layer_at(end));
    if (!layer || !layer->group || layer->group->id != moved.group) break;
    ++end;
  }
  if (before >= row && before <= end) return false;
  LayerEvent event{Do::kMove, {}, {}, layers_below(before, moved)};
  event.group = moved.group;
  return studio_.apply(event);
}

bool LayersModel::moveRows(const QModelIndex&, int row, int count, const QModelIndex&, int before) {
  if (count != 1 || row < 0 || row >= rowCount() || before < 0 || before > rowCount()) return false;
  if (group_at(row)) return move_group(row, before);
  const Layer* layer = studio_.session().document().layer(layer_at(row));
  if (!layer) return false;
  const GroupId own = layer->group ? layer->group->id : GroupId{};
  const GroupId group = group_between(before, *layer);
  if ((before == row || before == row + 1) && group == own) return false;
  LayerEvent event{Do::kMove, layer->id, {}, layers_below(before, {{}, layer->id})};
  event.group = group;
  return studio_.apply(event);
}

}  // namespace felt::desktop
