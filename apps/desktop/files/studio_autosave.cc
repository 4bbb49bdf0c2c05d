#include "desktop/files/studio_autosave.h"

#include <QDir>
#include <QStandardPaths>
#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "felt/autosave/folder_lock.h"
#include "felt/material/material_file.h"

namespace felt::desktop {
namespace {

// Dragging a slider changes figures ten times a second, and each autosaved change searches the
// whole drawing for the materials that it uses. Therefore changes are collected for kHeadDelayMs.
constexpr int kHeadDelayMs = 500;

}  // namespace

QStringList recovery_roots() {
  if (QStandardPaths::isTestModeEnabled()) {
    return {QDir::homePath() + QStringLiteral("/.qttest/state/feltline/working")};
  }
  QStringList roots;
  for (const std::string& root : autosave_roots()) roots.push_back(QString::fromStdString(root));
  return roots;
}

StudioAutosave::StudioAutosave(Studio& studio, std::function<Drawing()> current,
                               const QStringList& roots, QObject* parent)
    : QObject(parent), studio_(&studio), current_(std::move(current)) {
  AutosaveOptions options;
  for (const QString& root : roots) options.roots.push_back(root.toStdString());
  options.on_status = [this](const AutosaveStatus& status) {
    // Called on the autosave thread, which ends before this object is destroyed.
    QMetaObject::invokeMethod(
        this, [this, status] { Q_EMIT status_changed(status); }, Qt::QueuedConnection);
  };
  autosave_.emplace(std::move(options));
  head_timer_.setSingleShot(true);
  head_timer_.setInterval(kHeadDelayMs);
  connect(&head_timer_, &QTimer::timeout, this, &StudioAutosave::post_head);
  connect_studio(studio);
}

void StudioAutosave::connect_studio(Studio& studio) {
  connect(&studio, &Studio::event_applied, this,
          [this](const Event& event) { autosave_->event_applied(studio_->session(), event); });
  connect(&studio, &Studio::edit_applied, this, [this](const Edit& edit) {
    autosave_->edit_applied(studio_->session(), edit);
    if (lacks_medium_of(edit)) post_head_soon();
  });
  connect(&studio, &Studio::modified_changed, this,
          [this](bool modified) { autosave_->post({.modified = modified}); });
  connect(&studio, &Studio::page_changed, this, &StudioAutosave::post_head);
  connect(&studio, &Studio::materials_changed, this, &StudioAutosave::post_head_soon);
  connect(&studio, &Studio::option_changed, this, [this](const QString& id) {
    // The new medium may be user-defined, and then the autosave needs its text.
    if (id == QLatin1String(kSurfaceOptionId) || id.endsWith(QLatin1String(".medium"))) post_head();
  });
  HapticLoop& loop = studio.loop();
  const auto attach = [this, &loop] {
    autosave_->attach(loop.servo().for_autosave(), loop.start_ns());
  };
  connect(&loop, &HapticLoop::started, this, [this, attach] {
    if (!studio_->is_pen_elsewhere()) attach();
  });
  connect(&loop, &HapticLoop::stopped, this, [this] { autosave_->detach(); });
  // The loop's own samples of a pen that is elsewhere must not become ink.
  connect(&studio, &Studio::elsewhere_changed, this, [this, &loop, attach](bool elsewhere) {
    autosave_->detach();
    if (elsewhere || !loop.is_running()) return;
    for (PenSample sample; loop.servo().for_autosave().pop(sample);) {
    }
    attach();
  });
  if (loop.is_running() && !studio.is_pen_elsewhere()) attach();
}

StudioAutosave::~StudioAutosave() {
  if (is_discarded_) autosave_->post({.modified = false});
  autosave_.reset();
}

void StudioAutosave::begin(const QString& name, const std::optional<QString>& path) {
  is_discarded_ = false;
  head_timer_.stop();
  Drawing drawing = current_();
  note_media(drawing);
  names_ = drawing.names;
  autosave_->session_began(studio_->session(), std::move(drawing), name.toStdString(),
                           path ? std::optional(path->toStdString()) : std::nullopt,
                           studio_->is_modified());
}

void StudioAutosave::rename(const QString& name, const QString& path) {
  autosave_->post({.name = name.toStdString(), .path = path.toStdString()});
}

void StudioAutosave::flush() {
  if (head_timer_.isActive()) post_head();
  autosave_->flush();
}

void StudioAutosave::post_head() {
  head_timer_.stop();
  if (!studio_) return;
  auto head = std::make_unique<Drawing>(current_());
  head->document = {};  // the autosave already has the document
  note_media(*head);
  autosave_->post({.head = std::move(head)});
}

/// Starts the timer unless it is running. A running timer is not restarted, so that figures are
/// stored even if they change continuously.
void StudioAutosave::post_head_soon() {
  if (!head_timer_.isActive()) head_timer_.start();
}

void StudioAutosave::note_media(const Drawing& drawing) {
  media_.clear();
  for (const std::string& text : drawing.materials) {
    const Result<AnyMaterial> material = read_material(text);
    if (material && std::holds_alternative<Medium>(*material)) media_.insert(id_of(*material));
  }
}

/// Returns true if a paste or an undo added strokes of a medium that Feltline does not ship and
/// that the autosave does not have yet.
bool StudioAutosave::lacks_medium_of(const Edit& edit) const {
  const Materials& known = studio_->session().materials();
  const Materials& built_in = Materials::built_in();
  return std::any_of(edit.changes.begin(), edit.changes.end(), [&](const StrokeChange& change) {
    if (!change.after || media_.contains(change.after->medium())) return false;
    const Medium* medium = known.find_medium(change.after->medium());
    const Medium* ours = built_in.find_medium(change.after->medium());
    return medium && !(ours && *ours == *medium);
  });
}

}  // namespace felt::desktop
