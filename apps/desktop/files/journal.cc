#include "desktop/files/journal.h"

#include <QDir>
#include <QStandardPaths>
#include <utility>

#include "felt/store/folder_lock.h"

namespace felt::desktop {
namespace {

std::unique_ptr<Saver> make_saver(const QStringList& roots,
                                  std::function<void(const SaverStatus&)> on_status) {
  SaverOptions options;
  for (const QString& root : roots) options.roots.push_back(root.toStdString());
  options.on_status = std::move(on_status);
  return std::make_unique<Saver>(std::move(options));
}

}  // namespace

QStringList recovery_roots() {
  if (QStandardPaths::isTestModeEnabled()) {
    return {QDir::homePath() + QStringLiteral("/.qttest/state/feltline/working")};
  }
  QStringList roots;
  for (const std::string& root : working_roots()) roots.push_back(QString::fromStdString(root));
  return roots;
}

Journal::Journal(Studio& studio, std::function<Drawing()> current, const QStringList& roots,
                 QObject* parent)
    : QObject(parent),
      studio_(&studio),
      current_(std::move(current)),
      saver_(make_saver(roots,
                        [this](const SaverStatus& status) {
                          // From the saver's thread, which ends before this does.
                          QMetaObject::invokeMethod(
                              this, [this, status] { Q_EMIT status_changed(status); },
                              Qt::QueuedConnection);
                        })),
      feed_(*saver_) {
  studio_->listen({[this](const Event& event) { feed_.hear(studio_->session(), event); },
                   [this](const Edit& edit) { feed_.hear(studio_->session(), edit); },
                   [this](Servo* servo, std::int64_t offset_ns) {
                     if (servo) {
                       saver_->attach(servo->for_saver(), offset_ns);
                     } else {
                       saver_->detach();
                     }
                   }});
  connect(&studio, &Studio::modified_changed, this, [this](bool now) { saver_->modified(now); });
  connect(&studio, &Studio::page_changed, this, [this] { saver_->head(current_()); });
  // A medium of one's own may be what is taken in hand.
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    if (id.endsWith(QLatin1String(".material"))) saver_->head(current_());
  });
}

Journal::~Journal() {
  if (studio_) studio_->listen({});
  if (is_clean_) saver_->forget();
  saver_.reset();
}

void Journal::begin(const QString& name, const QString& path) {
  is_clean_ = false;
  feed_.begin(studio_->session(), current_(), name.toStdString(), path.toStdString(),
              studio_->is_modified());
}

void Journal::saved(const QString& name, const QString& path) {
  // What was drawn meanwhile is not in the file: the studio says whether it counts as modified.
  saver_->rename(name.toStdString(), path.toStdString());
}

QString Journal::folder() const {
  return QString::fromStdString(saver_->status().folder);
}

}  // namespace felt::desktop
