#include "desktop/panels/testing/panels_fixture.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAccessibleInterface>

namespace felt::desktop::testing {

void draw_lines(Studio& studio, int count) {
  for (int i = 0; i < count; ++i) {
    StrokeData data;
    data.points = {{10, 10.0 + i}, {20, 10.0 + i}, {30, 10.0 + i}, {40, 10.0 + i}};
    data.widths = {{0.0, 1.0}, {1.0, 1.0}};
    data.color = studio.session().ink_color();
    Result<Stroke> stroke = Stroke::create(std::move(data));
    studio.import(QStringLiteral("lines"),
                  std::vector{std::make_shared<const Stroke>(*std::move(stroke))});
  }
}

std::vector<std::string> nameless(const QWidget& widget) {
  std::vector<std::string> found;
  for (QWidget* child : widget.findChildren<QWidget*>()) {
    if (child->focusPolicy() == Qt::NoFocus || child->inherits("QMenu")) continue;
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(child);
    // The line edit of a spin box gets its name from the box.
    const bool is_part = child->objectName().startsWith(QLatin1String("qt_"));
    if (is_part || !seen || !seen->text(QAccessible::Name).isEmpty()) continue;
    found.push_back(std::string(child->metaObject()->className()) + " " +
                    child->objectName().toStdString());
  }
  return found;
}

std::string layer_names(const Studio& studio) {
  std::string names;
  const auto layers = studio.session().document().layers();
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    names += (names.empty() ? "" : " ") + layer->name;
    if (layer->id == studio.session().layer()) names += "*";
  }
  return names;
}

}  // namespace felt::desktop::testing
