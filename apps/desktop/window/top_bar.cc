#include "desktop/window/top_bar.h"

#include <QEvent>
#include <QLabel>
#include <QToolButton>

#include "desktop/engine/text_of.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/tool_icons.h"
#include "desktop/window/color_well.h"
#include "desktop/window/preset_menu.h"
#include "desktop/window/size_field.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr QSize kPicturePx{40, 16};

struct Choice {
  QString id, label;
};

/// Fills the list. Does nothing if its choices have not changed, because the list may be open.
void offer(QComboBox& box, const QList<Choice>& all) {
  bool is_same = box.count() == all.size();
  for (int i = 0; is_same && i < box.count(); ++i) {
    is_same = box.itemData(i).toString() == all[i].id && box.itemText(i) == all[i].label;
  }
  if (is_same) return;
  box.clear();
  for (const Choice& choice : all) box.addItem(choice.label, choice.id);
}

}  // namespace

TopBar::TopBar(const Actions& actions, Canvas& canvas, const MediaPictures& pictures,
               QWidget* parent)
    : QToolBar(parent), studio_(canvas.studio()) {
  setObjectName(QStringLiteral("top"));
  setWindowTitle(tr("Top bar"));
  setMovable(false);
  setIconSize(QSize(20, 20));
  add_named(actions, "edit.undo");
  add_named(actions, "edit.redo");
  addSeparator();
  add_named(actions, "view.zoom_out");
  add_named(actions, "view.zoom_in");
  add_named(actions, "view.fit_page");
  add_named(actions, "view.mirror");
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(gap);
  add_media(pictures);
  add_presets(actions);
  addWidget(new ColorWell(studio_, this));
  add_named(actions, "edit.pick_color");
  add_size();
  add_surfaces();
  addSeparator();
  add_forces(actions);
  addSeparator();
  add_named(actions, "view.hide_panels");
}

void TopBar::add_named(const Actions& actions, const char* name) {
  QAction* action = actions.find(QString::fromLatin1(name));
  if (!action) return;
  addAction(action);
  auto* button = qobject_cast<QToolButton*>(widgetForAction(action));
  if (!button) return;
  button->setAccessibleName(action->text().remove(QLatin1Char('&')));
  button->setFocusPolicy(Qt::TabFocus);
}

/// Adds the switch of the forces. Its text is visible even if the bar is narrow, so that the user
/// always sees how to stop the forces.
void TopBar::add_forces(const Actions& actions) {
  add_named(actions, "feel.forces");
  forces_ = actions.find(QStringLiteral("feel.forces"));
  auto* button = qobject_cast<QToolButton*>(widgetForAction(forces_));
  if (!button) return;
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(&studio_.loop(), &HapticLoop::forces_changed, this, &TopBar::show_forces);
  connect(forces_, &QAction::changed, button,
          [this, button] { button->setAccessibleName(forces_->text().remove(QLatin1Char('&'))); });
  show_forces();
}

void TopBar::show_forces() {
  if (!forces_) return;
  forces_->setIcon(studio_.loop().forces_are_on()
                       ? stop_icon(palette(), iconSize().height(), devicePixelRatioF())
                       : icon_of("force-on"));
}

void TopBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_forces();
}

QComboBox* TopBar::add_list(const QString& label, const QString& name, const QString& tip) {
  auto* words = new QLabel(label, this);
  words->setContentsMargins(4, 0, 4, 0);
  auto* box = new QComboBox(this);
  box->setAccessibleName(name);
  box->setToolTip(tip);
  box->setFocusPolicy(Qt::TabFocus);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  words->setBuddy(box);
  addWidget(words);
  addWidget(box);
  return box;
}

/// Adds a picture of each medium. Choosing a medium also selects the tool that draws with it.
void TopBar::add_media(const MediaPictures& pictures) {
  QComboBox* box =
      add_list(tr("Medium:"), tr("Drawing medium"), tr("How the medium looks, feels and sounds"));
  box->setObjectName(QStringLiteral("top_media"));
  box->setIconSize(kPicturePx);
  const auto show = [this, box] {
    box->setCurrentIndex(box->findData(QString::fromStdString(drawing_medium(studio_.session()))));
  };
  const auto show_pictures = [box, &pictures] {
    for (int i = 0; i < box->count(); ++i) {
      const QImage picture = pictures.of(box->itemData(i).toString().toStdString());
      if (!picture.isNull()) box->setItemIcon(i, QIcon(QPixmap::fromImage(picture)));
    }
  };
  const auto fill = [this, box, show, show_pictures] {
    QList<Choice> all;
    for (const Medium& medium : studio_.materials().media()) {
      if (medium.draws) all.push_back({text_of(medium.id), medium_label(medium)});
    }
    offer(*box, all);
    show_pictures();
    show();
  };
  fill();
  connect(box, &QComboBox::activated, this, [this, box, show] {
    choose_medium(studio_, box->currentData().toString().toStdString());
    show();
  });
  connect(&studio_, &Studio::option_changed, this, [this, show](const QString& id) {
    if (id.toStdString() == drawing_option(studio_.session(), "medium")) show();
  });
  connect(&studio_, &Studio::materials_changed, this, fill);
  connect(&studio_, &Studio::opened, this, fill);
  connect(&pictures, &MediaPictures::changed, this, show_pictures);
}

void TopBar::add_presets(const Actions& actions) {
  auto* button = new QToolButton(this);
  button->setObjectName(QStringLiteral("top_presets"));
  button->setIcon(icon_of("preset"));
  button->setToolTip(tr("Presets: a medium with its size, colour and options, under a name"));
  button->setAccessibleName(tr("Presets"));
  button->setFocusPolicy(Qt::TabFocus);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(new PresetMenu(actions, studio_, button));
  addWidget(button);
}

void TopBar::add_size() {
  auto* words = new QLabel(tr("Size:"), this);
  words->setContentsMargins(6, 0, 4, 0);
  auto* field = new SizeField(studio_, this);
  words->setBuddy(field);
  addWidget(words);
  addWidget(field);
}

void TopBar::add_surfaces() {
  QComboBox* box = add_list(tr("Surface:"), tr("Material of the surface"),
                            tr("How the surface feels and looks"));
  box->setObjectName(QStringLiteral("top_surfaces"));
  const auto show = [this, box] {
    box->setCurrentIndex(box->findData(text_of(studio_.session().surface().id)));
  };
  const auto fill = [this, box, show] {
    QList<Choice> all;
    for (const SurfaceMaterial& material : studio_.materials().surfaces()) {
      all.push_back({text_of(material.id), material_label(material)});
    }
    offer(*box, all);
    show();
  };
  fill();
  connect(box, &QComboBox::activated, this,
          [this, box] { choose_material(studio_, box->currentData().toString()); });
  connect(&studio_, &Studio::option_changed, this, [show](const QString& id) {
    if (id == QLatin1String("surface.material")) show();
  });
  connect(&studio_, &Studio::materials_changed, this, fill);
  connect(&studio_, &Studio::opened, this, fill);
}

}  // namespace felt::desktop
