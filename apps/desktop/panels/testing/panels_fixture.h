#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"

/// For the tests of this room.
namespace felt::desktop::testing {

/// A studio without threads, its clock at rest.
inline StudioOptions still() {
  StudioOptions options;
  options.live = false;
  return options;
}

/// Adds so many lines, one below the other, each a step of undo, in the colour in use.
void draw_lines(Studio& studio, int count);

/// Every control below a widget that a person can reach and that has neither a text nor an
/// accessible name: by class and object name, for a message.
std::vector<std::string> nameless(const QWidget& widget);

/// The names of the layers, the topmost first, "*" behind the one in use.
std::string layer_names(const Studio& studio);

}  // namespace felt::desktop::testing
