#include "desktop/panels/layers_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "desktop/panels/layer_delegate.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

using Do = LayerEvent::Do;

bool is_open(const Layer& layer) {
  return layer.visible && !layer.locked;
}

}  // namespace

LayersPanel::LayersPanel(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      model_(new LayersModel(studio, this)),
      list_(new QListView(this)),
      opacity_(new QSlider(Qt::Horizontal, this)),
      blend_(new QComboBox(this)) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(0);
  auto* delegate = new LayerDelegate(list_);
  add_opacity(*lines);
  add_blend(*lines);
  list_->setModel(model_);
  list_->setItemDelegate(delegate);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setDefaultDropAction(Qt::MoveAction);
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  list_->setUniformItemSizes(true);
  list_->setAccessibleName(tr("Layers"));
  list_->installEventFilter(this);
  lines->addWidget(list_, 1);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(6, 4, 6, 4);
  row->setSpacing(2);
  const auto add = [&](const char* icon, const QString& name, const QString& tip, Do what) {
    QToolButton* made = button(icon, name, tip);
    row->addWidget(made);
    connect(made, &QToolButton::clicked, this, [this, what] { apply(what); });
    return made;
  };
  add("layer-add", tr("Add a layer"), tr("A new layer above the current one"), Do::kAdd);
  add("layer-duplicate", tr("Duplicate the layer"), tr("A copy of this layer above it"),
      Do::kDuplicate);
  merge_ = add("layer-merge", tr("Merge the layer with the one below"),
               tr("Moves the lines to the layer below"), Do::kMerge);
  row->addStretch(1);
  raise_ = add("raise", tr("Raise the layer"), tr("Moves the layer up by one"), Do::kRaise);
  lower_ = add("lower", tr("Lower the layer"), tr("Moves the layer down by one"), Do::kLower);
  remove_ = add("delete", tr("Remove the layer"), {}, Do::kRemove);
  lines->addLayout(row);
  connect_list(*delegate);
  follow_model();
}

void LayersPanel::connect_list(LayerDelegate& delegate) {
  const auto toggle = [this](const QModelIndex& index, void (LayersPanel::*change)(LayerId)) {
    was_icon_ = true;
    const GroupId group = model_->group_at(index.row());
    if (group) choose_group(group);
    (this->*change)(model_->layer_at(index.row()));
    if (!group) choose(studio_.session().layer());
  };
  connect(&delegate, &LayerDelegate::eye_clicked, this,
          [toggle](const QModelIndex& index) { toggle(index, &LayersPanel::toggle_visible); });
  connect(&delegate, &LayerDelegate::lock_clicked, this,
          [toggle](const QModelIndex& index) { toggle(index, &LayersPanel::toggle_locked); });
  connect(&delegate, &LayerDelegate::arrow_clicked, this, [this](const QModelIndex& index) {
    was_icon_ = true;
    const GroupId group = model_->group_at(index.row());
    choose_group(group);
    fold(!model_->is_collapsed(group));
  });
  // The list first reports where a click began and then the click itself. A click makes the layer
  // current only if it is not on an icon.
  connect(list_, &QListView::pressed, this, [this] { was_icon_ = false; });
  connect(list_, &QListView::clicked, this, [this] {
    if (!was_icon_) use_clicked();
  });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& now) {
            if (now.isValid()) follow_chosen();
          });
  connect(model_, &LayersModel::refreshed, this, &LayersPanel::follow_model);
  connect(&studio_, &Studio::layer_changed, this, [this] { choose(studio_.session().layer()); });
  connect(&studio_, &Studio::opened, this, [this] {
    ink_layers_ = 0;
    choose(studio_.session().layer());
  });
  connect(&studio_, &Studio::edited, this, &LayersPanel::report_layer_for_ink);
}

void LayersPanel::add_opacity(QVBoxLayout& lines) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 4);
  auto* label = new QLabel(tr("&Opacity:"), this);
  label->setBuddy(opacity_);
  opacity_->setObjectName(QStringLiteral("opacity"));
  opacity_->setRange(0, 100);
  opacity_->setPageStep(10);
  opacity_->setAccessibleName(tr("Opacity of the layer"));
  row->addWidget(label);
  row->addWidget(opacity_, 1);
  lines.addLayout(row);
  connect(opacity_, &QSlider::valueChanged, this,
          [this](int percent) { set_opacity(percent / 100.0, opacity_->isSliderDown()); });
  connect(opacity_, &QSlider::sliderPressed, this, [this] { dragged_steps_.reset(); });
  connect(opacity_, &QSlider::sliderReleased, this, [this] { dragged_steps_.reset(); });
}

void LayersPanel::add_blend(QVBoxLayout& lines) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 4);
  auto* label = new QLabel(tr("&Blend mode:"), this);
  label->setBuddy(blend_);
  blend_->setObjectName(QStringLiteral("blend"));
  blend_->addItem(tr("Normal"));
  blend_->addItem(tr("Multiply"));  // in the order of BlendMode
  blend_->setAccessibleName(tr("Blend mode of the layer"));
  blend_->setFocusPolicy(Qt::StrongFocus);
  blend_->setToolTip(tr("Multiply makes what is below darker, for shading on line art"));
  row->addWidget(label);
  row->addWidget(blend_, 1);
  lines.addLayout(row);
  connect(blend_, &QComboBox::activated, this,
          [this](int index) { set_blend(static_cast<BlendMode>(index)); });
}

/// Returns an event for the highlighted layer or group.
LayerEvent LayersPanel::event_of(Do what) const {
  LayerEvent event{what, {}};
  if (const GroupId group = chosen_group()) {
    event.group = group;
  } else {
    event.layer = chosen();
  }
  return event;
}

void LayersPanel::set_blend(BlendMode mode) {
  LayerEvent event = event_of(Do::kBlend);
  event.mode = mode;
  studio_.apply(event);
  follow_chosen();
}

void LayersPanel::group_with_below() {
  const auto layers = studio_.session().document().layers();
  const Range range = chosen_range();
  if (chosen_group() || layers[range.first].group) return;
  const Layer* below = range.first > 0 ? &layers[range.first - 1] : nullptr;
  LayerEvent event{Do::kGroup, {}};
  event.layers = {layers[range.first].id};
  if (below && below->group) {
    event = {Do::kMove, layers[range.first].id, {}, range.first};
    event.group = below->group->id;
  } else if (below) {
    event.layers.push_back(below->id);
  }
  studio_.apply(event);
}

void LayersPanel::ungroup() {
  const Layer* layer = studio_.session().document().layer(chosen());
  LayerEvent event{Do::kUngroup, {}};
  event.group = chosen_group();
  if (!*event.group && layer && layer->group) event.group = layer->group->id;
  if (*event.group) studio_.apply(event);
}

void LayersPanel::leave_group() {
  const auto layers = studio_.session().document().layers();
  std::size_t index = chosen_range().first;
  if (chosen_group() || !layers[index].group) return;
  LayerEvent event{Do::kMove, layers[index].id};
  event.group = GroupId{};
  while (index + 1 < layers.size() && same_group(layers[index + 1].group, layers[index].group)) {
    ++index;
  }
  event.index = index;
  studio_.apply(event);
}

void LayersPanel::fold(bool collapsed) {
  if (const GroupId group = chosen_group()) model_->set_collapsed(group, collapsed);
}

/// Returns the positions of the highlighted layer, or of the layers of the highlighted group.
LayersPanel::Range LayersPanel::chosen_range() const {
  const auto layers = studio_.session().document().layers();
  const GroupId group = chosen_group();
  const LayerId id = chosen();
  const auto is_in = [&](const Layer& l) {
    return group ? l.group && l.group->id == group : l.id == id;
  };
  Range range;
  while (range.first + 1 < layers.size() && !is_in(layers[range.first])) ++range.first;
  range.last = range.first + 1;
  while (range.last < layers.size() && is_in(layers[range.last])) ++range.last;
  return range;
}

bool LayersPanel::can_raise() const {
  const auto layers = studio_.session().document().layers();
  const Range range = chosen_range();
  if (range.last >= layers.size()) return false;
  const LayerGroupPtr& group = layers[range.first].group;
  return chosen_group() || !group || same_group(group, layers[range.last].group);
}

bool LayersPanel::can_lower() const {
  const auto layers = studio_.session().document().layers();
  const Range range = chosen_range();
  if (range.first == 0) return false;
  const LayerGroupPtr& group = layers[range.first].group;
  return chosen_group() || !group || same_group(group, layers[range.first - 1].group);
}

bool LayersPanel::can_merge() const {
  const auto layers = studio_.session().document().layers();
  const Range range = chosen_range();
  return !chosen_group() && range.first > 0 &&
         equal_groups(layers[range.first].group, layers[range.first - 1].group);
}

void LayersPanel::set_opacity(double opacity, bool is_dragging) {
  const auto steps = [this] { return studio_.session().history().undo_count(); };
  if (is_dragging && dragged_steps_ == steps()) studio_.apply(UndoEvent{});
  LayerEvent event = event_of(Do::kOpacity);
  event.opacity = opacity;
  const std::size_t before = steps();
  studio_.apply(event);
  dragged_steps_.reset();
  if (is_dragging && steps() > before) dragged_steps_ = steps();
}

QToolButton* LayersPanel::button(const char* icon, const QString& name, const QString& tip) {
  auto* made = new QToolButton(this);
  made->setIcon(icon_of(icon));
  made->setIconSize({18, 18});
  made->setAutoRaise(true);
  made->setObjectName(QString::fromLatin1(icon));
  made->setAccessibleName(name);
  made->setToolTip(tip);
  return made;
}

LayerId LayersPanel::chosen() const {
  const LayerId id = model_->layer_at(list_->currentIndex().row());
  return id ? id : studio_.session().layer();
}

GroupId LayersPanel::chosen_group() const {
  return model_->group_at(list_->currentIndex().row());
}

void LayersPanel::choose_group(GroupId group) {
  const int row = model_->row_of_group(group);
  if (row < 0) return;
  list_->setCurrentIndex(model_->index(row));
  follow_chosen();
}

void LayersPanel::choose(LayerId layer) {
  const int row = model_->row_of(layer);
  if (row < 0) return;
  list_->setCurrentIndex(model_->index(row));
  follow_chosen();
}

void LayersPanel::apply(Do what) {
  studio_.apply(what == Do::kAdd ? LayerEvent{what, {}} : event_of(what));
}

void LayersPanel::report_layer_for_ink() {
  const std::uint64_t count = studio_.session().layers_added_for_ink();
  if (std::exchange(ink_layers_, count) >= count) return;
  const Layer* added = studio_.session().document().layer(studio_.session().layer());
  Q_EMIT studio_.refused(tr("All layers were hidden or locked, so “%1” was added to draw on.")
                             .arg(LayersModel::shown_name(*added)));
}

void LayersPanel::toggle_visible(LayerId id) {
  const Document& document = studio_.session().document();
  if (const LayerGroupPtr group = id ? nullptr : document.group(chosen_group())) {
    studio_.apply(event_of(group->visible ? Do::kHide : Do::kShow));
    return choose_group(group->id);  // another layer may have become current
  }
  const Layer* layer = document.layer(id ? id : chosen());
  if (layer) studio_.apply(LayerEvent{layer->own_visible ? Do::kHide : Do::kShow, layer->id});
}

void LayersPanel::toggle_locked(LayerId id) {
  const Document& document = studio_.session().document();
  if (const LayerGroupPtr group = id ? nullptr : document.group(chosen_group())) {
    studio_.apply(event_of(group->locked ? Do::kUnlock : Do::kLock));
    return choose_group(group->id);
  }
  const Layer* layer = document.layer(id ? id : chosen());
  if (layer) studio_.apply(LayerEvent{layer->own_locked ? Do::kUnlock : Do::kLock, layer->id});
}

void LayersPanel::use_next(bool above) {
  const auto layers = studio_.session().document().layers();
  const LayerId now = studio_.session().layer();
  const auto current =
      std::find_if(layers.begin(), layers.end(), [now](const Layer& l) { return l.id == now; });
  auto next = layers.end();
  if (above) {
    next = current == layers.end() ? current : std::find_if(current + 1, layers.end(), is_open);
  } else {
    for (auto l = layers.begin(); l != current; ++l) next = is_open(*l) ? l : next;
  }
  if (next != layers.end()) studio_.apply(LayerEvent{Do::kUse, next->id});
}

void LayersPanel::rename() {
  list_->setFocus();
  list_->edit(list_->currentIndex());
}

void LayersPanel::follow_model() {
  if (kept_group_ && model_->row_of_group(kept_group_) >= 0) return choose_group(kept_group_);
  const LayerId wanted = model_->row_of(kept_) >= 0 ? kept_ : studio_.session().layer();
  choose(wanted);
}

void LayersPanel::follow_chosen() {
  kept_ = chosen();
  kept_group_ = chosen_group();
  raise_->setEnabled(can_raise());
  lower_->setEnabled(can_lower());
  merge_->setEnabled(can_merge());
  const Layer* layer = studio_.session().document().layer(kept_);
  const LayerGroupPtr group = studio_.session().document().group(kept_group_);
  remove_->setToolTip(group ? tr("Removes the group, its layers and their lines")
                            : tr("Removes the layer and its lines"));
  const QSignalBlocker blocker(opacity_);
  const double opacity = group ? group->opacity : layer ? layer->opacity : 1.0;
  if (!opacity_->isSliderDown()) opacity_->setValue(qRound(100.0 * opacity));
  const BlendMode blend = group ? group->blend : layer ? layer->blend : BlendMode::kNormal;
  blend_->setCurrentIndex(static_cast<int>(blend));
  Q_EMIT changed();
}

void LayersPanel::use_chosen() {
  if (chosen_group()) return fold(!model_->is_collapsed(chosen_group()));
  const Layer* layer = studio_.session().document().layer(chosen());
  follow_chosen();
  // A hidden or locked layer may be highlighted, for example to show it again, but it does not
  // become current.
  if (layer && is_open(*layer) && layer->id != studio_.session().layer()) {
    studio_.apply(LayerEvent{Do::kUse, layer->id});
  }
}

/// Makes the clicked layer current. If it is hidden or locked, highlights the current layer again,
/// because the highlighted layer, which the bin deletes, should be the one that receives new ink.
void LayersPanel::use_clicked() {
  if (chosen_group()) return;
  const Layer* layer = studio_.session().document().layer(chosen());
  if (!layer || is_open(*layer)) return use_chosen();
  Q_EMIT studio_.refused(why_not_open(*layer));
  choose(studio_.session().layer());
}

/// Returns why a layer that is hidden or locked, itself or by its group, does not become current.
QString LayersPanel::why_not_open(const Layer& layer) const {
  const bool by_group = layer.locked ? !layer.own_locked : layer.own_visible;
  const QString name = by_group ? tr("The group “%1”").arg(LayersModel::shown_name(*layer.group))
                                : tr("“%1”", "a layer").arg(LayersModel::shown_name(layer));
  return layer.locked ? tr("%1 is locked. Unlock it to draw there.").arg(name)
                      : tr("%1 is hidden. Show it to draw there.").arg(name);
}

bool LayersPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Space:
        toggle_visible();
        return true;
      case Qt::Key_Left:
      case Qt::Key_Right:
        fold(static_cast<QKeyEvent*>(event)->key() == Qt::Key_Left);
        return true;
      case Qt::Key_Return:
      case Qt::Key_Enter:
        use_chosen();
        return true;
      default:
        break;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace felt::desktop
