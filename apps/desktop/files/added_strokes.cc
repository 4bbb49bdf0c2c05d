#include "desktop/files/added_strokes.h"

#include <QCoreApplication>

namespace felt::desktop {

bool add_strokes(Studio& studio, const QString& from, std::span<const StrokePtr> strokes,
                 std::span<const std::string> materials, ImportReport& report) {
  for (const std::string& label : studio.add_media(materials, strokes)) {
    const QString what = QCoreApplication::translate(
        "AddedStrokes", "“%1” differs here: the added strokes look as it does in this drawing");
    report.add(0, {}, what.arg(QString::fromStdString(label)).toStdString());
  }
  return studio.import(from, strokes);
}

}  // namespace felt::desktop
