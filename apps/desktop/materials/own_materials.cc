#include "desktop/materials/own_materials.h"

#include <QCoreApplication>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/materials/settings_keys.h"
#include "felt/io/png.h"
#include "felt/material/material_library.h"

namespace felt::desktop {
namespace {

constexpr int kKeepMs = 500;

QString text_of(const std::string& text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

}  // namespace

OwnMaterials& OwnMaterials::the() {
  // The application's: it goes before the settings do.
  static OwnMaterials& own = *new OwnMaterials(material_folders(), qApp);
  return own;
}

OwnMaterials::OwnMaterials(std::vector<std::string> folders, QObject* parent)
    : QObject(parent), folders_(std::move(folders)) {
  keep_.setSingleShot(true);
  keep_.setInterval(kKeepMs);
  connect(&keep_, &QTimer::timeout, this, &OwnMaterials::keep_changes);
  const MaterialLibrary library = load_materials(folders_, read_height_png);
  for (const MaterialEntry& own : library.own) {
    entries_[key_of(own.material)] = {own.material, own.material};
  }
  for (const std::string& problem : library.problems) problems_ << text_of(problem);
  read_changes();
}

OwnMaterials::~OwnMaterials() {
  if (keep_.isActive()) keep_changes();
}

void OwnMaterials::read_changes() {
  const QStringList texts =
      Settings::the().value(QString::fromLatin1(material_keys::kUnsaved)).toStringList();
  for (const QString& text : texts) {
    const Result<AnyMaterial> read = read_material(text.toStdString());
    if (!read || is_built_in(key_of(*read))) continue;
    entries_[key_of(*read)].now = *read;
  }
}

std::vector<const OwnMaterials::Entry*> OwnMaterials::all() const {
  std::vector<const Entry*> sheets, media;
  for (const auto& [key, entry] : entries_) (key.is_sheet ? sheets : media).push_back(&entry);
  sheets.insert(sheets.end(), media.begin(), media.end());
  return sheets;
}

const OwnMaterials::Entry* OwnMaterials::find(const MaterialKey& key) const {
  const auto at = entries_.find(key);
  return at == entries_.end() ? nullptr : &at->second;
}

Materials OwnMaterials::known() const {
  Materials all = Materials::built_in();
  for (const auto& [key, entry] : entries_) felt::put(all, entry.now);
  return all;
}

bool OwnMaterials::is_taken(const std::string& id) const {
  for (const bool is_sheet : {true, false}) {
    const MaterialKey key{is_sheet, id};
    if (is_built_in(key) || find(key)) return true;
  }
  return false;
}

void OwnMaterials::put(const AnyMaterial& now) {
  const MaterialKey key = key_of(now);
  if (is_built_in(key)) return;
  const auto [at, is_new] = entries_.try_emplace(key, Entry{now, std::nullopt});
  if (!is_new && at->second.now == now) return;
  at->second.now = now;
  keep_.start();
  Q_EMIT changed(key);
}

void OwnMaterials::revert(const MaterialKey& key) {
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

Result<void> OwnMaterials::save(const MaterialKey& key) {
  const auto at = entries_.find(key);
  if (at == entries_.end()) return {};
  Entry& entry = at->second;
  const std::string folder = folders_.empty() ? std::string() : folders_.front();
  if (Result<std::string> saved = save_material(folder, entry.now); !saved) {
    return tl::unexpected(saved.error());
  }
  entry.saved = entry.now;
  keep_changes();
  Q_EMIT changed(key);
  return {};
}

Result<void> OwnMaterials::remove(const MaterialKey& key) {
  const auto at = entries_.find(key);
  if (at == entries_.end()) return {};
  if (at->second.saved) {
    const std::string folder = folders_.empty() ? std::string() : folders_.front();
    if (Result<void> gone = delete_material(folder, key.id); !gone) return gone;
  }
  entries_.erase(at);
  keep_changes();
  Q_EMIT changed(key);
  return {};
}

void OwnMaterials::keep_changes() {
  keep_.stop();
  QStringList texts;
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
