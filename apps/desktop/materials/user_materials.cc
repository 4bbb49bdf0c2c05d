#include "desktop/materials/user_materials.h"

#include <QCoreApplication>
#include <filesystem>
#include <system_error>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "desktop/materials/material_setting_keys.h"
#include "felt/io/picture/png.h"
#include "felt/material/material_library.h"

namespace felt::desktop {
namespace {

constexpr int kKeepMs = 500;

/// Returns true if the file contains the material as it is now, or as it was last read or saved
/// here. The file can then be replaced or deleted without losing other changes.
bool is_known(const std::string& path, const UserMaterials::Entry& entry) {
  const Result<AnyMaterial> there = read_material_file(path, read_height_png);
  return there && (*there == entry.now || *there == entry.saved);
}

bool is_gone(const std::string& path) {
  std::error_code error;
  return !std::filesystem::exists(path, error) && !error;
}

}  // namespace

UserMaterials& UserMaterials::the() {
  // A child of the application, so that it is destroyed before the settings.
  static UserMaterials& own = *new UserMaterials(material_folders(), qApp);
  return own;
}

UserMaterials::UserMaterials(std::vector<std::string> folders, QObject* parent)
    : QObject(parent), folders_(std::move(folders)) {
  keep_.setSingleShot(true);
  keep_.setInterval(kKeepMs);
  connect(&keep_, &QTimer::timeout, this, &UserMaterials::keep_changes);
  const MaterialLibrary library = load_materials(folders_, read_height_png);
  for (const MaterialEntry& own : library.own) {
    entries_[key_of(own.material)] = {own.material, own.material, own.path};
  }
  for (const std::string& problem : library.problems) problems_ << text_of(problem);
  read_changes();
}

UserMaterials::~UserMaterials() {
  if (keep_.isActive()) keep_changes();
}

void UserMaterials::read_changes() {
  const QStringList texts =
      Settings::the().value(QString::fromLatin1(material_keys::kUnsaved)).toStringList();
  for (const QString& text : texts) {
    MaterialSource source;
    source.name = tr("not saved").toStdString();
    const Result<AnyMaterial> read = read_material(text.toStdString(), source);
    const std::string wrong = read ? new_id_error(id_of(*read)) : read.error().message;
    if (wrong.empty()) {
      entries_[key_of(*read)].now = *read;
    } else {
      problems_ << text_of(wrong);
      unread_ << text;
    }
  }
}

std::vector<const UserMaterials::Entry*> UserMaterials::all() const {
  std::vector<const Entry*> surfaces, media;
  for (const auto& [key, entry] : entries_) (key.is_surface ? surfaces : media).push_back(&entry);
  surfaces.insert(surfaces.end(), media.begin(), media.end());
  return surfaces;
}

const UserMaterials::Entry* UserMaterials::find(const MaterialKey& key) const {
  const auto at = entries_.find(key);
  return at == entries_.end() ? nullptr : &at->second;
}

Materials UserMaterials::known() const {
  Materials all = Materials::built_in();
  for (const auto& [key, entry] : entries_) felt::put(all, entry.now);
  return all;
}

bool UserMaterials::is_taken(const std::string& id) const {
  for (const bool is_surface : {true, false}) {
    const MaterialKey key{is_surface, id};
    if (is_built_in(key) || find(key)) return true;
  }
  return false;
}

void UserMaterials::put(const AnyMaterial& now) {
  const MaterialKey key = key_of(now);
  if (is_built_in(key)) return;
  const auto [at, is_new] = entries_.try_emplace(key, Entry{now, std::nullopt, {}});
  if (!is_new && at->second.now == now) return;
  at->second.now = now;
  keep_.start();
  Q_EMIT changed(key);
}

void UserMaterials::revert(const MaterialKey& key) {
  const auto at = entries_.find(key);
  if (at == entries_.end()) return;
  if (at->second.saved) {
    at->second.now = *at->second.saved;
  } else {
    entries_.erase(at);
  }
  keep_.start();
  Q_EMIT changed(key);
}

Result<void> UserMaterials::save(const MaterialKey& key) {
  const auto at = entries_.find(key);
  if (at == entries_.end()) return {};
  Entry& entry = at->second;
  const std::string old = material_path(user_folder(), entry.now);
  if (!old.empty() && !is_known(old, entry)) {
    return fail(ErrorCode::kInvalidData,
                tr("%1 was changed by another program and was not overwritten. Save your material "
                   "under another name; you can import the file.")
                    .arg(text_of(old))
                    .toStdString());
  }
  Result<std::string> path = save_material(user_folder(), entry.now);
  if (!path) return tl::unexpected(path.error());
  entry.saved = entry.now;
  entry.path = *std::move(path);
  keep_changes();
  Q_EMIT changed(key);
  return {};
}

QString UserMaterials::kept_because(const MaterialKey& key) const {
  const Entry* entry = find(key);
  if (!entry || entry->path.empty()) return {};
  const std::string folder = user_folder();
  if (!folder.empty() && entry->path.starts_with(folder + "/")) return {};
  return tr("It is installed for all users of this computer and cannot be deleted here: %1")
      .arg(text_of(entry->path));
}

Result<void> UserMaterials::remove_file(const Entry& entry) const {
  if (const QString why = kept_because(key_of(entry.now)); !why.isEmpty()) {
    return fail(ErrorCode::kInvalidArgument, why.toStdString());
  }
  const std::string path = material_path(user_folder(), entry.now);
  if (path.empty() && is_gone(entry.path)) return {};
  if (!path.empty() && !is_known(path, entry)) {
    return fail(
        ErrorCode::kInvalidData,
        tr("%1 was changed by another program and was not deleted. To remove it, delete the file.")
            .arg(text_of(path))
            .toStdString());
  }
  return delete_material(user_folder(), entry.now);
}

std::string UserMaterials::user_folder() const {
  return folders_.empty() ? std::string() : folders_.front();
}

Result<void> UserMaterials::remove(const MaterialKey& key) {
  const auto at = entries_.find(key);
  if (at == entries_.end()) return {};
  if (at->second.saved) {
    if (Result<void> gone = remove_file(at->second); !gone) return gone;
  }
  entries_.erase(at);
  keep_changes();
  Q_EMIT changed(key);
  return {};
}

void UserMaterials::keep_changes() {
  keep_.stop();
  QStringList texts = unread_;
  for (const auto& [key, entry] : entries_) {
    if (entry.is_changed()) texts << text_of(write_material(entry.now));
  }
  const QString key = QString::fromLatin1(material_keys::kUnsaved);
  if (texts.isEmpty()) {
    Settings::the().reset(key);
  } else {
    Settings::the().set(key, texts);
  }
}

}  // namespace felt::desktop
