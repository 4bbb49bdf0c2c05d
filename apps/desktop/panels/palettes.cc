#include "desktop/panels/palettes.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>
#include <span>

namespace felt::desktop {
namespace {

constexpr std::size_t kMaxFiles = 500;

/// One of the built-in colours: 0xrrggbb and its English name.
struct Entry {
  unsigned rgb;
  const char* name;
};

constexpr Entry kPencilBox[] = {
    {0x1c1b1a, QT_TRANSLATE_NOOP("Palettes", "Soft black")},
    {0x4a4744, QT_TRANSLATE_NOOP("Palettes", "Graphite")},
    {0x8c8782, QT_TRANSLATE_NOOP("Palettes", "Lead")},
    {0xf7f3ea, QT_TRANSLATE_NOOP("Palettes", "Chalk")},
    {0x7a2e1f, QT_TRANSLATE_NOOP("Palettes", "Red chalk")},
    {0xc0392b, QT_TRANSLATE_NOOP("Palettes", "Brick")},
    {0xe4572e, QT_TRANSLATE_NOOP("Palettes", "Vermilion")},
    {0xf0a202, QT_TRANSLATE_NOOP("Palettes", "Amber")},
    {0xf6d55c, QT_TRANSLATE_NOOP("Palettes", "Straw")},
    {0x7a9e3f, QT_TRANSLATE_NOOP("Palettes", "Moss")},
    {0x2f6f4f, QT_TRANSLATE_NOOP("Palettes", "Fir")},
    {0x1f8a8a, QT_TRANSLATE_NOOP("Palettes", "Teal")},
    {0x3a86c8, QT_TRANSLATE_NOOP("Palettes", "Sky")},
    {0x1f4e8c, QT_TRANSLATE_NOOP("Palettes", "Ink blue")},
    {0x5b3f8c, QT_TRANSLATE_NOOP("Palettes", "Violet")},
    {0xa83f7f, QT_TRANSLATE_NOOP("Palettes", "Mallow")},
    {0xe8a0a0, QT_TRANSLATE_NOOP("Palettes", "Blush")},
    {0x8a5a33, QT_TRANSLATE_NOOP("Palettes", "Sepia")},
};

// M. Okabe and K. Ito, "Color Universal Design", 2008.
constexpr Entry kOkabeIto[] = {
    {0x000000, QT_TRANSLATE_NOOP("Palettes", "Black")},
    {0xe69f00, QT_TRANSLATE_NOOP("Palettes", "Orange")},
    {0x56b4e9, QT_TRANSLATE_NOOP("Palettes", "Sky blue")},
    {0x009e73, QT_TRANSLATE_NOOP("Palettes", "Bluish green")},
    {0xf0e442, QT_TRANSLATE_NOOP("Palettes", "Yellow")},
    {0x0072b2, QT_TRANSLATE_NOOP("Palettes", "Blue")},
    {0xd55e00, QT_TRANSLATE_NOOP("Palettes", "Vermilion")},
    {0xcc79a7, QT_TRANSLATE_NOOP("Palettes", "Reddish purple")},
};

QString palette_text(const char* english) {
  return QCoreApplication::translate("Palettes", english);
}

NamedColor named(unsigned rgb, const QString& name) {
  const auto part = [rgb](unsigned shift) { return static_cast<std::uint8_t>(rgb >> shift); };
  return {{part(16), part(8), part(0)}, name.toStdString()};
}

PaletteSource source_of(const QString& title, std::span<const Entry> entries) {
  PaletteSource source{title};
  source.palette.name = title.toStdString();
  for (const Entry& entry : entries) {
    source.palette.colors.push_back(named(entry.rgb, palette_text(entry.name)));
  }
  return source;
}

PaletteSource greys() {
  PaletteSource source{palette_text(QT_TRANSLATE_NOOP("Palettes", "Greys"))};
  source.palette.name = source.title.toStdString();
  constexpr unsigned kSteps = 10;
  for (unsigned i = 0; i <= kSteps; ++i) {
    const unsigned grey = (255 * i + kSteps / 2) / kSteps;
    source.palette.colors.push_back(
        named(grey << 16 | grey << 8 | grey,
              palette_text(QT_TRANSLATE_NOOP("Palettes", "Grey %1 %")).arg(100 * i / kSteps)));
  }
  return source;
}

std::string reason(const QString& path, const QFileDevice& file) {
  return (path + QStringLiteral(": ") + file.errorString()).toStdString();
}

}  // namespace

std::vector<PaletteSource> built_in_palettes() {
  return {source_of(palette_text(QT_TRANSLATE_NOOP("Palettes", "Pencil box")), kPencilBox),
          source_of(palette_text(QT_TRANSLATE_NOOP("Palettes", "Okabe and Ito")), kOkabeIto),
          greys()};
}

std::vector<PaletteSource> palette_files(const QStringList& opened) {
  QStringList paths;
  const QStringList folders = QStandardPaths::locateAll(QStandardPaths::GenericDataLocation,
                                                        QStringLiteral("feltline/palettes"),
                                                        QStandardPaths::LocateDirectory);
  for (const QString& folder : folders) {
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.gpl")}, QDir::Files, QDir::Name)) {
      paths.push_back(dir.filePath(name));
    }
  }
  paths += opened;
  std::vector<PaletteSource> sources;
  QStringList seen;
  for (const QString& path : paths) {
    const QFileInfo file(path);
    const QString whole = file.canonicalFilePath();
    if (whole.isEmpty() || seen.contains(whole) || sources.size() >= kMaxFiles) continue;
    seen.push_back(whole);
    sources.push_back({file.completeBaseName(), path});
  }
  return sources;
}

Result<Palette> load_palette(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return fail(ErrorCode::kIo, reason(path, file));
  // Reads one byte more than the limit, so that read_gpl() reports a file that is too large.
  const QByteArray bytes = file.read(qint64(PaletteLimits::kMaxBytes) + 1);
  if (file.error() != QFileDevice::NoError) return fail(ErrorCode::kIo, reason(path, file));
  return read_gpl(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

Result<void> save_palette(const QString& path, const Palette& palette) {
  const std::string palette_text = write_gpl(palette);
  QSaveFile file(path);
  const bool written =
      file.open(QIODevice::WriteOnly) &&
      file.write(palette_text.data(), qint64(palette_text.size())) == qint64(palette_text.size()) &&
      file.commit();
  if (!written) return fail(ErrorCode::kIo, reason(path, file));
  return {};
}

}  // namespace felt::desktop
