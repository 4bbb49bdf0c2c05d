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

void add_groups(Actions& actions, LayersPanel& panel) {
  actions
      .add(QStringLiteral("layer.group"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Group layers")),
           {QKeySequence(Qt::CTRL | Qt::Key_G)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions",
                                        "Groups the layer with the one below, or puts it into the "
                                        "group below.")),
           [&panel] { panel.group_with_below(); })
      ->setIcon(icon_of("group"));
  actions
      .add(QStringLiteral("layer.ungroup"),
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Ungroup layers")),
           {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G)},
           layer_text(QT_TRANSLATE_NOOP("LayerActions", "Dissolves the group; its layers stay.")),
           [&panel] { panel.ungroup(); })
      ->setIcon(icon_of("ungroup"));
  actions.add(QStringLiteral("layer.leave_group"),
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Take out of the group")), {},
              layer_text(QT_TRANSLATE_NOOP("LayerActions", "Puts the layer above its group.")),
              [&panel] { panel.leave_group(); });
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

QAction* add_picture(Actions& actions, Studio& studio, LayersPanel& panel) {
  QAction* exported =
      actions.add_switch(QStringLiteral("layer.export_picture"),
                         layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Export the picture")), {},
                         layer_text(QT_TRANSLATE_NOOP(
                             "LayerActions", "Shows the picture of the layer in exported files.")),
                         false, [&panel, &studio](bool on) {
                           const Layer* layer = studio.session().document().layer(panel.chosen());
                           if (!layer || !layer->picture || layer->picture->exported == on) return;
                           panel.apply(on ? Do::kExport : Do::kLeaveOut);
                         });
  exported->setIcon(icon_of("picture"));
  return exported;
}

}  // namespace

void add_layer_actions(Actions& actions, Studio& studio, LayersPanel& panel) {
  add_order(actions, panel);
  add_groups(actions, panel);
  const auto chosen = [&studio, &panel] {
    return studio.session().document().layer(panel.chosen());
  };
  const auto chosen_group = [&studio, &panel] {
    return studio.session().document().group(panel.chosen_group());
  };
  const auto is_visible = [chosen, chosen_group] {
    const LayerGroupPtr group = chosen_group();
    return group ? group->visible : chosen() && chosen()->own_visible;
  };
  const auto is_locked = [chosen, chosen_group] {
    const LayerGroupPtr group = chosen_group();
    return group ? group->locked : chosen() && chosen()->own_locked;
  };
  QAction* show = actions.add_switch(
      QStringLiteral("layer.show"), layer_text(QT_TRANSLATE_NOOP("LayerActions", "&Show layer")),
      {}, layer_text(QT_TRANSLATE_NOOP("LayerActions", "Shows or hides the lines on the layer.")),
      true, [&panel, is_visible](bool on) {
        if (is_visible() != on) panel.toggle_visible();
      });
  show->setIcon(icon_of("eye"));
  QAction* lock = actions.add_switch(
      QStringLiteral("layer.lock"), layer_text(QT_TRANSLATE_NOOP("LayerActions", "Loc&k layer")),
      {}, layer_text(QT_TRANSLATE_NOOP("LayerActions", "Protects the layer against changes.")),
      false, [&panel, is_locked](bool on) {
        if (is_locked() != on) panel.toggle_locked();
      });
  lock->setIcon(icon_of("lock"));
  QAction* exported = add_picture(actions, studio, panel);
  add_use(actions, panel);
  const auto follow = [&actions, &panel, chosen, chosen_group, is_visible, is_locked, show, lock,
                       exported] {
    const Layer* layer = chosen();
    if (!layer) return;
    const bool is_group = chosen_group() != nullptr;
    show->setChecked(is_visible());
    lock->setChecked(is_locked());
    const LayerPicture* picture = is_group ? nullptr : layer->picture.get();
    exported->setEnabled(picture != nullptr);
    exported->setChecked(picture && picture->exported);
    const auto enable = [&actions](const char* name, bool on) {
      actions.find(QString::fromLatin1(name))->setEnabled(on);
    };
    enable("layer.raise", panel.can_raise());
    enable("layer.lower", panel.can_lower());
    enable("layer.merge", panel.can_merge());
    enable("layer.group", !is_group && !layer->group);
    enable("layer.ungroup", is_group || layer->group);
    enable("layer.leave_group", !is_group && layer->group);
  };
  QObject::connect(&panel, &LayersPanel::changed, show, follow);
  follow();
}

}  // namespace felt::desktop
