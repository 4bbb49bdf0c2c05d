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

/// Writes all that a studio's session receives into a file, as it happens, for
/// `feltline replay --as-recorded`:
///
///   const auto recording = record_into(path, options);
///   Studio studio(options);
///
/// The first session goes to "path.ndjson", the next to "path-2.ndjson" and so on; one that begins
/// with a drawing is played with that (`replay --on`). Nothing waits longer than 50 ms in memory
/// while Qt's loop runs. Qt's main thread; must outlive the studio.
class RecordingFile : public QObject {
  Q_OBJECT

 public:
  explicit RecordingFile(QString path);
  ~RecordingFile() override;

  /// A session begins.
  void begin();
  void add(const Event& event);
  /// What was told so far is in the file then.
  void flush();
  /// Why it cannot be written; empty: it can.
  [[nodiscard]] const QString& error() const noexcept { return error_; }
  /// The file in use.
  [[nodiscard]] QString path() const { return file_.fileName(); }

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
  int session_ = 0;
};

/// Has the studio that is made with these options record itself. Null where the path is empty.
std::unique_ptr<RecordingFile> record_into(const QString& path, StudioOptions& options);

}  // namespace felt::desktop
