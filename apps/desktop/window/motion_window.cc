#include "desktop/window/motion_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <utility>

#include "desktop/canvas/film_view.h"
#include "desktop/files/animation_dialog.h"
#include "desktop/files/timelapse_actions.h"
#include "desktop/panels/key_layers.h"

namespace felt::desktop {
namespace {

QString motion_text(const char* english) {
  return QCoreApplication::translate("Motion", english);
}

/// Returns the key drawings. If there are less than two, says so and returns none.
std::vector<Drawing> keys_to_show(Studio& studio) {
  studio.finish_gesture();
  std::vector<Drawing> keys = key_drawings(studio.session().document(), studio.page());
  if (keys.size() >= 2) return keys;
  Q_EMIT studio.refused(motion_text(QT_TRANSLATE_NOOP(
      "Motion", "A motion needs two key drawings: two layers with lines that are not locked.")));
  return {};
}

/// Asks for a name. Asks again if adding the extension gives the name of an existing file.
QString ask_animation_name(FileActions& files, QWidget* window, AnimationFormat format) {
  const QString suffix = suffix_of(format);
  const QString base = QFileInfo(files.display_name()).completeBaseName();
  QString suggested = QDir(files.folder()).filePath(base + suffix);
  for (;;) {
    const QString chosen = files.dialogs().save_name(
        window, motion_text(QT_TRANSLATE_NOOP("Motion", "Export animation")), suggested,
        filter_of(format), suffix.mid(1));
    if (chosen.isEmpty()) return {};
    const QString name = QFileInfo(chosen).absoluteFilePath();
    if (name.endsWith(suffix, Qt::CaseInsensitive)) return name;
    if (!QFileInfo::exists(name + suffix)) return name + suffix;
    suggested = name + suffix;
  }
}

void export_animation(MotionPanel& panel, Canvas& canvas, FileActions& files) {
  QWidget* window = canvas.window();
  auto* films = window->findChild<TimelapseActions*>();
  std::vector<Drawing> keys = keys_to_show(canvas.studio());
  if (keys.empty() || films->is_busy()) return;
  AnimationDialog dialog(window);
  if (dialog.exec() != QDialog::Accepted) return;
  AnimationRequest request = dialog.request();
  request.keys = std::move(keys);
  request.film = panel.options();
  const QString path = ask_animation_name(files, window, request.format);
  if (path.isEmpty()) return;
  films->run(path, [path, request = std::move(request)](TimelapseProgress& progress) {
    return make_animation(path, request, progress);
  });
}

}  // namespace

void connect_motion(MotionPanel& panel, Canvas& canvas, FileActions& files) {
  auto* film = new FilmView(canvas);
  QObject::connect(&panel, &MotionPanel::onion_changed, &canvas, &Canvas::set_onion);
  QObject::connect(&panel, &MotionPanel::wants_play, film, [&panel, &canvas, film] {
    if (film->is_playing()) return film->stop();
    std::vector<Drawing> keys = keys_to_show(canvas.studio());
    if (!keys.empty()) film->play(std::move(keys), panel.options());
  });
  QObject::connect(film, &FilmView::stopped, &canvas, [&canvas](const QString& why) {
    if (!why.isEmpty()) Q_EMIT canvas.studio().refused(why);
  });
  QObject::connect(&panel, &MotionPanel::wants_export, &canvas,
                   [&panel, &canvas, &files] { export_animation(panel, canvas, files); });
}

}  // namespace felt::desktop
