#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "desktop/engine/studio.h"

/// Helpers for the tests of this folder.
namespace felt::desktop::testing {

/// Returns options for a studio without threads whose clock advances only on request.
inline StudioOptions still() {
  StudioOptions options;
  options.live = false;
  return options;
}

/// Adds `count` lines in the current colour, from top to bottom, each as a step of undo.
void draw_lines(Studio& studio, int count);

/// Returns the controls inside a widget that the user can reach but that have neither a text nor an
/// accessible name. Each is described by its class and object name, for a test's message.
std::vector<std::string> nameless(const QWidget& widget);

/// Returns the names of the layers, the topmost first, with "*" after the current one.
std::string layer_names(const Studio& studio);

}  // namespace felt::desktop::testing
