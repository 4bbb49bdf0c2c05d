#pragma once

#include <QString>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_editor_model.h"

namespace felt::desktop {

/// For tests: the constructor removes unsaved materials that other tests left in the settings, and
/// the destructor those of this test. Must be the first member of a fixture.
struct Clean {
  Clean() { forget(); }
  ~Clean() { forget(); }
  static void forget() { Settings::the().reset(QString::fromLatin1(material_keys::kUnsaved)); }
};

}  // namespace felt::desktop
