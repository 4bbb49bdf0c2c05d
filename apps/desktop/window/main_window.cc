#include "desktop/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "desktop/canvas/view_actions.h"
#include "desktop/engine/kept_options.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/wheel_guard.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_panel.h"
#include "desktop/feel/force_panel.h"
#include "desktop/files/clipboard_actions.h"
#include "desktop/files/notice_bar.h"
#include "desktop/help/help_actions.h"
#include "desktop/materials/media_picker.h"
#include "desktop/panels/colors_panel.h"
#include "desktop/panels/edit_actions.h"
#include "desktop/panels/guide_actions.h"
#include "desktop/panels/history_panel.h"
#include "desktop/panels/layers_panel.h"
#include "desktop/panels/motion_panel.h"
#include "desktop/panels/options_panel.h"
#include "desktop/panels/tactile_panel.h"
#include "desktop/panels/tool_bar.h"
#include "desktop/pens/pen_actions.h"
#include "desktop/pens/pen_input.h"
#ifdef FELT_SOLIDS
#include "desktop/solid/solid_actions.h"
#include "desktop/solid/solid_panel.h"
#include "desktop/solid/solid_touch_mode.h"
#endif
#include "desktop/window/canvas_popup.h"
#include "desktop/window/color_notice.h"
#include "desktop/window/drawing_looks.h"
#include "desktop/window/eyedropper.h"
#include "desktop/window/first_steps.h"
#include "desktop/window/menus.h"
#include "desktop/window/motion_window.h"
#include "desktop/window/offer_popup.h"
#include "desktop/window/preferences.h"
#include "desktop/window/preset_menu.h"
#include "desktop/window/press_through.h"
#include "desktop/window/ring_menu.h"
#include "desktop/window/status_line.h"
#include "desktop/window/tool_keys.h"
#include "desktop/window/top_bar.h"
#include "desktop/window/window_setting_keys.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

/// Version of the layout for restoreState(). If the stored version differs, the original layout is
/// used.
constexpr int kLayoutVersion = 1;
constexpr QSize kFirstWindowSize{1280, 820};
/// Part of the screen that is reserved for the frame around the window.
constexpr QSize kFrame{0, 40};
constexpr int kMinLines = 8;  // minimum number of lines of a panel that scrolls
/// Percentage of the height that the options panel gets; the layers panel gets the rest. A tool
/// usually has more options than a drawing has layers.
constexpr int kOptionsShare = 64;

[[maybe_unused]] constexpr int kMinSolidWidth = 400;  // of the solid view when it is opened

/// Puts a panel into a scroll area, so that it scrolls vertically if the screen is too small for
/// it.
QWidget* scrolled(QWidget* panel, const QString& name) {
  auto* area = new QScrollArea;
  area->setWidget(panel);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setAccessibleName(name);
  area->setMinimumSize(panel->minimumSizeHint().width(), kMinLines * panel->fontMetrics().height());
  return area;
}

StudioOptions with_own_materials(StudioOptions options) {
  options.materials = UserMaterials::the().known();
  return options;
}

}  // namespace

MainWindow::MainWindow(StudioOptions options, QWidget* parent)
    : QMainWindow(parent),
      studio_(new Studio(with_own_materials(std::move(options)), this)),
      canvas_(new Canvas(*studio_, this)),
      actions_(new Actions(this)),
      files_(new FileActions(*studio_, *actions_, this)),
      materials_(new MaterialEditorModel(*studio_, UserMaterials::the(), this)),
      media_pictures_(new MediaPictures(*studio_, this)) {
  setObjectName(QStringLiteral("main"));
  new KeptOptions(*studio_, this);
  setCentralWidget(canvas_with_notices());
  auto* pens = new PenInput(*canvas_);
  add_edit_actions(*actions_, *studio_);
  add_tool_actions(*actions_, *studio_);
  add_view_actions(*actions_, *canvas_);
  new Eyedropper(*actions_, *canvas_);
  add_pen_actions(*actions_, *pens);
  add_feel_actions(*actions_, *studio_, this);
  auto* help = new HelpActions(*actions_, this);
  connect(help, &HelpActions::wants_drawing, this, &MainWindow::wants_drawing);
  new ToolKeys(*actions_, *studio_, this);
  add_preset_actions(*actions_, *studio_, this);
  add_popup_action(*actions_, *canvas_);
  files_->clipboard().set_pointer([this]() -> std::optional<Point> {
    if (!canvas_->underMouse()) return std::nullopt;
    return canvas_->view().to_mm(canvas_->mapFromGlobal(QCursor::pos()));
  });
  make_panels();
  add_window_actions();
  add_material_actions();
  set_action_icons(*actions_);
  addToolBar(Qt::TopToolBarArea, new TopBar(*actions_, *canvas_, *media_pictures_, this));
  addToolBar(Qt::LeftToolBarArea, new ToolBar(*studio_, *actions_, this));
  auto* status = new StatusLine(*studio_, *canvas_, this);
  setStatusBar(status);
  connect(files_, &FileActions::path_changed, status, &StatusLine::set_file);
  connect(files_, &FileActions::saved, status,
          [this, status] { status->set_file(files_->path()); });
  make_menus(*this, *actions_, files_->recent_menu());
  auto* popup = new CanvasPopup(*actions_, *canvas_, *media_pictures_, this);
  connect(popup, &CanvasPopup::wants_paste, this,
          [this](Point at) { files_->clipboard().paste_at(at); });
  connect(studio_, &Studio::modified_changed, this, &MainWindow::show_title);
  connect(files_, &FileActions::path_changed, this, &MainWindow::show_title);
  connect(files_, &FileActions::drawing_changed, this, &MainWindow::show_title);
  connect(this, &MainWindow::wants_preferences, this, [this] {
    if (!preferences_) preferences_ = new Preferences(*this);
    preferences_->show();
    preferences_->raise();
    preferences_->activateWindow();
  });
  show_title();
  place_panels();
  resize(kFirstWindowSize.boundedTo(screen()->availableSize() - kFrame));
  restoreGeometry(Settings::the().value(window_keys::kGeometry).toByteArray());
  restoreState(Settings::the().value(window_keys::kLayout).toByteArray(), kLayoutVersion);
  check_panel_actions();
  qApp->installEventFilter(this);
  canvas_->setFocus();
}

/// Returns the canvas with the messages about the device, unsupported content and the colour over
/// its upper edge. The messages lie over the canvas, because a canvas of another size would show
/// the page elsewhere, also under a pen that draws.
QWidget* MainWindow::canvas_with_notices() {
  auto* middle = new QWidget(this);
  auto* both = new QGridLayout(middle);
  both->setContentsMargins(0, 0, 0, 0);
  both->addWidget(canvas_, 0, 0);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  both->addLayout(column, 0, 0, Qt::AlignTop);
  auto* notices = new NoticeBar(middle);
  device_notice_ = new DeviceNotice(middle);
  for (QWidget* notice : {static_cast<QWidget*>(device_notice_), static_cast<QWidget*>(notices),
                          static_cast<QWidget*>(new ColorNotice(*studio_, middle))}) {
    column->addWidget(notice);
    notice->raise();
  }
  care_ = new DeviceCare(*studio_, *device_notice_, this);
  connect(files_, &FileActions::taken, notices, &NoticeBar::show_report);
  connect(files_, &FileActions::drawing_changed, notices, &NoticeBar::forget_report);
  connect(files_, &FileActions::exported, notices, &NoticeBar::show_written);
  if (const QStringList wrong = UserMaterials::the().take_problems(); !wrong.isEmpty()) {
    notices->show_words(tr("Some of your materials could not be read:") + QLatin1Char('\n') +
                        wrong.join(QLatin1Char('\n')));
  }
  return middle;
}

MainWindow::~MainWindow() {
  // The base class hides the panels after the members of this class are gone.
  for (QDockWidget* panel : panels_) panel->toggleViewAction()->disconnect();
}

QDockWidget* MainWindow::add_panel(const QString& name, const QString& title, QWidget* panel,
                                   const QList<QKeySequence>& keys) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(panel);
  panels_.push_back(dock);
  QAction* action =
      actions_->add_switch(QStringLiteral("view.panel_") + name, title, keys,
                           tr("Shows or hides the panel %1").arg(title), true, [dock](bool on) {
                             if (on == !dock->isHidden()) return;
                             dock->setVisible(on);
                             if (on) dock->raise();
                           });
  // The action follows the dock's own action and not its visibility, because a panel behind another
  // tab is open but not visible.
  connect(dock->toggleViewAction(), &QAction::toggled, action, &QAction::setChecked);
  return dock;
}

void MainWindow::make_panels() {
  guard_values_from_wheel();
  setDockNestingEnabled(true);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  const OptionPicker media = [this](QWidget* parent) {
    return new MediaPicker(*studio_, *media_pictures_, parent);
  };
  add_panel(
      QStringLiteral("options"), tr("Options"),
      new OptionsPanel(*studio_, nullptr, {{drawing_option(studio_->session(), "medium"), media}}));
  auto* feel = new FeelPanel(*studio_);
  add_panel(QStringLiteral("feel"), tr("Feel"), scrolled(feel, tr("Feel")));
  connect(feel, &FeelPanel::wants_editor, this,
          [this] { actions_->find(QStringLiteral("view.materials"))->trigger(); });
  auto* layers = new LayersPanel(*studio_);
  add_panel(QStringLiteral("layers"), tr("Layers"), layers);
  add_layer_actions(*actions_, *studio_, *layers);
  add_guide_actions(*actions_, *studio_);
  auto* colors = new ColorsPanel(*studio_);
  add_panel(QStringLiteral("colors"), tr("Colours"), scrolled(colors, tr("Colours")));
  add_color_actions(*actions_, *colors);
  files_->set_looks(looks_of(*canvas_, *colors));
  add_panel(QStringLiteral("history"), tr("History"), new HistoryPanel(*studio_));
  auto* tactile = new TactilePanel(*studio_);
  QDockWidget* dock = add_panel(QStringLiteral("tactile"), tr("Tactile check"), tactile);
  connect(actions_->find(QStringLiteral("view.panel_tactile")), &QAction::toggled, tactile,
          [this, tactile, dock](bool on) {
            // The marks stay while all panels are hidden.
            if (!hidden_.contains(dock)) tactile->set_on(on);
          });
  connect(tactile, &TactilePanel::marks_changed, canvas_, &Canvas::set_notes);
  connect(tactile, &TactilePanel::wants_position, canvas_, &Canvas::center_on);
  auto* motion = new MotionPanel(*studio_, *actions_);
  add_panel(QStringLiteral("motion"), tr("Motion"), motion);
  connect_motion(*motion, *canvas_, *files_, *actions_);
  // The panel scrolls on a small screen, because its text may need many lines.
  add_panel(QStringLiteral("forces"), tr("Forces"),
            scrolled(new ForcePanel(*studio_), tr("Forces")));
  make_solid_panel();
  new PullHint(*actions_, *canvas_);
  new ExampleButton(*actions_->find(QStringLiteral("help.example_cat")), *canvas_);
}

/// Adds the solid view, if this program is built with solids.
void MainWindow::make_solid_panel() {
#ifdef FELT_SOLIDS
  auto* solid = new SolidPanel(*studio_);
  QDockWidget* dock =
      add_panel(QStringLiteral("solid"), tr("Solid view"), solid, {QKeySequence(Qt::Key_F9)});
  add_solid_actions(*actions_, *files_, *solid, this);
  new SolidTouchMode(*studio_, *solid, *actions_, this);
  connect(actions_->find(QStringLiteral("view.panel_solid")), &QAction::toggled, solid,
          [this, solid, dock](bool on) {
            // A dock that was never shown gets its minimum width.
            if (on && dock->width() < kMinSolidWidth) {
              resizeDocks({dock}, {kMinSolidWidth}, Qt::Horizontal);
            }
            // It follows the drawing also while all panels are hidden.
            if (!hidden_.contains(dock)) solid->set_on(on);
          });
#endif
}

void MainWindow::place_panels() {
  const auto dock = [this](const char* name) {
    return findChild<QDockWidget*>(QString::fromLatin1(name));
  };
  for (QDockWidget* panel : panels_) {
    removeDockWidget(panel);
    panel->setFloating(false);
    panel->show();
  }
  QDockWidget* solid = dock("solid");  // null in a program without solids
  // On the other side, so that the page and not another panel gets its room when it is closed.
  if (solid) addDockWidget(Qt::LeftDockWidgetArea, solid);
  addDockWidget(Qt::RightDockWidgetArea, dock("options"));
  // This split must come first, because splitting beside a tabbed panel only adds a tab.
  splitDockWidget(dock("options"), dock("layers"), Qt::Vertical);
  tabifyDockWidget(dock("options"), dock("feel"));
  tabifyDockWidget(dock("layers"), dock("colors"));
  tabifyDockWidget(dock("colors"), dock("history"));
  tabifyDockWidget(dock("history"), dock("tactile"));
  tabifyDockWidget(dock("tactile"), dock("motion"));
  addDockWidget(Qt::BottomDockWidgetArea, dock("forces"));
  for (QDockWidget* hidden : {dock("forces"), dock("tactile"), dock("motion"), solid}) {
    if (hidden) hidden->hide();  // hidden at first, to keep the window simple
  }
  check_panel_actions();
  dock("options")->raise();
  dock("layers")->raise();
  resizeDocks({dock("options"), dock("layers")}, {kOptionsShare, 100 - kOptionsShare},
              Qt::Vertical);
}

/// Sets the panel actions directly, because a dock reports that it is hidden only after it was
/// shown once.
void MainWindow::check_panel_actions() {
  for (const QDockWidget* panel : panels_) {
    QAction* action = actions_->find(QStringLiteral("view.panel_") + panel->objectName());
    if (action) action->setChecked(!panel->isHidden());
  }
}

void MainWindow::reset_layout() {
  hide_panels(false);
  place_panels();
}

bool MainWindow::show_panel(const QString& name) {
  for (QDockWidget* panel : panels_) {
    if (panel->objectName() != name) continue;
    panel->show();
    panel->raise();
    return true;
  }
  return false;
}

void MainWindow::add_window_actions() {
  add_ring_menu(*actions_, *canvas_, *media_pictures_, this);
  add_offer_popup(*actions_, *canvas_);
  new PressThrough(*this);
  actions_->add_switch(QStringLiteral("view.hide_panels"), tr("&Hide all panels"),
                       {QKeySequence(Qt::Key_Tab)}, tr("Shows only the drawing area"), false,
                       [this](bool on) { hide_panels(on); });
  actions_->add_switch(QStringLiteral("view.full_screen"), tr("&Full screen"),
                       {QKeySequence(Qt::Key_F11)}, tr("The window fills the screen"), false,
                       [this](bool on) { set_full_screen(on); });
  actions_->add(QStringLiteral("view.next_part"), tr("&Next part of the window"),
                {QKeySequence(Qt::Key_F6)},
                tr("Moves the focus from the drawing area to the tools, to each panel, and back"),
                [this] { go_to_next_part(); });
  actions_->add(QStringLiteral("view.reset_layout"), tr("&Reset the panels"), {},
                tr("Restores the default layout of panels and bars"), [this] { reset_layout(); });
  actions_->add(QStringLiteral("edit.preferences"), tr("&Preferences\u2026"),
                {QKeySequence(Qt::CTRL | Qt::Key_Comma)},
                tr("Theme, language, pen, device and shortcuts"),
                [this] { Q_EMIT wants_preferences(); });
  if (!actions_->find(QStringLiteral("file.close"))) {
    actions_->add(QStringLiteral("file.close"), tr("&Close"), {QKeySequence(Qt::CTRL | Qt::Key_W)},
                  tr("Closes this window"), [this] { close(); });
  }
  if (!actions_->find(QStringLiteral("file.quit"))) {
    actions_->add(QStringLiteral("file.quit"), tr("&Quit"), {QKeySequence(Qt::CTRL | Qt::Key_Q)},
                  tr("Closes all windows"), [] { QApplication::closeAllWindows(); });
  }
}

MaterialEditor& MainWindow::material_editor() {
  if (!material_editor_) material_editor_ = new MaterialEditor(*studio_, *materials_, this);
  return *material_editor_;
}

void MainWindow::add_material_actions() {
  actions_->add(QStringLiteral("view.materials"), tr("Ma&terials\u2026"),
                {QKeySequence(Qt::CTRL | Qt::Key_M)},
                tr("Change how surfaces and media feel, look and sound, and make your own"),
                [this] {
                  material_editor().show();
                  material_editor().raise();
                  material_editor().activateWindow();
                });
  actions_->add(QStringLiteral("view.compare_materials"), tr("&Compare materials A and B"),
                {QKeySequence(Qt::Key_B)},
                tr("Switch between the two materials that the editor compares"),
                [this] { materials_->flip(); });
}

void MainWindow::hide_panels(bool hide) {
  if (!hide) return show_panels();
  if (hidden_.isEmpty()) layout_ = saveState(kLayoutVersion);
  QList<QWidget*> all;
  for (QDockWidget* panel : panels_) all.push_back(panel);
  for (QToolBar* bar : findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) all.push_back(bar);
  all.push_back(statusBar());
  for (QWidget* widget : all) {
    if (widget->isHidden()) continue;
    hidden_.push_back(widget);
    widget->hide();
  }
  canvas_->setFocus();
}

/// Shows the panels that hide_panels() has hidden, with their former sizes. Qt alone would give
/// each panel a size as if it were added to those that are there already. If another panel was
/// opened meanwhile, it needs space of theirs.
void MainWindow::show_panels() {
  if (hidden_.isEmpty()) return;
  const bool is_same = std::all_of(panels_.begin(), panels_.end(),
                                   [](const QDockWidget* panel) { return panel->isHidden(); });
  for (QWidget* widget : hidden_) widget->show();
  if (is_same) restoreState(layout_, kLayoutVersion);
  hidden_.clear();  // not earlier, because the panels are hidden and shown once more
}

void MainWindow::set_full_screen(bool on) {
  setWindowState(windowState().setFlag(Qt::WindowFullScreen, on));
}

/// Moves the keyboard focus to the next part: the canvas, the bars, the visible panels.
void MainWindow::go_to_next_part() {
  QList<QWidget*> parts{canvas_};
  for (QToolBar* bar : findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) parts.push_back(bar);
  for (QDockWidget* panel : panels_) {
    if (panel->isVisible() && !panel->visibleRegion().isEmpty()) parts.push_back(panel->widget());
  }
  const QWidget* focus = QApplication::focusWidget();
  qsizetype at = 0;
  for (qsizetype i = 0; i < parts.size(); ++i) {
    if (focus && (parts[i] == focus || parts[i]->isAncestorOf(focus))) at = i;
  }
  for (qsizetype step = 1; step <= parts.size(); ++step) {
    QWidget* part = parts[(at + step) % parts.size()];
    if (part == canvas_) return canvas_->setFocus(Qt::TabFocusReason);
    for (QWidget* child : part->findChildren<QWidget*>()) {
      if (!(child->focusPolicy() & Qt::TabFocus) || !child->isVisible() || !child->isEnabled()) {
        continue;
      }
      return child->setFocus(Qt::TabFocusReason);
    }
  }
}

void MainWindow::show_title() {
  // Qt replaces "[*]" in a window title by the mark of unsaved changes; "[*][*]" appears as "[*]".
  QString name = files_->display_name();
  name.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]"));
  if (files_->is_read_only()) name += tr(" (read-only)");
  setWindowTitle(name + QStringLiteral("[*] \u2013 Feltline"));
  setWindowModified(studio_->is_modified());
  setWindowFilePath(files_->path());
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  // If the canvas has the focus, Tab hides the panels; elsewhere it moves the focus. If the canvas
  // ignores a ShortcutOverride, its parents receive it, so the focus is checked here.
  if (event->type() == QEvent::ShortcutOverride && !canvas_->hasFocus() &&
      watched->isWidgetType() && static_cast<QWidget*>(watched)->window() == this) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool is_plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    if (is_plain && key->key() == Qt::Key_Tab) event->accept();
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && actions_) set_action_icons(*actions_);
  if (event->type() == QEvent::WindowStateChange) {
    QAction* action = actions_->find(QStringLiteral("view.full_screen"));
    if (action) action->setChecked(isFullScreen());
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(files_->may_close());
  if (event->isAccepted()) keep_layout();
}

void MainWindow::keep_layout() {
  hide_panels(false);
  if (!isFullScreen()) Settings::the().set(window_keys::kGeometry, saveGeometry());
  Settings::the().set(window_keys::kLayout, saveState(kLayoutVersion));
}

}  // namespace felt::desktop
