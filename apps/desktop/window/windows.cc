#include "desktop/window/windows.h"

#include <QFileInfo>
#include <algorithm>
#include <cstdio>

#include "desktop/engine/settings.h"
#include "desktop/window/window_setting_keys.h"

namespace felt::desktop {
namespace {

/// Offset from the previous window.
constexpr QPoint kStep{28, 28};

}  // namespace

Windows::Windows(StudioOptions first, QObject* parent)
    : QObject(parent), options_(std::move(first)) {}

MainWindow* Windows::make() {
  auto* window = new MainWindow(options_);
  options_ = {.device = options_.device, .live = options_.live};  // a recording contains only one
                                                                  // window
  window->setAttribute(Qt::WA_DeleteOnClose);
  if (!windows_.isEmpty()) window->move(windows_.back()->pos() + kStep);
  windows_.push_back(window);
  connect(window, &QObject::destroyed, this, [this, window] { windows_.removeOne(window); });
  connect(&window->files(), &FileActions::wants_window, this, &Windows::open_file);
  connect(&window->files(), &FileActions::path_changed, this, [window] { remember(*window); });
  connect(window, &MainWindow::wants_drawing, this,
          [this, window](const Document& drawing, const QString& title) {
            open_drawing(drawing, title, window);
          });
  return window;
}

MainWindow* Windows::open() {
  MainWindow* window = make();
  window->show();
  return window;
}

MainWindow* Windows::open_file(const QString& path) {
  if (path.isEmpty()) return open();
  const QString wanted = QFileInfo(path).canonicalFilePath();
  for (MainWindow* window : windows_) {
    if (wanted.isEmpty() || QFileInfo(window->files().path()).canonicalFilePath() != wanted)
      continue;
    window->raise();
    window->activateWindow();
    return window;
  }
  MainWindow* window = pristine();
  if (!window) window = open();
  // If the file cannot be opened, the window stays, because it shows the error.
  if (!window->files().open(path)) {
    std::fprintf(stderr, "feltline-desktop: %s could not be opened\n", qPrintable(path));
  }
  return window;
}

void Windows::release() {
  for (MainWindow* window : windows_) window->studio().loop().set_forces(false);
  for (MainWindow* window : windows_) {
    if (StudioAutosave* autosave = window->files().autosave()) autosave->flush();
  }
}

void Windows::end() {
  release();
  for (MainWindow* window : QList<MainWindow*>(windows_)) {
    window->keep_layout();
    delete window;  // closes its device without force; keeps its autosave if it is needed
  }
}

/// Returns a pristine window, or null if all windows are in use.
MainWindow* Windows::pristine() const {
  const auto found = std::find_if(windows_.begin(), windows_.end(), [](MainWindow* window) {
    return window->files().is_pristine() && !window->files().worker().is_busy();
  });
  return found == windows_.end() ? nullptr : *found;
}

MainWindow* Windows::open_drawing(const Document& drawing, const QString& title, MainWindow* here) {
  MainWindow* window = here && here->files().is_pristine() ? here : open();
  window->files().show_unsaved(drawing, Page{}, title);
  window->canvas().fit_page();
  window->raise();
  window->activateWindow();
  return window;
}

void Windows::remember(MainWindow& window) {
  const QString path = window.files().path();
  if (!path.isEmpty())
    Settings::the().set(window_keys::kLastFile, QFileInfo(path).absoluteFilePath());
}

QString Windows::last_file() {
  if (!Settings::the().flag(window_keys::kReopenLast, false)) return {};
  const QString path = Settings::the().text(window_keys::kLastFile);
  return QFileInfo::exists(path) ? path : QString();
}

}  // namespace felt::desktop
