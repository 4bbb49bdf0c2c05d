#include "desktop/files/file_actions.h"

#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/engine/usual_color.h"
#include "desktop/files/added_strokes.h"
#include "desktop/files/clipboard_actions.h"
#include "desktop/files/error_words.h"
#include "desktop/files/files_setting_keys.h"
#include "desktop/files/format_texts.h"
#include "desktop/files/output_actions.h"
#include "desktop/files/picture_actions.h"
#include "desktop/files/recent_pictures.h"
#include "desktop/files/timelapse_actions.h"
#include "felt/formats/drawing_materials.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

QStringList local_files(const QMimeData* data) {
  QStringList paths;
  const QList<QUrl> urls = data->urls();
  for (const QUrl& url : urls) {
    if (url.isLocalFile()) paths.push_back(url.toLocalFile());
  }
  return paths;
}

QDateTime changed_at(const QString& path) {
  const QFileInfo info(path);
  return info.exists() ? info.lastModified() : QDateTime();
}

/// Returns the usual paper colour of a new page with that surface.
Rgba usual_paper(const SurfaceMaterial& surface) {
  return usual_color(Page{}.paper, {}, surface.color_rgb, Page{}.paper);
}

/// Returns true if Save may overwrite the file: it is a .felt file by content and by extension.
bool is_own_file(const Imported& opened, const QString& path) {
  // A damaged file is not overwritten, because later versions may recover more of it.
  return opened.is_exact && opened.format == FileFormat::kFelt &&
         format_of_path(path.toStdString()) == FileFormat::kFelt;
}

/// Returns the materials for the drawing's file and its autosave. They include the medium of the
/// tool, because the program may crash during the first stroke with this medium.
std::vector<std::string> user_materials(const Session& session, const Drawing& drawing) {
  const std::vector<std::string> also{drawing_medium(session)};
  return texts_of_used(drawing.document, drawing.page.surface, session.materials(), also);
}

}  // namespace

FileActions::FileActions(Studio& studio, Actions& actions, QWidget* window,
                         std::unique_ptr<FileDialogs> dialogs)
    : QObject(window),
      studio_(studio),
      window_(window),
      dialogs_(dialogs ? std::move(dialogs) : std::make_unique<FileDialogs>()),
      recent_menu_(new QMenu(tr("Open &recent"), window)) {
  add_file_actions(actions);
  pictures_ = new PictureActions(studio, actions, *dialogs_, window);
  clipboard_ = new ClipboardActions(studio, actions, *dialogs_, *pictures_, names_, window);
  connect(clipboard_, &ClipboardActions::taken, this, &FileActions::report_added);
  auto* output = new OutputActions(*this, studio, actions, window);
  connect(output, &OutputActions::exported, this,
          [this](const QString& path, bool done, const LostObjects& lost, const QString& changed) {
            if (done) Q_EMIT exported(path, lost, changed);
          });
  auto* films = new TimelapseActions(*this, studio, actions, window);
  connect(films, &TimelapseActions::made, this,
          [this](const QString& path, bool done, const QString& changed) {
            if (done) Q_EMIT exported(path, LostObjects(), changed);
          });
  connect(recent_menu_, &QMenu::aboutToShow, this, &FileActions::fill_recent_menu);
  show_large_icons(*recent_menu_);
  fill_recent_menu();
  connect(&studio, &Studio::opened, this, &FileActions::receive_opened);
  if (studio.loop().thread()) {
    start_autosave(recovery_roots());
    offer_once();
  }
  window->setAcceptDrops(true);
  window->installEventFilter(this);
}

FileActions::~FileActions() = default;

void FileActions::add_file_actions(Actions& actions) {
  actions.add(QStringLiteral("file.new"), tr("&New"), {QKeySequence::New},
              tr("Start a new drawing"), [this] { start_new(); });
  actions.add(QStringLiteral("file.open"), tr("&Open…"), {QKeySequence::Open},
              tr("Open a drawing from a file"), [this] { ask_open(); });
  actions.add(QStringLiteral("file.save"), tr("&Save"), {QKeySequence::Save},
              tr("Save the drawing to its file"), [this] { save(); });
  actions.add(QStringLiteral("file.save_as"), tr("Save &as…"),
              {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
              tr("Save the drawing to another file"), [this] { save_as(); });
  actions.add(QStringLiteral("file.import"), tr("&Import…"), {QKeySequence(Qt::CTRL | Qt::Key_I)},
              tr("Add the strokes of another file to this drawing"), [this] { ask_import(); });
  actions.add(QStringLiteral("file.close"), tr("&Close"), {QKeySequence(Qt::CTRL | Qt::Key_W)},
              tr("Close this window"), [this] { window_->close(); });
  QAction* quit =
      actions.add(QStringLiteral("file.quit"), tr("&Quit"), {QKeySequence(Qt::CTRL | Qt::Key_Q)},
                  tr("Quit the program"), [] { QApplication::closeAllWindows(); });
  quit->setMenuRole(QAction::QuitRole);
}

bool FileActions::is_read_only() const {
  constexpr auto kAnyWriter = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
  const QFileInfo info(path_);
  // The second condition is for root, who may write any file: a file without any write permission
  // counts as read-only, too.
  return info.exists() && (!info.isWritable() || !(info.permissions() & kAnyWriter));
}

QString FileActions::display_name() const {
  if (!path_.isEmpty()) return QFileInfo(path_).fileName();
  return name_.isEmpty() ? tr("Untitled") : name_;
}

bool FileActions::is_pristine() const {
  return path_.isEmpty() && name_.isEmpty() && !studio_.is_modified() &&
         studio_.session().document().stroke_count() == 0 &&
         studio_.session().document().fill_count() == 0;
}

Drawing FileActions::drawing() const {
  const Session& session = studio_.session();
  Drawing drawing;
  drawing.document = session.document();
  drawing.page = studio_.page();
  if (drawing.page.surface.empty()) drawing.page.surface = session.surface().id;
  drawing.materials = user_materials(session, drawing);
  drawing.color = session.ink_color();
  drawing.layer = session.layer();
  drawing.extras = extras_;
  drawing.names = names_;
  if (looks_.report) looks_.report(drawing);
  return drawing;
}

// --- Another drawing

void FileActions::start_new() {
  if (!may_replace()) return;
  Drawing fresh;
  // Keeps a page that the user set up here, but not the page that came with an opened file.
  if (!has_page_of_file_) fresh.page = studio_.page();
  fresh.page.surface = studio_.session().surface().id;
  if (has_page_of_file_) fresh.page.paper = usual_paper(studio_.session().surface());
  fresh.color = studio_.session().ink_color();
  // Surface and medium stay, even if they came only with the previous drawing.
  fresh.materials = user_materials(studio_.session(), fresh);
  show(std::move(fresh), {}, {});
}

void FileActions::ask_open() {
  const QString path =
      dialogs_->open_name(window_, tr("Open a drawing"), last_folder(), open_filters());
  if (!path.isEmpty()) open(path);
}

/// Reads a file on the worker's thread. If a .felt file is damaged, offers the readable part.
Result<Imported> FileActions::read(const QString& path) {
  Result<Imported> opened = fail(ErrorCode::kIo, ""), rescued = opened;
  worker_.start([&, path] {
    opened = open_drawing(path);
    if (!opened && opened.error().code == ErrorCode::kInvalidData) {
      rescued = open_drawing(path, true);
    }
    return FileWorker::Answer();
  });
  QApplication::setOverrideCursor(Qt::WaitCursor);
  worker_.wait();
  QApplication::restoreOverrideCursor();
  if (opened || !rescued) return opened;
  const auto strokes = int(rescued->drawing.document.stroke_count());
  const bool wanted = strokes > 0 && dialogs_->ask_salvage(window_, QFileInfo(path).fileName(),
                                                           text_of(opened.error()), strokes);
  return wanted ? rescued : opened;
}

bool FileActions::open(const QString& given) {
  const QString path = QFileInfo(given).absoluteFilePath();
  worker_.wait();
  Result<Imported> opened = read(path);
  if (opened) {
    // The user is asked about unsaved changes only after the file could be read.
    const QDateTime read_at = changed_at(path);
    if (!may_replace()) return false;
    if (changed_at(path) != read_at) opened = read(path);  // the user has just saved to this file
  }
  // A photo is not a drawing, but one can draw over it.
  if (!opened && is_picture_path(path) && QFileInfo(path).isFile()) {
    return pictures_->add_file(path);
  }
  if (!opened) {
    dialogs_->show_error(window_, tr("“%1” cannot be opened").arg(QFileInfo(path).fileName()),
                         error_words(opened.error()), text_of(opened.error()));
    return false;
  }
  const bool is_own = is_own_file(*opened, path);
  folder_ = QFileInfo(path).path();
  show(std::move(opened->drawing), is_own ? path : QString(),
       is_own ? QString() : QFileInfo(path).completeBaseName());
  has_page_of_file_ = true;
  remember(path);
  Q_EMIT taken(QFileInfo(path).fileName(), opened->report);
  return true;
}

void FileActions::show_unsaved(Document document, const Page& page, const QString& name) {
  Drawing as_it_looks = drawing();
  as_it_looks.document = std::move(document);
  as_it_looks.page = page;
  as_it_looks.layer = {};
  as_it_looks.view.reset();
  as_it_looks.extras = {};
  as_it_looks.names = {};
  show(std::move(as_it_looks), {}, name);
}

void FileActions::adopt(Drawing drawing, const QString& name) {
  show(std::move(drawing), {}, name);
  studio_.set_modified(true);
}

void FileActions::show(Drawing drawing, const QString& path, const QString& name) {
  const LayerId layer = drawing.layer;
  // The name is set before open() emits its signals, so that slots already get the new name.
  path_ = path;
  name_ = name;
  has_page_of_file_ = false;
  seen_on_disk_ = changed_at(path);
  extras_ = drawing.extras;
  names_ = drawing.names;
  is_showing_ = true;
  studio_.open(std::move(drawing.document), drawing.page, drawing.materials, drawing.color);
  is_showing_ = false;
  if (looks_.show) looks_.show(drawing);
  const Layer* in_use = studio_.session().document().layer(layer);
  if (in_use && in_use->visible && !in_use->locked) {
    studio_.apply(LayerEvent{LayerEvent::Do::kUse, layer, {}});
  }
  studio_.set_modified(false);
  if (autosave_) autosave_->begin(display_name(), path_);
  Q_EMIT path_changed(path_);
  Q_EMIT drawing_changed();
}

/// Handles a drawing without a file that other code opened, such as an example.
void FileActions::receive_opened() {
  if (is_showing_) return;
  extras_ = {};
  names_ = {};
  name_.clear();
  has_page_of_file_ = false;
  seen_on_disk_ = {};
  set_path({});
  if (autosave_) autosave_->begin(display_name(), path_);
  Q_EMIT drawing_changed();
}

bool FileActions::import(const QString& given) {
  const QString path = QFileInfo(given).absoluteFilePath();
  Result<Imported> opened = read(path);
  if (!opened) {
    dialogs_->show_error(window_, tr("“%1” cannot be imported").arg(QFileInfo(path).fileName()),
                         error_words(opened.error()), text_of(opened.error()));
    return false;
  }
  Settings::the().set(files_keys::kLastFolder, QFileInfo(path).path());
  if (!add_drawing(studio_, path, opened->drawing, {}, UsedNames::kReported, names_,
                   opened->report)) {
    return false;
  }
  report_added(QFileInfo(path).fileName(), opened->report);
  return true;
}

void FileActions::ask_import() {
  const QStringList paths =
      dialogs_->open_names(window_, tr("Import strokes"), last_folder(), open_filters());
  for (const QString& path : paths) import(path);
}

void FileActions::take_dropped(const QStringList& paths) {
  for (const QString& path : paths) {
    if (is_picture_path(path)) {
      pictures_->add_file(path);
    } else if (is_pristine()) {
      open(path);
    } else {
      import(path);
    }
  }
}

bool FileActions::eventFilter(QObject* object, QEvent* event) {
  if (object == window_ && event->type() == QEvent::DragEnter) {
    auto* drag = static_cast<QDragEnterEvent*>(event);
    const QMimeData* data = drag->mimeData();
    if (!local_files(data).isEmpty() || data->hasImage()) drag->acceptProposedAction();
    return true;
  }
  if (object == window_ && event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    const QStringList paths = local_files(drop->mimeData());
    const auto image = qvariant_cast<QImage>(drop->mimeData()->imageData());
    if (paths.isEmpty() && image.isNull()) return false;
    drop->acceptProposedAction();
    // Queued, because the program from which the user drags waits for the answer, and a dialog may
    // open.
    QMetaObject::invokeMethod(
        this,
        [this, paths, image] {
          take_dropped(paths);
          if (paths.isEmpty()) pictures_->add_image(tr("Picture"), image);
        },
        Qt::QueuedConnection);
    return true;
  }
  return QObject::eventFilter(object, event);
}

// --- Saving

bool FileActions::save() {
  if (path_.isEmpty()) return save_as();
  const QDateTime now = changed_at(path_);
  if (seen_on_disk_.isValid() && now.isValid() && now != seen_on_disk_ && saves_in_work_ == 0) {
    switch (dialogs_->ask_overwrite(window_, display_name())) {
      case FileDialogs::Overwrite::kCancel:
        return false;
      case FileDialogs::Overwrite::kSaveAs:
        return save_as();
      case FileDialogs::Overwrite::kReplace:
        break;
    }
  }
  return begin_save(path_);
}

bool FileActions::save_as() {
  const QString suggested =
      path_.isEmpty() ? QDir(folder()).filePath(display_name() + QStringLiteral(".felt")) : path_;
  const QString chosen =
      dialogs_->name_to_write(window_, tr("Save the drawing"), suggested, FileFormat::kFelt);
  return !chosen.isEmpty() && begin_save(chosen);
}

bool FileActions::begin_save(const QString& path) {
  auto copy = std::make_shared<Drawing>(drawing());
  ++saves_in_work_;
  worker_.start([this, path, mark = studio_.change_mark(), copy]() mutable -> FileWorker::Answer {
    Result<void> done = write_drawing(path, *copy);
    copy.reset();
    return [this, path, mark, done] { end_save(path, mark, done); };
  });
  return true;
}

void FileActions::end_save(const QString& path, const ChangeMark& mark, const Result<void>& done) {
  --saves_in_work_;
  last_save_failed_ = !done;
  if (!done) {
    dialogs_->show_save_error(window_, tr("“%1” was not saved").arg(QFileInfo(path).fileName()),
                              tr("%1\nYour drawing is still open: save it to another place.")
                                  .arg(error_words(done.error())),
                              text_of(done.error()), [this] { save_as(); });
    Q_EMIT saved(false);
    return;
  }
  seen_on_disk_ = changed_at(path);
  folder_ = QFileInfo(path).path();
  name_.clear();
  set_path(path);
  studio_.set_saved(mark);
  if (autosave_) autosave_->rename(display_name(), path_);
  if (!studio_.is_modified()) forget_rescued();
  remember(path);
  Q_EMIT saved(true);
}

/// If there are unsaved changes, asks whether to save them, and waits until they are saved. Returns
/// true if another drawing may replace this one. If a gesture ended while the file was being
/// written, saves once more.
bool FileActions::may_replace() {
  worker_.wait();
  studio_.finish_gesture();  // a line in progress is a change, too
  if (!studio_.is_modified()) return true;
  switch (dialogs_->ask_unsaved(window_, display_name())) {
    case FileDialogs::Unsaved::kDiscard:
      return true;
    case FileDialogs::Unsaved::kCancel:
      return false;
    case FileDialogs::Unsaved::kSave:
      break;
  }
  if (!save()) return false;
  worker_.wait();
  // The pen may have drawn while the file was being written; the file does not contain that
  // gesture.
  studio_.finish_gesture();
  if (!last_save_failed_ && studio_.is_modified()) {
    begin_save(path_);
    worker_.wait();
  }
  return !last_save_failed_ && !studio_.is_modified();
}

bool FileActions::may_close() {
  if (!may_replace()) return false;
  if (autosave_) autosave_->discard();
  forget_rescued();
  return true;
}

void FileActions::set_path(const QString& path) {
  if (path == path_) return;
  path_ = path;
  Q_EMIT path_changed(path_);
}

// --- Folders and recent files

QString FileActions::last_folder() const {
  const QString folder = Settings::the().text(files_keys::kLastFolder);
  if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void FileActions::remember(const QString& path) {
  Settings& settings = Settings::the();
  settings.set(files_keys::kLastFolder, QFileInfo(path).path());
  QStringList recent = settings.value(files_keys::kRecent).toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  recent = recent.mid(0, files_keys::kRecentCount);
  settings.set(files_keys::kRecent, recent);
  fill_recent_menu();
  worker_.start([path, recent, shown = drawing()]() -> FileWorker::Answer {
    write_recent_picture(path, shown);
    keep_recent_pictures(recent);
    return {};
  });
}

void FileActions::fill_recent_menu() {
  Settings& settings = Settings::the();
  QStringList recent = settings.value(files_keys::kRecent).toStringList();
  recent.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
  settings.set(files_keys::kRecent, recent);
  recent_menu_->clear();
  int number = 0;
  for (const QString& path : std::as_const(recent)) {
    // Ampersands are doubled, because a menu would interpret single ones.
    QString name = QFileInfo(path).fileName();
    name.replace(QLatin1Char('&'), QStringLiteral("&&"));
    const QString mark = ++number < 10 ? QStringLiteral("&%1  ").arg(number) : QString();
    QAction* action = recent_menu_->addAction(mark + name);
    action->setStatusTip(path);
    action->setIcon(recent_picture(path));
    // Queued, because opening a file fills this menu again and deletes the action.
    connect(
        action, &QAction::triggered, this, [this, path] { open(path); }, Qt::QueuedConnection);
  }
  if (recent.isEmpty()) {
    recent_menu_->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  recent_menu_->addSeparator();
  const auto clear = [this] {
    Settings::the().set(files_keys::kRecent, QStringList());
    keep_recent_pictures({});
    fill_recent_menu();
  };
  connect(recent_menu_->addAction(tr("&Clear this list")), &QAction::triggered, this, clear,
          Qt::QueuedConnection);
}

}  // namespace felt::desktop
