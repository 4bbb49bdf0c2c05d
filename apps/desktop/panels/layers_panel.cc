#include "desktop/panels/layers_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

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
      opacity_(new QSlider(Qt::Horizontal, this)) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(0);
  auto* delegate = new LayerDelegate(list_);
  add_opacity(*lines);
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
  add("layer-add", tr("Add a layer"), tr("A new layer above this one"), Do::kAdd);
  add("layer-duplicate", tr("Duplicate the layer"), tr("A copy of this layer above it"),
      Do::kDuplicate);
  merge_ = add("layer-merge", tr("Merge the layer with the one below"),
               tr("Moves the lines to the layer below"), Do::kMerge);
  row->addStretch(1);
  raise_ = add("raise", tr("Raise the layer"), tr("Moves the layer up by one"), Do::kRaise);
  lower_ = add("lower", tr("Lower the layer"), tr("Moves the layer down by one"), Do::kLower);
  add("delete", tr("Remove the layer"), tr("Removes the layer and its lines"), Do::kRemove);
  lines->addLayout(row);
  connect_list(*delegate);
  follow_model();
}

void LayersPanel::connect_list(LayerDelegate& delegate) {
  connect(&delegate, &LayerDelegate::eye_clicked, this, [this](const QModelIndex& index) {
    was_icon_ = true;
    toggle_visible(model_->layer_at(index.row()));
    choose(studio_.session().layer());
  });
  connect(&delegate, &LayerDelegate::lock_clicked, this, [this](const QModelIndex& index) {
    was_icon_ = true;
    toggle_locked(model_->layer_at(index.row()));
    choose(studio_.session().layer());
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
  connect(&studio_, &Studio::opened, this, [this] { choose(studio_.session().layer()); });
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

void LayersPanel::set_opacity(double opacity, bool is_dragging) {
  const LayerId id = chosen();
  const auto steps = [this] { return studio_.session().history().undo_count(); };
  if (is_dragging && dragged_steps_ == steps()) studio_.apply(UndoEvent{});
  LayerEvent event{Do::kOpacity, id};
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

void LayersPanel::choose(LayerId layer) {
  const int row = model_->row_of(layer);
  if (row < 0) return;
  list_->setCurrentIndex(model_->index(row));
  follow_chosen();
}

void LayersPanel::apply(Do what) {
  apply(what, what == Do::kAdd ? LayerId{} : chosen());
}

void LayersPanel::apply(Do what, LayerId id) {
  const auto count = [this] { return studio_.session().document().layers().size(); };
  const std::size_t before = count();
  const bool adds = what == Do::kAdd || what == Do::kDuplicate;
  if (!studio_.apply(LayerEvent{what, id}) || adds || count() <= before) return;
  const Layer* added = studio_.session().document().layer(studio_.session().layer());
  Q_EMIT studio_.refused(tr("All layers were hidden or locked, so “%1” was added to draw on.")
                             .arg(model_->shown_name(*added)));
}

void LayersPanel::toggle_visible(LayerId id) {
  const Layer* layer = studio_.session().document().layer(id ? id : chosen());
  if (layer) apply(layer->visible ? Do::kHide : Do::kShow, layer->id);
}

void LayersPanel::toggle_locked(LayerId id) {
  const Layer* layer = studio_.session().document().layer(id ? id : chosen());
  if (layer) apply(layer->locked ? Do::kUnlock : Do::kLock, layer->id);
}

void LayersPanel::use_next(bool above) {
  for (int row = model_->row_of(studio_.session().layer());;) {
    row += above ? -1 : 1;
    const Layer* layer = studio_.session().document().layer(model_->layer_at(row));
    if (!layer) return;
    if (!is_open(*layer)) continue;
    studio_.apply(LayerEvent{Do::kUse, layer->id});
    return;
  }
}

void LayersPanel::rename() {
  list_->setFocus();
  list_->edit(list_->currentIndex());
}

void LayersPanel::follow_model() {
  const LayerId wanted = model_->row_of(kept_) >= 0 ? kept_ : studio_.session().layer();
  choose(wanted);
}

void LayersPanel::follow_chosen() {
  kept_ = chosen();
  const int row = model_->row_of(kept_);
  raise_->setEnabled(row > 0);
  lower_->setEnabled(row >= 0 && row + 1 < model_->rowCount());
  merge_->setEnabled(lower_->isEnabled());
  const Layer* layer = studio_.session().document().layer(kept_);
  const QSignalBlocker blocker(opacity_);
  if (layer && !opacity_->isSliderDown()) opacity_->setValue(qRound(100.0 * layer->opacity));
  Q_EMIT changed();
}

void LayersPanel::use_chosen() {
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
  const Layer* layer = studio_.session().document().layer(chosen());
  if (!layer || is_open(*layer)) return use_chosen();
  const QString name = model_->shown_name(*layer);
  Q_EMIT studio_.refused(layer->locked ? tr("“%1” is locked. Unlock it to draw there.").arg(name)
                                       : tr("“%1” is hidden. Show it to draw there.").arg(name));
  choose(studio_.session().layer());
}

bool LayersPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    switch (static_cast<QKeyEvent*>(event)->key()) {
      case Qt::Key_Space:
        toggle_visible();
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
