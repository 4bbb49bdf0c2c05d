#include "desktop/window/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>

#include "desktop/feel/feel_panel.h"
#include "desktop/feel/force_panel.h"
#include "desktop/help/help_actions.h"
#include "desktop/panels/colors_panel.h"
#include "desktop/panels/history_panel.h"
#include "desktop/panels/layers_panel.h"
#include "desktop/panels/options_panel.h"
#include "desktop/pens/pen_input.h"

namespace felt::desktop {

MainWindow::MainWindow(StudioOptions options, QWidget* parent)
    : QMainWindow(parent),
      studio_(new Studio(std::move(options), this)),
      canvas_(new Canvas(*studio_, this)),
      actions_(new Actions(this)),
      files_(new FileActions(*studio_, *actions_, this)) {
  setCentralWidget(canvas_);
  new PenInput(*canvas_);
  add_help_actions(*actions_, *canvas_, this);
  const auto dock = [this](QWidget* panel, const QString& title, Qt::DockWidgetArea area) {
    auto* widget = new QDockWidget(title, this);
    widget->setWidget(panel);
    addDockWidget(area, widget);
  };
  dock(new OptionsPanel(*studio_), tr("Options"), Qt::LeftDockWidgetArea);
  dock(new FeelPanel(*studio_), tr("Feel"), Qt::LeftDockWidgetArea);
  dock(new LayersPanel(*studio_), tr("Layers"), Qt::RightDockWidgetArea);
  dock(new HistoryPanel(*studio_), tr("History"), Qt::RightDockWidgetArea);
  dock(new ColorsPanel(*studio_), tr("Colours"), Qt::RightDockWidgetArea);
  dock(new ForcePanel(*studio_), tr("Forces"), Qt::BottomDockWidgetArea);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(files_->may_close());
}

}  // namespace felt::desktop
