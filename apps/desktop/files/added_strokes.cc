#include "desktop/files/added_strokes.h"

#include <QCoreApplication>

namespace felt::desktop {

bool add_strokes(Studio& studio, const QString& from, const VisibleInk& ink,
                 std::span<const std::string> materials, ImportReport& report) {
  for (const std::string& label : studio.add_media(materials, ink.strokes)) {
    const QString what = QCoreApplication::translate(
        "AddedStrokes", "“%1” differs here: the added strokes look as it does in this drawing");
    report.add(0, {}, what.arg(QString::fromStdString(label)).toStdString());
  }
  return studio.import(from, ink.strokes, ink.fills);
}

}  // namespace felt::desktop
