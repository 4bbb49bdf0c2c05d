#include "desktop/files/journal.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <utility>

#include "felt/stroke/color_text.h"

namespace felt::desktop {
namespace {

constexpr std::size_t kAirSamples = 64;               // enough for velocity and contact to settle
constexpr std::int64_t kNothingCameNs = 200'000'000;  // in the air since

PenSample sample_of(const Event& event, const PenEvent& pen) {
  PenSample sample;
  sample.time_ns = event.time_ns;
  sample.position = pen.position;
  sample.pressure = pen.pressure;
  sample.buttons = pen.buttons;
  return sample;
}

/// A gesture of these begins with what is selected, which the journal does not keep.
bool depends_on_selection(std::string_view tool) {
  return tool == "transform";
}

}  // namespace

QString recovery_root() {
  // QStandardPaths knows this folder from Qt 6.7 on.
  QString state = qEnvironmentVariable("XDG_STATE_HOME");
  if (QStandardPaths::isTestModeEnabled()) {
    state = QDir::homePath() + QStringLiteral("/.qttest/state");
  } else if (state.isEmpty() || !QDir::isAbsolutePath(state)) {
    state = QDir::homePath() + QStringLiteral("/.local/state");
  }
  return state + QStringLiteral("/feltline/recovery");
}

Journal::Journal(Studio& studio, std::function<Drawing()> current, const QString& root,
                 QObject* parent)
    : QObject(parent), studio_(&studio), current_(std::move(current)) {
  static int count = 0;
  // Of a process that died, and whose number is ours now, there may be one of the same name: in a
  // container every start has the same number.
  QDir().mkpath(root);
  do {
    folder_ = root + QStringLiteral("/%1-%2").arg(QCoreApplication::applicationPid()).arg(++count);
  } while (!QDir().mkdir(folder_) && QFileInfo::exists(folder_));
  QFile::setPermissions(folder_, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  lock_ = std::make_unique<QLockFile>(folder_ + QStringLiteral("/lock"));
  lock_->setStaleLockTime(0);
  lock_->tryLock(0);
  writer_ = std::make_unique<JournalWriter>(folder_.toStdString(), [this](const std::string& why) {
    const QString text = QString::fromStdString(why);
    QMetaObject::invokeMethod(this, [this, text] {
      if (text.isEmpty()) {
        wants_base_ = true;
      } else {
        Q_EMIT failed(text);
      }
    });
  });
  studio_->listen(
      {[this](const Event& event) { hear(event); }, [this](const Edit& edit) { hear(edit); }});
  is_modified_ = studio.is_modified();
  connect(&studio, &Studio::modified_changed, this, [this](bool now) { is_modified_ = now; });
  connect(&studio, &Studio::page_changed, this, &Journal::tell_head);
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    if (id.startsWith(QStringLiteral("sheet."))) tell_head();
  });
}

Journal::~Journal() {
  if (studio_) studio_->listen({});
  writer_.reset();
  const bool is_over = is_clean_ || !is_modified_;
  lock_->unlock();
  if (is_over) QDir(folder_).removeRecursively();
}

void Journal::begin(const QString& name, const QString& path) {
  is_clean_ = false;
  has_tail_ = was_down_ = wants_base_ = false;
  air_.clear();
  write_about(name, path);
  writer_->begin(std::make_shared<const Drawing>(current_()));
}

void Journal::saved(const QString& name, const QString& path) {
  write_about(name, path);
  if (!studio_->is_modified()) writer_->saved();
}

void Journal::write_about(const QString& name, const QString& path) {
  QFile file(folder_ + QStringLiteral("/about.json"));
  if (!file.open(QIODevice::WriteOnly)) return;  // the writer will say it
  const QJsonObject about{{QStringLiteral("name"), name}, {QStringLiteral("path"), path}};
  file.write(QJsonDocument(about).toJson());
}

void Journal::tell_head() {
  Drawing head;
  const Session& session = studio_->session();
  head.page = studio_->page();
  head.material = session.sheet().material().id;
  head.color = session.sheet().color();
  writer_->head(std::move(head));
}

void Journal::hear(const Event& event) {
  const auto* pen = std::get_if<PenEvent>(&event.what);
  if (!pen) {
    if (has_tail_) writer_->event(event);
    return;
  }
  const bool is_down = in_contact(sample_of(event, *pen));
  if (is_down && !was_down_ && !has_tail_) begin_tail();
  was_down_ = is_down;
  if (is_down) last_contact_ns_ = event.time_ns;
  if (has_tail_) {
    writer_->event(event);
    if (event.time_ns - last_contact_ns_ > kNothingCameNs &&
        !studio_->session().gesture_in_work()) {
      has_tail_ = false;
      writer_->end_tail();
    }
    return;
  }
  air_.push_back(event);
  if (air_.size() > kAirSamples) air_.pop_front();
  if (wants_base_ && !is_down && !studio_->session().gesture_in_work()) renew();
}

void Journal::hear(const Edit& edit) {
  writer_->edit(edit);
  has_tail_ = false;
  air_.clear();
}

/// A new base instead of a long log. Later: the session is within a call now.
void Journal::renew() {
  wants_base_ = false;
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (studio_->session().gesture_in_work()) {
          wants_base_ = true;
        } else {
          has_tail_ = false;
          writer_->renew(std::make_shared<const Drawing>(current_()));
        }
      },
      Qt::QueuedConnection);
}

/// What the ink of this gesture depends on besides the document, as events.
void Journal::begin_tail() {
  const Session& session = studio_->session();
  const ToolInfo& tool = session.tool().info();
  if (depends_on_selection(tool.id)) return;
  const std::int64_t time_ns = air_.empty() ? 0 : air_.front().time_ns;
  std::vector<Event> events;
  events.push_back({time_ns, UseDevice{studio_->device().device().capabilities()}});
  events.push_back({time_ns, SelectTool{std::string(tool.id)}});
  for (const OptionSpec& row : tool.options) {
    const std::string id = std::string(tool.id) + "." + std::string(row.id);
    if (const Result<OptionValue> value = session.option(id)) {
      events.push_back({time_ns, SetOption{id, *value}});
    }
  }
  events.push_back({time_ns, SetOption{"sheet.color", color_to_text(session.sheet().color())}});
  events.push_back({time_ns, LayerEvent{LayerEvent::Do::kUse, session.layer(), {}}});
  events.insert(events.end(), air_.begin(), air_.end());
  air_.clear();
  has_tail_ = true;
  writer_->begin_tail(std::move(events));
}

}  // namespace felt::desktop
