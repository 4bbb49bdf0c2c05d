#pragma once

#include <QFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <span>
#include <string>

#include "desktop/engine/studio.h"
#include "felt/session/recorder.h"

namespace felt::desktop {

/// Writes everything that a studio's session receives into a file, as it happens. The file is for
/// `feltline replay --as-recorded`:
///
///   const auto recording = record_into(path, options);
///   Studio studio(options);
///
/// The first session goes to "path.ndjson", the next to "path-2.ndjson" and so on. To replay a
/// session that begins with a drawing, pass that drawing (`replay --on`). While Qt's event loop
/// runs, an event is written at most 50 ms after it was received. Use this class in Qt's main
/// thread. The object must outlive the studio.
class RecordingFile : public QObject {
  Q_OBJECT

 public:
  explicit RecordingFile(QString path);
  ~RecordingFile() override;

  /// Begins the recording of a session that begins with this document.
  void begin(const Document& start = {});
  void add(const Event& event);
  /// Writes everything received so far to the file.
  void flush();
  /// Returns why the file cannot be written; empty if no error occurred.
  [[nodiscard]] const QString& error() const noexcept { return error_; }
  /// Returns the path of the current file.
  [[nodiscard]] QString path() const { return file_.fileName(); }
  /// Returns the document with which the session began that is recorded in path().
  [[nodiscard]] const Document& start() const noexcept { return start_; }

 Q_SIGNALS:
  void failed(const QString& why);

 private:
  void write(std::span<const Event> events);
  void fail(const QString& why);

  QString path_;
  QFile file_;
  Recorder recorder_;
  std::string text_;
  QTimer timer_;
  QString error_;
  Document start_;
  int session_ = 0;
};

/// Changes `options` so that a studio that is created with them records its sessions into the
/// returned file. Returns null if `path` is empty.
std::unique_ptr<RecordingFile> record_into(const QString& path, StudioOptions& options);

/// Returns the file into which the sessions of a studio are recorded; null if they are not.
RecordingFile* recording_of(const Studio& studio);

}  // namespace felt::desktop
