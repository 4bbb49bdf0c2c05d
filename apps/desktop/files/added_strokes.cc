#include "desktop/files/added_strokes.h"

#include <QCoreApplication>
#include <algorithm>
#include <span>

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

void note_pictures(const Document& document, ImportReport& report) {
  const std::span<const Layer> layers = document.layers();
  const auto count = std::count_if(layers.begin(), layers.end(),
                                   [](const Layer& layer) { return layer.picture != nullptr; });
  if (count == 0) return;
  const QString what = QCoreApplication::translate(
      "AddedStrokes", "Pictures of this file were not added: %1. Open the file to see them.");
  report.add(0, {}, what.arg(count).toStdString());
}

}  // namespace felt::desktop
