#include "desktop/window/top_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QToolButton>

#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_icons.h"
#include "desktop/feel/material_words.h"
#include "desktop/panels/tool_icons.h"
#include "felt/haptics/material.h"

namespace felt::desktop {
namespace {

const std::string kMaterial = "sheet.material";

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

}  // namespace

TopBar::TopBar(const Actions& actions, Canvas& canvas, QWidget* parent)
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
  add_material(canvas.studio());
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

/// With its words, at every width: nobody should have to guess how forces are stopped.
void TopBar::add_forces(const Actions& actions) {
  add_named(actions, "feel.forces");
  forces_ = actions.find(QStringLiteral("feel.forces"));
  auto* button = qobject_cast<QToolButton*>(widgetForAction(forces_));
  if (!button) return;
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(&studio_, &Studio::forces_changed, this, &TopBar::show_forces);
  connect(forces_, &QAction::changed, button,
          [this, button] { button->setAccessibleName(forces_->text().remove(QLatin1Char('&'))); });
  show_forces();
}

void TopBar::show_forces() {
  if (!forces_) return;
  forces_->setIcon(studio_.forces_are_on()
                       ? stop_icon(palette(), iconSize().height(), devicePixelRatioF())
                       : icon_of("force-on"));
}

void TopBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_forces();
}

void TopBar::add_material(Studio& studio) {
  auto* label = new QLabel(tr("Sheet:"), this);
  label->setContentsMargins(4, 0, 4, 0);
  auto* box = new QComboBox(this);
  box->setAccessibleName(tr("Material of the sheet"));
  box->setToolTip(tr("What the sheet feels and looks like"));
  box->setFocusPolicy(Qt::TabFocus);
  label->setBuddy(box);
  for (const SurfaceMaterial& material : surface_materials()) {
    box->addItem(material_label(material), text_of(material.id));
  }
  const auto show = [box, &studio] {
    const Result<OptionValue> value = studio.session().option(kMaterial);
    const auto* name = value ? std::get_if<std::string>(&*value) : nullptr;
    if (name) box->setCurrentIndex(box->findData(QString::fromStdString(*name)));
  };
  show();
  connect(box, &QComboBox::activated, this,
          [box, &studio] { choose_material(studio, box->currentData().toString()); });
  connect(&studio, &Studio::option_changed, this, [show](const QString& id) {
    if (id.toStdString() == kMaterial) show();
  });
  connect(&studio, &Studio::opened, this, show);
  addWidget(label);
  addWidget(box);
}

}  // namespace felt::desktop
