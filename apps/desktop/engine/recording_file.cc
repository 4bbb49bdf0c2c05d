#include "desktop/engine/recording_file.h"

#include <QFileInfo>
#include <QVariant>
#include <utility>

#include "felt/io/events/event_writer.h"

namespace felt::desktop {
namespace {

constexpr int kLongestMs = 50;
constexpr auto kRecordingProperty = "recording";  // of a studio that is recorded

/// Returns the path with a number: "a/b-2.ndjson" for "a/b.ndjson".
QString numbered(const QString& path, int number) {
  if (number < 2) return path;
  const QFileInfo info(path);
  const QString suffix = info.suffix().isEmpty() ? QString() : QLatin1Char('.') + info.suffix();
  return info.path() + QLatin1Char('/') + info.completeBaseName() + QLatin1Char('-') +
         QString::number(number) + suffix;
}

}  // namespace

RecordingFile::RecordingFile(QString path)
    : path_(std::move(path)), recorder_([this](std::span<const Event> events) { write(events); }) {
  timer_.setSingleShot(true);
  timer_.setInterval(kLongestMs);
  connect(&timer_, &QTimer::timeout, this, &RecordingFile::flush);
}

RecordingFile::~RecordingFile() {
  flush();
}

void RecordingFile::begin(const Document& start) {
  flush();
  start_ = start;
  file_.close();
  error_.clear();
  file_.setFileName(numbered(path_, ++session_));
  if (!file_.open(QIODevice::WriteOnly | QIODevice::Truncate)) fail(file_.errorString());
  recorder_ = Recorder([this](std::span<const Event> events) { write(events); });
}

void RecordingFile::add(const Event& event) {
  recorder_(event);
  if (!timer_.isActive()) timer_.start();
}

void RecordingFile::flush() {
  timer_.stop();
  recorder_.flush();
}

void RecordingFile::write(std::span<const Event> events) {
  if (!file_.isOpen()) return;
  text_.clear();
  for (const Event& event : events) append_event_line(text_, event);
  const auto size = static_cast<qint64>(text_.size());
  if (file_.write(text_.data(), size) != size || !file_.flush()) {
    fail(file_.errorString());
    file_.close();
  }
}

void RecordingFile::fail(const QString& why) {
  error_ = file_.fileName() + QStringLiteral(": ") + why;
  Q_EMIT failed(error_);
}

std::unique_ptr<RecordingFile> record_into(const QString& path, StudioOptions& options) {
  if (path.isEmpty()) return nullptr;
  auto recording = std::make_unique<RecordingFile>(path);
  options.connect_early = [file = recording.get()](Studio& studio) {
    studio.setProperty(kRecordingProperty, QVariant::fromValue<QObject*>(file));
    QObject::connect(&studio, &Studio::session_began, file, &RecordingFile::begin);
    QObject::connect(&studio, &Studio::event_applied, file, &RecordingFile::add);
  };
  return recording;
}

RecordingFile* recording_of(const Studio& studio) {
  return qobject_cast<RecordingFile*>(studio.property(kRecordingProperty).value<QObject*>());
}

}  // namespace felt::desktop
