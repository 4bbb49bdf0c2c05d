#include "tests/desktop/recording_check.h"

#include <QFile>
#include <QProcess>
#include <algorithm>
#include <cmath>

#include "felt/io/events/event_reader.h"

namespace felt::desktop {
namespace {

constexpr double kSameMm = 1e-6;
constexpr int kReplayMs = 60'000;

}  // namespace

Result<std::vector<PenEvent>> poses_of(const QString& recording) {
  QFile file(recording);
  if (!file.open(QIODevice::ReadOnly)) {
    return fail(ErrorCode::kNotFound, (recording + ": " + file.errorString()).toStdString());
  }
  std::string text = file.readAll().toStdString();
  text.resize(text.rfind('\n') + 1);  // 0 if the text has no line end
  const Result<std::vector<Event>> events = read_events(recording.toStdString(), read_text(text));
  if (!events) return tl::unexpected(events.error());
  std::vector<PenEvent> poses;
  for (const Event& event : *events) {
    if (const auto* pen = std::get_if<PenEvent>(&event.what)) poses.push_back(*pen);
  }
  return poses;
}

std::size_t count_places(std::span<const PenEvent> poses, std::span<const Point> places) {
  auto at = poses.begin();
  std::size_t count = 0;
  for (const Point& place : places) {
    at = std::find_if(at, poses.end(), [&place](const PenEvent& pose) {
      return std::hypot(pose.position.x - place.x, pose.position.y - place.y) < kSameMm;
    });
    if (at == poses.end()) break;
    ++count;
  }
  return count;
}

Result<std::string> replayed(const QString& feltline, const QString& recording) {
  QProcess process;
  process.start(feltline, {QStringLiteral("replay"), recording, QStringLiteral("--as-recorded"),
                           QStringLiteral("-o"), QStringLiteral("-"), QStringLiteral("--to"),
                           QStringLiteral("ndjson")});
  if (!process.waitForFinished(kReplayMs) || process.exitCode() != 0) {
    return fail(ErrorCode::kInvalidData, "feltline replay: " + process.errorString().toStdString() +
                                             ": " + process.readAllStandardError().toStdString());
  }
  return process.readAllStandardOutput().toStdString();
}

}  // namespace felt::desktop
