#include "desktop/window/picture.h"

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <QPixmap>
#include <cstdio>
#include <memory>

#include "desktop/help/examples.h"
#include "desktop/help/script_player.h"
#include "desktop/help/tour_window.h"
#include "desktop/window/main_window.h"
#include "desktop/window/preferences.h"
#include "desktop/window/theme.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kFrameNs = 16'000'000;

int complain(const QString& text) {
  std::fprintf(stderr, "feltline-desktop: %s\n", qPrintable(text));
  return 1;
}

/// What a screen would do meanwhile.
void settle() {
  for (int i = 0; i < 30; ++i) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    QApplication::sendPostedEvents();
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

QWidget* open_dialog(MainWindow& window, const QString& name) {
  const QString what = name.section(QLatin1Char('/'), 0, 0),
                part = name.section(QLatin1Char('/'), 1);
  if (what == QStringLiteral("preferences")) {
    auto* dialog = new Preferences(window);
    if (!part.isEmpty() && !dialog->show_page(part)) return nullptr;
    return dialog;
  }
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
  if (!request.example.isEmpty()) studio.open(example_document(request.example), SheetPage{});
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
  if (!request.dialog.isEmpty()) {
    seen = open_dialog(window, request.dialog);
    if (!seen) return complain(QStringLiteral("there is no dialog \"%1\"").arg(request.dialog));
    seen->show();
  }
  settle();
  window.canvas().fit_page();
  window.canvas().ink().finish();
  settle();
  return seen->grab().save(request.path) ? 0
                                         : complain(request.path + QStringLiteral(": not written"));
}

}  // namespace felt::desktop
