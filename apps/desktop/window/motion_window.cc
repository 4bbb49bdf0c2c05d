#include "desktop/window/motion_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <utility>

#include "desktop/canvas/film_view.h"
#include "desktop/canvas/match_view.h"
#include "desktop/files/animation_dialog.h"
#include "desktop/files/timelapse_actions.h"
#include "felt/formats/drawing_materials.h"
#include "felt/motion/key_layers.h"

namespace felt::desktop {
namespace {

QString motion_text(const char* english) {
  return QCoreApplication::translate("Motion", english);
}

/// Returns the key drawings. If there are less than two, says so and returns none.
std::vector<FilmKey> keys_to_show(Studio& studio) {
  studio.finish_gesture();
  std::vector<FilmKey> keys = film_keys(studio.session().document(), studio.page());
  for (auto& [drawing, timing] : keys) {
    drawing.materials =
        texts_of_used(drawing.document, drawing.page.surface, studio.session().materials());
  }
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

void export_animation(Canvas& canvas, FileActions& files) {
  QWidget* window = canvas.window();
  auto* films = window->findChild<TimelapseActions*>();
  std::vector<FilmKey> keys = keys_to_show(canvas.studio());
  if (keys.empty() || films->is_busy()) return;
  AnimationDialog dialog(window);
  if (dialog.exec() != QDialog::Accepted) return;
  AnimationRequest request = dialog.request();
  request.keys = std::move(keys);
  const QString path = ask_animation_name(files, window, request.format);
  if (path.isEmpty()) return;
  films->run(path, [path, request = std::move(request)](TimelapseProgress& progress) {
    return make_animation(path, request, progress);
  });
}

}  // namespace

void connect_motion(MotionPanel& panel, Canvas& canvas, FileActions& files, Actions& actions) {
  auto* film = new FilmView(canvas);
  QObject::connect(&panel, &MotionPanel::onion_changed, &canvas, &Canvas::set_onion);
  QObject::connect(&panel, &MotionPanel::wants_play, film, [&canvas, film] {
    if (film->is_playing()) return film->stop();
    std::vector<FilmKey> keys = keys_to_show(canvas.studio());
    if (!keys.empty()) film->play(std::move(keys));
  });
  auto* matches = new MatchView(canvas);
  QObject::connect(
      &panel, &MotionPanel::wants_matches, matches, [&actions, &canvas, matches](bool on) {
        if (!on) return matches->stop();
        if (matches->start())
          return actions.find(QStringLiteral("view.onion_skin"))->setChecked(true);
        actions.find(QStringLiteral("view.correct_matches"))->setChecked(false);
        Q_EMIT canvas.studio().refused(motion_text(QT_TRANSLATE_NOOP(
            "Motion", "Choose a key drawing that has a next one to correct its matches.")));
      });
  QObject::connect(matches, &MatchView::stopped, &canvas, [&actions] {
    actions.find(QStringLiteral("view.correct_matches"))->setChecked(false);
  });
  QObject::connect(film, &FilmView::stopped, &canvas, [&canvas](const QString& why) {
    if (!why.isEmpty()) Q_EMIT canvas.studio().refused(why);
  });
  QObject::connect(&panel, &MotionPanel::wants_export, &canvas,
                   [&canvas, &files] { export_animation(canvas, files); });
}

}  // namespace felt::desktop
