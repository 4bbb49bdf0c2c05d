#include "desktop/window/canvas_popup.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include "desktop/engine/text_of.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/panel_setting_keys.h"
#include "desktop/panels/stored_colors.h"
#include "desktop/panels/tool_icons.h"
#include "desktop/window/preset_menu.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr int kPaletteWidthPx = 300;
constexpr int kToolIconPx = 20;
constexpr int kToolColumns = 8;

}  // namespace

CanvasPopup::CanvasPopup(const Actions& actions, Canvas& canvas, const MediaPictures& pictures,
                         QWidget* parent)
    : QMenu(parent),
      actions_(actions),
      canvas_(canvas),
      studio_(canvas.studio()),
      pictures_(pictures) {
  setObjectName(QStringLiteral("popup"));
  setAccessibleName(tr("Palette at the pointer"));
  connect(&canvas, &Canvas::popup_wanted, this, &CanvasPopup::open_at);
}

void CanvasPopup::open_at(QPointF px) {
  if (studio_.session().gesture_in_progress() || isVisible()) return;
  // Built when it is first needed, to start faster.
  if (isEmpty()) build(pictures_);
  at_ = canvas_.view().to_mm(px);
  const std::vector<NamedColor> colors = stored_colors(panel_keys::kRecentColors);
  recent_->set_colors(colors);
  recent_->setVisible(!colors.empty());
  recent_->mark(studio_.session().ink_color());
  popup(canvas_.mapToGlobal(px.toPoint()));
}

void CanvasPopup::build(const MediaPictures& pictures) {
  auto* palette = new QWidget(this);
  auto* lines = new QVBoxLayout(palette);
  lines->setContentsMargins(8, 6, 8, 6);
  lines->setSpacing(6);
  lines->addWidget(make_tools());
  auto* media = new MediaPicker(studio_, pictures, palette);
  media->setFixedWidth(kPaletteWidthPx);
  // The height follows from the width only after a layout, but the menu needs it before.
  media->setFixedHeight(media->height_for(kPaletteWidthPx));
  for (const std::string& id : media->ids()) {
    connect(media->button(id), &QAbstractButton::clicked, this, &QMenu::close);
  }
  lines->addWidget(media);
  recent_ = new SwatchView(tr("Recently used colours"), true, palette);
  recent_->setFixedWidth(kPaletteWidthPx);
  connect(recent_, &SwatchView::chosen, this, &CanvasPopup::set_color);
  lines->addWidget(recent_);
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(palette);
  addAction(action);
  addMenu(new PresetMenu(actions_, studio_, this));
  addSeparator();
  add_actions({QStringLiteral("edit.cut"), QStringLiteral("edit.copy")});
  addAction(icon_of("paste"), tr("Paste &here"), this, [this] { Q_EMIT wants_paste(at_); });
  add_actions({QStringLiteral("edit.duplicate"), QStringLiteral("edit.delete"),
               QStringLiteral("edit.select_all")});
  addSeparator();
  add_actions({QStringLiteral("edit.to_front"), QStringLiteral("edit.to_back"),
               QStringLiteral("layer.lock")});
}

/// Returns the buttons of the tools, in the order of the tool bar.
QWidget* CanvasPopup::make_tools() {
  auto* box = new QWidget(this);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  int count = 0;
  for (const auto& tool : studio_.session().tools()) {
    QAction* action = actions_.find(QStringLiteral("tool.") + text_of(tool->info().id));
    if (!action) continue;
    auto* button = new QToolButton(box);
    button->setDefaultAction(action);
    button->setIconSize({kToolIconPx, kToolIconPx});
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAutoRaise(true);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    connect(button, &QAbstractButton::clicked, this, &QMenu::close);
    grid->addWidget(button, count / kToolColumns, count % kToolColumns);
    ++count;
  }
  grid->setColumnStretch(kToolColumns, 1);
  return box;
}

void CanvasPopup::add_actions(const QStringList& names) {
  for (const QString& name : names) {
    if (QAction* action = actions_.find(name)) addAction(action);
  }
}

/// Sets the colour of new ink and of the selected lines.
void CanvasPopup::set_color(Rgba color) {
  const std::string text = color_to_text(color);
  if (studio_.session().ink_color() != color) studio_.apply(SetOption{kInkColorId, text});
  if (!studio_.session().selection().empty()) studio_.apply(RestyleEvent{.color = text});
  close();
}

void add_popup_action(Actions& actions, Canvas& canvas) {
  actions
      .add(QStringLiteral("edit.popup"),
           QCoreApplication::translate("CanvasPopup", "Palette at the p&ointer"),
           {QKeySequence(Qt::Key_Menu)},
           QCoreApplication::translate("CanvasPopup",
                                       "Shows tools, media, colours and commands beside the pen."),
           [&canvas] { Q_EMIT canvas.popup_wanted(canvas.anchor()); })
      ->setIcon(icon_of("more"));
}

}  // namespace felt::desktop
