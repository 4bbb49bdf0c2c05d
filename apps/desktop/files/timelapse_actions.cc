#include "desktop/files/timelapse_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QProgressDialog>
#include <utility>

#include "desktop/engine/recording_file.h"
#include "desktop/engine/text_of.h"
#include "desktop/files/error_words.h"
#include "desktop/files/file_actions.h"
#include "desktop/files/timelapse_dialog.h"
#include "felt/store/felt_recording.h"

namespace felt::desktop {
namespace {

constexpr int kPollMs = 100;
constexpr int kProgressSteps = 1000;

/// Returns a sentence about the notices of a recording, or an empty text if there are none.
QString changed_in(const ImportReport& report) {
  if (report.empty()) return {};
  QStringList texts;
  for (const ImportNotice& notice : report.notices()) texts += text_of(notice_text(notice));
  return TimelapseActions::tr("Changed in the recording: %1.")
      .arg(texts.join(QStringLiteral("; ")));
}

}  // namespace

TimelapseActions::TimelapseActions(FileActions& files, Studio& studio, Actions& actions,
                                   QWidget* window)
    : QObject(window), files_(files), studio_(studio), window_(window) {
  action_ =
      actions.add(QStringLiteral("file.timelapse"), tr("Export &timelapse…"), {},
                  tr("Make a film of how a drawing was made, from a recording"), [this] { ask(); });
  poll_.setInterval(kPollMs);
  connect(&poll_, &QTimer::timeout, this, [this] {
    const std::int64_t all = progress_->all;
    if (!shown_ || all <= 0) return;
    shown_->setRange(0, kProgressSteps);
    shown_->setValue(static_cast<int>(kProgressSteps * progress_->done / all));
  });
}

TimelapseActions::~TimelapseActions() {
  cancel();
}

TimelapseRequest TimelapseActions::with_session(TimelapseRequest request) const {
  RecordingFile* recording = recording_of(studio_);
  recording->flush();
  request.recording = recording->path();
  request.start.document = recording->start();
  request.start.page = studio_.page();
  request.start.has_page = true;
  request.materials = studio_.materials();
  return request;
}

TimelapseRequest TimelapseActions::with_drawing(TimelapseRequest request) const {
  request.recording = files_.path().isEmpty() ? files_.display_name() : files_.path();
  request.drawing = files_.drawing();
  request.materials = studio_.materials();
  return request;
}

void TimelapseActions::ask() {
  QList<RecordingSource> sources;
  if (recording_of(studio_)) sources.push_back(RecordingSource::kSession);
  const auto recordings = recordings_of(files_.drawing());
  if (recordings && !recordings->empty()) sources.push_back(RecordingSource::kDrawing);
  const auto choose = [this] {
    return files_.dialogs().open_name(window_, tr("Choose a recording"), files_.folder(),
                                      tr("Recordings (*.ndjson *.felt)"));
  };
  TimelapseDialog dialog(sources, choose, QStringLiteral("ffmpeg"), window_);
  if (dialog.exec() != QDialog::Accepted || is_busy()) return;
  TimelapseRequest request = dialog.request();
  const QString path = ask_name(request.format);
  if (path.isEmpty()) return;
  switch (dialog.source()) {
    case RecordingSource::kSession:
      request = with_session(std::move(request));
      break;
    case RecordingSource::kDrawing:
      request = with_drawing(std::move(request));
      break;
    case RecordingSource::kFile:
      request.materials = studio_.materials();
      break;
  }
  make(path, request);
}

/// Asks for the name of a film. Asks again if adding the extension gives the name of an existing
/// file, about which the dialog did not ask.
QString TimelapseActions::ask_name(TimelapseFormat format) const {
  const QString base = QFileInfo(files_.display_name()).completeBaseName();
  QString suggested = QDir(files_.folder()).filePath(base + suffix_of(format));
  for (;;) {
    const QString chosen = files_.dialogs().save_name(window_, tr("Export timelapse"), suggested,
                                                      filter_of(format), suffix_of(format).mid(1));
    if (chosen.isEmpty()) return {};
    const QString name = QFileInfo(chosen).absoluteFilePath();
    if (timelapse_format_of(name.toStdString()) == format) return name;
    if (!QFileInfo::exists(name + suffix_of(format))) return name + suffix_of(format);
    suggested = name + suffix_of(format);
  }
}

void TimelapseActions::make(const QString& path, const TimelapseRequest& request) {
  run(path, [path, request](TimelapseProgress& progress) {
    return make_timelapse(path, request, progress);
  });
}

void TimelapseActions::run(const QString& path,
                           std::function<Result<void>(TimelapseProgress&)> work) {
  action_->setEnabled(false);
  progress_ = std::make_shared<TimelapseProgress>();
  show_progress(QFileInfo(path).fileName());
  worker_.start([this, path, work = std::move(work), progress = progress_]() -> FileWorker::Answer {
    const Result<void> done = work(*progress);
    return [this, path, done] { end(path, done); };
  });
}

void TimelapseActions::show_progress(const QString& name) {
  shown_ = new QProgressDialog(tr("Making the film “%1”…").arg(name), tr("Cancel"), 0, 0, window_);
  shown_->setWindowTitle(tr("Export"));
  shown_->setWindowModality(Qt::NonModal);
  shown_->setAttribute(Qt::WA_DeleteOnClose, false);
  shown_->setAttribute(Qt::WA_ShowWithoutActivating);
  shown_->setAutoClose(false);
  shown_->setAutoReset(false);
  connect(shown_, &QProgressDialog::canceled, this, [this] { cancel(); });
  shown_->show();
  poll_.start();
}

void TimelapseActions::end(const QString& path, const Result<void>& done) {
  poll_.stop();
  if (shown_) shown_->deleteLater();
  action_->setEnabled(true);
  if (!done && !progress_->is_cancelled) {
    // The library's sentence says what is missing and what to do.
    const QString why = text_of(done.error());
    const bool is_damaged = done.error().code == ErrorCode::kIo;
    files_.dialogs().show_error(
        window_, tr("“%1” was not exported").arg(QFileInfo(path).fileName()),
        is_damaged ? error_words(done.error()) : why, is_damaged ? why : QString());
  }
  Q_EMIT made(path, done.has_value(), changed_in(progress_->report));
}

}  // namespace felt::desktop
