// The actions of the layers panel.
#include <QCoreApplication>

#include "desktop/panels/layers_panel.h"
#include "desktop/panels/tool_icons.h"

namespace felt::desktop {
namespace {

using Do = LayerEvent::Do;

QString layer_text(const char* english) {
  return QCoreApplication::translate("LayerActions", english);
}

void add_order(Actions& actions, LayersPanel& panel) {
  actions
      .add(QStringLiteral("layer.add"), layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Add layer")),
           {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Adds a layer above the current one.")),
           [&panel] { panel.apply(Do::kAdd); })
      ->setIcon(icon_of("layer-add"));
  actions
      .add(QStringLiteral("layer.duplicate"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Duplicate layer")), {},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Adds a copy of the layer above it.")),
           [&panel] { panel.apply(Do::kDuplicate); })
      ->setIcon(icon_of("layer-duplicate"));
  actions
      .add(QStringLiteral("layer.merge"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Merge layer down")), {},
           layer_text(
               QT_TRANSLATE_NOOP("LayerActions", "Moves the lines of the layer to the one below.")),
           [&panel] { panel.apply(Do::kMerge); })
      ->setIcon(icon_of("layer-merge"));
  actions
      .add(QStringLiteral("layer.remove"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Remo&ve layer")), {},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Removes the layer and its lines.")),
           [&panel] { panel.apply(Do::kRemove); })
      ->setIcon(icon_of("layer-remove"));
  actions
      .add(QStringLiteral("layer.rename"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Re&name layer")),
           {QKeySequence(Qt::Key_F2)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Changes the name of the layer.")),
           [&panel] { panel.rename(); })
      ->setIcon(icon_of("rename"));
  actions
      .add(QStringLiteral("layer.raise"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Raise layer")),
           {QKeySequence(Qt::CTRL | Qt::Key_PageUp)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Moves the layer up by one.")),
           [&panel] { panel.apply(Do::kRaise); })
      ->setIcon(icon_of("raise"));
  actions
      .add(QStringLiteral("layer.lower"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Lower layer")),
           {QKeySequence(Qt::CTRL | Qt::Key_PageDown)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Moves the layer down by one.")),
           [&panel] { panel.apply(Do::kLower); })
      ->setIcon(icon_of("lower"));
}

void add_use(Actions& actions, LayersPanel& panel) {
  actions.add(QStringLiteral("layer.use_above"),
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "Draw on the layer &above")),
              {QKeySequence(Qt::ALT | Qt::Key_PageUp)},
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "New lines go to the next layer up.")),
              [&panel] { panel.use_next(true); });
  actions.add(QStringLiteral("layer.use_below"),
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "Draw on the layer &below")),
              {QKeySequence(Qt::ALT | Qt::Key_PageDown)},
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "New lines go to the next layer down.")),
              [&panel] { panel.use_next(false); });
}

}  // namespace

void add_layer_actions(Actions& actions, Studio& studio, LayersPanel& panel) {
  add_order(actions, panel);
  const auto chosen = [&studio, &panel] {
    return studio.session().document().layer(panel.chosen());
  };
  QAction* show = actions.add_switch(
      QStringLiteral("layer.show"), layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Show layer")),
      {}, layer_text(QT_TRANSLATE_NOOP("LayerActions", "Shows or hides the lines on the layer.")),
      true, [&panel, chosen](bool on) {
        if (chosen() && chosen()->visible != on) panel.toggle_visible();
      });
  show->setIcon(icon_of("eye"));
  QAction* lock = actions.add_switch(
      QStringLiteral("layer.lock"), layer_text(QT_TRANSLATE_NOOP("LayerActions", "Loc&k layer")),
      {}, layer_text(QT_TRANSLATE_NOOP("LayerActions", "Protects the layer against changes.")),
      false, [&panel, chosen](bool on) {
        if (chosen() && chosen()->locked != on) panel.toggle_locked();
      });
  lock->setIcon(icon_of("lock"));
  QAction* exported =
      actions.add_switch(QStringLiteral("layer.export_picture"),
                         layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Export the picture")), {},
                         layer_text(QT_TRANSLATE_NOOP(
                             "LayerActions", "Shows the picture of the layer in exported files.")),
                         false, [&panel, chosen](bool on) {
                           const Layer* layer = chosen();
                           if (!layer || !layer->picture || layer->picture->exported == on) return;
                           panel.apply(on ? Do::kExport : Do::kLeaveOut);
                         });
  exported->setIcon(icon_of("picture"));
  add_use(actions, panel);
  const auto follow = [&actions, &studio, chosen, show, lock, exported] {
    const Layer* layer = chosen();
    if (!layer) return;
    show->setChecked(layer->visible);
    lock->setChecked(layer->locked);
    exported->setEnabled(layer->picture != nullptr);
    exported->setChecked(layer->picture && layer->picture->exported);
    const auto layers = studio.session().document().layers();
    actions.find(QStringLiteral("layer.raise"))->setEnabled(layers.back().id != layer->id);
    const bool is_lowest = layers.front().id == layer->id;
    actions.find(QStringLiteral("layer.lower"))->setEnabled(!is_lowest);
    actions.find(QStringLiteral("layer.merge"))->setEnabled(!is_lowest);
  };
  QObject::connect(&panel, &LayersPanel::changed, show, follow);
  follow();
}

}  // namespace felt::desktop
