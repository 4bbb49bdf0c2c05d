#pragma once

#include <QString>
#include <vector>

#include "felt/document/document.h"

namespace felt::desktop {

/// A drawing that comes with the program. The project's own simulated hand draws it.
struct Example {
  QString id;     ///< "cat"
  QString title;  ///< translated
};

/// Returns all examples in the order of the menu.
std::vector<Example> examples();

/// Draws an example; takes a few tens of milliseconds. Returns an empty document if no example has
/// that id.
Document example_document(const QString& id);

}  // namespace felt::desktop
