#include "desktop/files/journal.h"

#include <QDir>
#include <QStandardPaths>
#include <algorithm>
#include <utility>
#include <variant>

#include "felt/autosave/folder_lock.h"
#include "felt/material/material_file.h"

namespace felt::desktop {
namespace {

// A slider that is dragged changes figures ten times a second; each time the whole drawing is
// looked through for what it uses.
constexpr int kHeadSoonMs = 500;

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
                   [this](const Edit& edit) {
                     feed_.hear(studio_->session(), edit);
                     if (lacks_medium_of(edit)) keep_head_soon();
                   },
                   [this](Servo* servo, std::int64_t offset_ns) {
                     if (servo) {
                       saver_->attach(servo->for_saver(), offset_ns);
                     } else {
                       saver_->detach();
                     }
                   }});
  connect(&studio, &Studio::modified_changed, this, [this](bool now) { saver_->modified(now); });
  connect(&studio, &Studio::page_changed, this, &Journal::keep_head);
  // A medium of one's own may be what is taken in hand.
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    if (id.endsWith(QLatin1String(".material"))) keep_head();
  });
  head_soon_.setSingleShot(true);
  head_soon_.setInterval(kHeadSoonMs);
  connect(&head_soon_, &QTimer::timeout, this, &Journal::keep_head);
  connect(&studio, &Studio::materials_changed, this, &Journal::keep_head_soon);
}

Journal::~Journal() {
  if (studio_) studio_->listen({});
  if (is_clean_) saver_->forget();
  saver_.reset();
}

void Journal::begin(const QString& name, const QString& path) {
  is_clean_ = false;
  head_soon_.stop();
  Drawing drawing = current_();
  note_kept(drawing);
  feed_.begin(studio_->session(), std::move(drawing), name.toStdString(), path.toStdString(),
              studio_->is_modified());
}

void Journal::saved(const QString& name, const QString& path) {
  // What was drawn meanwhile is not in the file: the studio says whether it counts as modified.
  saver_->rename(name.toStdString(), path.toStdString());
}

void Journal::flush() {
  if (head_soon_.isActive()) keep_head();
  saver_->flush();
}

void Journal::keep_head() {
  head_soon_.stop();
  if (!studio_) return;
  Drawing head = current_();
  note_kept(head);
  saver_->head(std::move(head));
}

/// The first one counts: while figures change all the time, they are kept all the same.
void Journal::keep_head_soon() {
  if (!head_soon_.isActive()) head_soon_.start();
}

void Journal::note_kept(const Drawing& head) {
  kept_media_.clear();
  for (const std::string& text : head.materials) {
    const Result<AnyMaterial> material = read_material(text);
    if (material && std::holds_alternative<Medium>(*material)) {
      kept_media_.insert(id_of(*material));
    }
  }
}

/// Strokes came, by a paste or an undo, of a medium that Feltline does not bring and whose text the
/// saver does not have.
bool Journal::lacks_medium_of(const Edit& edit) const {
  const Materials& known = studio_->session().materials();
  const Materials& built_in = Materials::built_in();
  return std::any_of(edit.changes.begin(), edit.changes.end(), [&](const StrokeChange& change) {
    if (!change.after || kept_media_.contains(change.after->material())) return false;
    const Medium* medium = known.find_medium(change.after->material());
    const Medium* ours = built_in.find_medium(change.after->material());
    return medium && !(ours && *ours == *medium);
  });
}

QString Journal::folder() const {
  return QString::fromStdString(saver_->status().folder);
}

}  // namespace felt::desktop
