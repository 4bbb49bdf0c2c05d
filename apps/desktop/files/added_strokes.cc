#include "desktop/files/added_strokes.h"

#include <QCoreApplication>

namespace felt::desktop {

bool add_strokes(Studio& studio, const QString& from, const ForeignStrokes& foreign,
                 ImportReport& report) {
  for (const std::string& label : studio.bring(foreign.materials, foreign.strokes)) {
    const QString what = QCoreApplication::translate(
        "AddedStrokes", "“%1” is another medium here than there: its strokes look as they do here");
    report.add(0, {}, what.arg(QString::fromStdString(label)).toStdString());
  }
  return studio.import(from, foreign.strokes);
}

}  // namespace felt::desktop
