#include "desktop/files/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <utility>

#include "desktop/files/journal_writer.h"
#include "felt/base/read_file.h"
#include "felt/io/event_reader.h"
#include "felt/session/session.h"
#include "felt/store/byte_stream.h"
#include "felt/store/edit_blob.h"
#include "felt/store/journal_log.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kMaxLogBytes = std::size_t{1} << 30;

bool is(const LogRecord& record, JournalRecord type) {
  return record.type == static_cast<std::uint8_t>(type);
}

/// "" where there is none: an empty log.
std::string bytes_of(const QString& path) {
  return read_file(path.toStdString(), kMaxLogBytes).value_or(std::string());
}

/// Numbers of generations that have a base, the highest first.
std::vector<int> generations(const QDir& folder) {
  std::vector<int> numbers;
  const QStringList names = folder.entryList({QStringLiteral("base-*.felt")}, QDir::Files);
  for (const QString& name : names) {
    bool ok = false;
    const int number = name.mid(5, name.size() - 10).toInt(&ok);
    if (ok) numbers.push_back(number);
  }
  std::sort(numbers.rbegin(), numbers.rend());
  return numbers;
}

/// Carries the edits of a log out; returns the serial of the last one. Stops at one that does not
/// fit: what follows would not either.
std::uint64_t replay_log(std::string_view log, Recovered& out) {
  std::uint64_t serial = 0;
  for (const LogRecord& record : read_log(log)) {
    if (is(record, JournalRecord::kSaved)) out.has_changes = false;
    if (is(record, JournalRecord::kStart)) serial = ByteReader(record.bytes).u64();
    if (is(record, JournalRecord::kHead)) {
      if (const Result<Drawing> head = parse_felt(record.bytes)) {
        out.has_changes = out.has_changes || out.drawing.page != head->page;
        out.drawing.page = head->page;
        out.drawing.material = head->material;
        out.drawing.color = head->color;
      }
    }
    if (!is(record, JournalRecord::kEdit) || record.bytes.size() < 8) continue;
    const Result<Edit> edit = read_edit_blob(record.bytes.substr(8), out.drawing.document);
    if (!edit || !out.drawing.document.apply(*edit)) break;
    serial = ByteReader(record.bytes).u64();
    out.has_changes = true;
  }
  if (!out.drawing.document.layer(out.drawing.layer)) out.drawing.layer = {};
  return serial;
}

/// Draws the gesture that was in work from its samples.
void replay_tail(std::string_view tail, std::uint64_t serial, Recovered& out) {
  const std::vector<LogRecord> records = read_log(tail);
  if (records.empty() || !is(records.front(), JournalRecord::kTail) ||
      ByteReader(records.front().bytes).u64() != serial) {
    return;
  }
  std::string script;
  for (const LogRecord& record : records) {
    if (is(record, JournalRecord::kEvents)) script += record.bytes;
  }
  SessionOptions options;
  options.document = out.drawing.document;
  Session session(make_tools(), std::move(options));
  ScriptSink sink;
  sink.event = [&session](const Event& event) { return session.apply(event); };
  // An error ends it there, with the ink so far.
  static_cast<void>(read_script("tail", read_text(script), sink));
  static_cast<void>(session.finish());
  if (session.edit_count() == 0) return;
  out.drawing.document = session.document();
  out.has_changes = true;
}

}  // namespace

void AbandonedFolder::remove() {
  lock->unlock();
  QDir(path).removeRecursively();
}

std::vector<AbandonedFolder> find_abandoned(const QString& root) {
  std::vector<AbandonedFolder> found;
  const QFileInfoList folders =
      QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Time);
  for (const QFileInfo& info : folders) {
    auto lock = std::make_unique<QLockFile>(info.filePath() + QStringLiteral("/lock"));
    lock->setStaleLockTime(0);
    // Who lives holds a lock of the system, too. A process that has the number of a dead one now,
    // this one perhaps, does not.
    if (!lock->tryLock(0) && !(lock->removeStaleLockFile() && lock->tryLock(0))) continue;
    found.push_back({info.filePath(), std::move(lock)});
  }
  return found;
}

Result<Recovered> recover(const QString& folder) {
  const QDir dir(folder);
  Result<Drawing> base =
      fail(ErrorCode::kNotFound, folder.toStdString() + ": holds no drawing to begin with");
  Recovered out;
  QString log;
  for (const int number : generations(dir)) {
    base = read_felt(dir.filePath(QStringLiteral("base-%1.felt").arg(number)).toStdString());
    log = dir.filePath(QStringLiteral("edits-%1").arg(number));
    if (base) break;
  }
  if (!base) return tl::unexpected(base.error());
  out.drawing = *std::move(base);
  QFile about(dir.filePath(QStringLiteral("about.json")));
  if (about.open(QIODevice::ReadOnly)) {
    const QJsonObject json = QJsonDocument::fromJson(about.read(1 << 16)).object();
    out.name = json.value(QStringLiteral("name")).toString();
    out.path = json.value(QStringLiteral("path")).toString();
  }
  const QString tail = dir.filePath(QStringLiteral("tail"));
  const std::uint64_t serial = replay_log(bytes_of(log), out);
  replay_tail(bytes_of(tail), serial, out);
  out.when = QFileInfo(log).lastModified();
  if (QFileInfo(tail).size() > 0) out.when = std::max(out.when, QFileInfo(tail).lastModified());
  return out;
}

}  // namespace felt::desktop
