#pragma once

#include <QString>
#include <vector>

#include "felt/document/document.h"

namespace felt::desktop {

/// A drawing that comes with the program, made afresh by the project's own simulated hand.
struct Example {
  QString id;     ///< "cat"
  QString title;  ///< translated
};

/// All there are, in the order of the menu.
std::vector<Example> examples();

/// Draws it; takes some ten milliseconds. An empty document for an id that there is not.
Document example_document(const QString& id);

}  // namespace felt::desktop
