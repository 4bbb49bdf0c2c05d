#include "desktop/window/size_field.h"

#include <QSignalBlocker>
#include <cstdlib>

#include "desktop/engine/tool_size.h"

namespace felt::desktop {

SizeField::SizeField(Studio& studio, QWidget* parent) : QDoubleSpinBox(parent), studio_(studio) {
  setObjectName(QStringLiteral("top_size"));
  setAccessibleName(tr("Size"));
  setToolTip(
      tr("Width of a line drawn with the mouse, or size of the current tool. Press [ or ] to "
         "change it, or hold Ctrl and Alt and drag. Selected lines get the width, too."));
  setDecimals(2);
  setSuffix(tr(" mm"));
  setKeyboardTracking(false);
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QDoubleSpinBox::valueChanged, this, [this](double mm) {
    set_tool_size(studio_, mm);
    resize_selected(studio_);
    follow();
  });
  connect(&studio, &Studio::tool_changed, this, &SizeField::follow);
  connect(&studio, &Studio::opened, this, &SizeField::follow);
  connect(&studio, &Studio::option_changed, this, &SizeField::follow);
  follow();
}

void SizeField::stepBy(int steps) {
  for (int i = 0; i < std::abs(steps); ++i) step_tool_size(studio_, steps > 0);
  selectAll();
}

void SizeField::follow() {
  const std::optional<ToolSize> size = tool_size(studio_.session());
  setEnabled(size.has_value());
  if (!size) return;
  const QSignalBlocker quiet(this);
  setRange(size->min_mm, size->max_mm);
  setValue(size->mm);
}

}  // namespace felt::desktop
