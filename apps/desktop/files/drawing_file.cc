#include "desktop/files/drawing_file.h"

#include <string>
#include <utility>

#include "desktop/files/picture_file.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"

namespace felt::desktop {

QString suffix_of(FileFormat format) {
  const std::string_view ending = traits_of(format).endings.front();
  return QString::fromLatin1(ending.data(), qsizetype(ending.size()));
}

QString with_suffix(const QString& path, FileFormat format) {
  const Result<FileFormat> present = format_of_path(path.toStdString());
  return present && *present == format ? path : path + suffix_of(format);
}

Result<Imported> open_drawing(const QString& path, bool salvage) {
  return felt::read_drawing(
      path.toStdString(),
      ReadOptions{.import = {.to_png = png_of_picture}, .files_only = true, .salvage = salvage});
}

Result<Drawing> read_drawing(const QString& path) {
  return open_drawing(path).map([](Imported opened) { return std::move(opened.drawing); });
}

Result<void> write_drawing(const QString& path, const Drawing& drawing) {
  const std::string name = path.toStdString();
  return format_of_path(name).and_then(
      [&](FileFormat format) { return felt::write_drawing(name, drawing, format); });
}

}  // namespace felt::desktop
