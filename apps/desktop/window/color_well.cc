#include "desktop/window/color_well.h"

#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QWidgetAction>

#include "desktop/panels/colors_panel.h"

namespace felt::desktop {
namespace {

constexpr QSize kSizePx{34, 18};
constexpr QSize kPopupPx{300, 420};

}  // namespace

ColorWell::ColorWell(Studio& studio, QWidget* parent) : QToolButton(parent), studio_(studio) {
  setObjectName(QStringLiteral("top_color"));
  setToolTip(tr("Colour of the ink"));
  setIconSize(kSizePx);
  setFocusPolicy(Qt::TabFocus);
  setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(this);
  // Made when it is first needed, because most users use the panel.
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    if (!menu->isEmpty()) return;
    auto* colors = new ColorsPanel(studio_, menu);
    colors->setFixedSize(kPopupPx);
    // A swatch is a choice: the menu closes, so that the next press draws.
    for (const SwatchView* swatches : colors->findChildren<SwatchView*>()) {
      connect(swatches, &SwatchView::chosen, menu, &QMenu::close);
    }
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(colors);
    menu->addAction(action);
  });
  setMenu(menu);
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    if (id == QLatin1String("ink.color")) follow();
  });
  connect(&studio, &Studio::opened, this, &ColorWell::follow);
  connect(&studio, &Studio::page_changed, this, &ColorWell::follow);
  follow();
}

void ColorWell::follow() {
  const Rgba color = studio_.session().ink_color();
  const double dpr = devicePixelRatioF();
  QPixmap picture(kSizePx * dpr);
  picture.setDevicePixelRatio(dpr);
  // The colour is drawn over the paper's, so that a transparent colour looks as it does on the
  // page.
  picture.fill(qcolor(studio_.page().paper));
  QPainter painter(&picture);
  painter.fillRect(QRectF(QPointF(), QSizeF(kSizePx)), qcolor(color));
  painter.setPen(Qt::gray);  // visible beside black ink on a dark bar and white ink on a light one
  painter.drawRect(QRectF(QPointF(), QSizeF(kSizePx)).adjusted(0.5, 0.5, -0.5, -0.5));
  painter.end();
  setIcon(QIcon(picture));
  setAccessibleName(tr("Colour of the ink: %1").arg(qcolor(color).name()));
}

void ColorWell::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) follow();
}

}  // namespace felt::desktop
