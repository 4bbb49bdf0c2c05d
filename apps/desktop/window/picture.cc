#include "desktop/window/picture.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QKeyEvent>
#include <QPixmap>
#include <QThread>
#include <QToolButton>
#include <cstdio>
#include <memory>
#include <utility>

#include "desktop/engine/driver_watch.h"
#include "desktop/help/examples.h"
#include "desktop/help/script_player.h"
#include "desktop/help/tour_window.h"
#include "desktop/panels/tactile_panel.h"
#include "desktop/pens/steady_dialog.h"
#ifdef FELT_SOLIDS
#include "desktop/solid/solid_panel.h"
#endif
#include "desktop/window/main_window.h"
#include "desktop/window/preferences.h"
#include "desktop/window/ring_menu.h"
#include "desktop/window/theme.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kFrameNs = 16'000'000;

/// Returns an invented connected device, so that pictures do not depend on the hardware of this
/// machine.
PenDeviceInfo shown_pen() {
  PenDeviceInfo info;
  info.id = QStringLiteral("openhaptics:default");
  info.label = QStringLiteral("3D Systems Touch");
  info.moves_hand = info.has_own_frame = true;
  info.capabilities = find_stylus_preset("touch")->capabilities;
  return info;
}

int complain(const QString& text) {
  std::fprintf(stderr, "feltline-desktop: %s\n", qPrintable(text));
  return 1;
}

/// Processes all waiting events, as the event loop does.
void settle() {
  for (int i = 0; i < 30; ++i) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    QApplication::sendPostedEvents();
  }
}

bool lacks_pictures(const MainWindow& window) {
  if (window.media_pictures().of("pencil").isNull()) return true;
  for (const auto* button : window.findChildren<QToolButton*>()) {
    const bool has_one = button->toolButtonStyle() == Qt::ToolButtonTextUnderIcon;
    if (has_one && button->isVisible() && button->icon().isNull()) return true;
  }
  return false;
}

/// Waits until other threads have finished the pictures of surfaces and media, and the check of a
/// tactile drawing and the solid if their panels are shown.
void wait_for_pictures(const MainWindow& window) {
  constexpr int kMaxWaits = 500, kWaitMs = 20;
  const auto* tactile = window.findChild<TactilePanel*>();
  const auto checks = [tactile] {
    return tactile && tactile->isVisible() && !tactile->is_up_to_date();
  };
#ifdef FELT_SOLIDS
  const auto* solid = window.findChild<SolidPanel*>();
  const auto inflates = [solid] { return solid->isVisible() && !solid->is_up_to_date(); };
#else
  const auto inflates = [] { return false; };
#endif
  for (int i = 0; i < kMaxWaits && (lacks_pictures(window) || checks() || inflates()); ++i) {
    QThread::msleep(kWaitMs);
    settle();
  }
}

/// Lays out the rows of all lists. Lists that changed a moment ago do so by a timer, and would be
/// empty in the picture.
void lay_out_lists(const QWidget& seen) {
  for (auto* list : seen.findChildren<QAbstractItemView*>()) {
    if (list->isVisible()) list->doItemsLayout();
  }
}

QString play(Studio& studio, const PictureRequest& request) {
  QFile file(request.script);
  if (!file.open(QIODevice::ReadOnly)) {
    return QStringLiteral("%1: %2").arg(request.script, file.errorString());
  }
  const QByteArray text = file.readAll();
  ScriptPlayer player(studio);
  const Result<void> loaded = player.load(request.script, {text.data(), std::size_t(text.size())});
  if (!loaded) return QString::fromStdString(loaded.error().message);
  const std::int64_t end_ns = request.until_ms ? 1'000'000 * *request.until_ms : player.length_ns();
  while (!player.is_over() && player.played_ns() < end_ns) player.advance(kFrameNs);
  return {};
}

/// Opens the editor with this surface or medium, and waits for its previews.
QWidget* open_materials(MainWindow& window, const QString& id) {
  MaterialEditor& editor = window.material_editor();
  const bool is_surface = window.studio().materials().find_surface(id.toStdString()) != nullptr;
  if (!id.isEmpty()) window.materials().select({is_surface, id.toStdString()});
  editor.show();
  do {
    QThread::msleep(1);
    settle();
  } while (editor.probe().is_busy());
  return &editor;
}

/// Opens the ring of tools in the middle of the page, and chooses the tool on the right.
void open_ring(MainWindow& window) {
  auto* ring = window.findChild<RingMenu*>();
  ring->open(RingContent::kTools, QRectF(window.canvas().rect()).center(), RingMenu::By::kKey);
  QKeyEvent key(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
  for (int i = 0; i < 2; ++i) QApplication::sendEvent(ring, &key);
}

/// Lets the pen touch the right side of the solid, and presses.
void touch_solid(MainWindow& window) {
#ifdef FELT_SOLIDS
  constexpr int kSteps = 140, kHoverSteps = 70;  // the forces are on by then
  auto* panel = window.findChild<SolidPanel*>();
  QAction* action = window.actions().find(QStringLiteral("feel.touch_solid"));
  if (!panel->solid() || !action) return;
  action->setChecked(true);
  panel->scene().turn(40.0, 0.0);
  Studio& studio = window.studio();
  for (int i = 0; i < kSteps; ++i) {
    const Point at = panel->solid()->origin + Vec{0.1 * i - 10.0, 15.0};
    studio.point({studio.now_ns(), at, i > kHoverSteps, 1.0});
    studio.advance(kFrameNs);
  }
  settle();
#else
  static_cast<void>(window);
#endif
}

QWidget* open_dialog(MainWindow& window, const QString& name) {
  const QString what = name.section(QLatin1Char('/'), 0, 0),
                part = name.section(QLatin1Char('/'), 1);
  if (what == QStringLiteral("preferences")) {
    auto* dialog = new Preferences(window);
    if (!part.isEmpty() && !dialog->show_page(part)) return nullptr;
    return dialog;
  }
  if (what == QStringLiteral("steady-hand")) return new SteadyDialog(window.studio(), &window);
  if (what == QStringLiteral("materials")) return open_materials(window, part);
  if (what == QStringLiteral("tour")) {
    auto* tour = new TourWindow(&window);
    tour->go_to(part.toInt());
    while (tour->act() < part.toInt()) tour->play(kFrameNs);
    for (int i = 0; i < 200; ++i) tour->play(kFrameNs);
    return tour;
  }
  QAction* action = window.actions().find(QStringLiteral("help.") + what);
  if (!action) return nullptr;
  action->trigger();
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget != &window && widget->isVisible() && widget->parentWidget() == &window)
      return widget;
  }
  return nullptr;
}

}  // namespace

int make_picture(const PictureRequest& request) {
  apply_theme(theme_of(request.theme));
  MainWindow window({.device = QStringLiteral("simulated:touch"), .live = false});
  window.resize(request.size);
  window.show();
  settle();
  Studio& studio = window.studio();
  const DriverWatch drivers({});
  if (request.dialog == QStringLiteral("preferences/device")) {
    static SimulatedStylus stylus(*find_stylus_preset("touch"));
    add_pen_driver({[] { return std::vector{shown_pen()}; },
                    [](const QString&, const DeviceSetup&) -> Result<std::unique_ptr<OpenDevice>> {
                      return std::make_unique<OpenDevice>(stylus);
                    }});
    if (!studio.use_device(shown_pen().id)) return 1;
  }
  if (!request.file.isEmpty() && !window.files().open(request.file)) {
    return complain(QStringLiteral("%1: cannot be opened").arg(request.file));
  }
  if (!request.example.isEmpty()) studio.open(example_document(request.example), Page{});
  if (!request.script.isEmpty()) {
    if (const QString wrong = play(studio, request); !wrong.isEmpty()) return complain(wrong);
  }
  if (!request.tool.isEmpty() && !studio.apply(SelectTool{request.tool.toStdString()})) return 1;
  for (const QString& panel : request.panels) {
    if (!window.show_panel(panel)) {
      return complain(QStringLiteral("there is no panel \"%1\"").arg(panel));
    }
  }
  QWidget* seen = &window;
  const bool shows_ring = request.dialog == QStringLiteral("ring");
  const bool shows_touch = request.dialog == QStringLiteral("touch");
  const bool shows_onion = request.dialog == QStringLiteral("onion");
  if (shows_onion) window.actions().find(QStringLiteral("view.onion_skin"))->setChecked(true);
  if (!request.dialog.isEmpty() && !shows_ring && !shows_touch && !shows_onion) {
    seen = open_dialog(window, request.dialog);
    if (!seen) return complain(QStringLiteral("there is no dialog \"%1\"").arg(request.dialog));
    seen->show();
  }
  settle();
  window.canvas().fit_page();
  window.canvas().ink().finish();
  wait_for_pictures(window);
  settle();
  lay_out_lists(*seen);
  if (shows_ring) open_ring(window);
  if (shows_touch) touch_solid(window);
  return seen->grab().save(request.path) ? 0
                                         : complain(request.path + QStringLiteral(": not written"));
}

}  // namespace felt::desktop
