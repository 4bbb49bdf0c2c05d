#include "desktop/files/picture_actions.h"

#include <QApplication>
#include <QFileInfo>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/files/error_words.h"
#include "desktop/files/files_setting_keys.h"

namespace felt::desktop {

namespace {

/// So faint that lines can be seen over any picture, and the picture below them.
constexpr double kOpacity = 0.5;

}  // namespace

PictureActions::PictureActions(Studio& studio, Actions& actions, FileDialogs& dialogs,
                               QWidget* window)
    : QObject(window), studio_(studio), dialogs_(dialogs), window_(window) {
  actions.add(QStringLiteral("file.import_picture"), tr("Import p&icture…"), {},
              tr("Add a picture or a page of a PDF file to draw over"),
              [this] { ask(Settings::the().text(files_keys::kLastFolder)); });
  connect(&studio, &Studio::tool_changed, this, &PictureActions::return_to_layer);
  connect(&studio, &Studio::opened, this, [this] { placed_ = {}; });
  connect(&studio, &Studio::layer_changed, this, [this] {
    if (placed_ != studio_.session().layer()) placed_ = {};
  });
}

void PictureActions::ask(const QString& folder) {
  const QString filter = tr("Pictures") + QStringLiteral(" (%1)").arg(picture_filter());
  const QString path = dialogs_.open_name(window_, tr("Import a picture"), folder, filter);
  if (!path.isEmpty()) add_file(path);
}

bool PictureActions::add_file(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  const Result<int> pages = page_count(path);
  if (!pages) {
    show_error(name, pages.error());
    return false;
  }
  const int page = *pages > 1 ? dialogs_.ask_page(window_, name, *pages) : 1;
  if (page < 1) return false;
  Settings::the().set(files_keys::kLastFolder, QFileInfo(path).absolutePath());
  QApplication::setOverrideCursor(Qt::WaitCursor);
  const bool done = add(name, read_picture(path, page));
  QApplication::restoreOverrideCursor();
  return done;
}

bool PictureActions::add_image(const QString& name, const QImage& image) {
  return add(name, ReadPicture{image});
}

bool PictureActions::add(const QString& name, const Result<ReadPicture>& picture) {
  Result<AddPicture> event = picture.and_then(
      [&](const ReadPicture& read) { return add_picture_event(name, read, studio_.page()); });
  if (!event) {
    show_error(name, event.error());
    return false;
  }
  event->opacity = kOpacity;
  const LayerId before = studio_.session().layer();
  const bool follows_picture = before == placed_;  // several may come one after the other
  studio_.apply(SelectStrokes{SelectStrokes::What::kNone});
  if (!studio_.apply(*std::move(event))) return false;
  if (!follows_picture) drawn_on_ = before;
  studio_.apply(SelectTool{"transform"});
  placed_ = studio_.session().layer();
  return true;
}

void PictureActions::return_to_layer() {
  if (studio_.session().tool().info().kind == ToolKind::kTransforms) return;
  if (std::exchange(placed_, {}) != studio_.session().layer()) return;
  const Layer* layer = studio_.session().document().layer(drawn_on_);
  if (layer && layer->visible && !layer->locked) {
    studio_.apply(LayerEvent{LayerEvent::Do::kUse, drawn_on_});
  }
}

void PictureActions::show_error(const QString& name, const Error& error) {
  dialogs_.show_error(window_, tr("“%1” cannot be imported").arg(name), error_words(error),
                      text_of(error));
}

}  // namespace felt::desktop
