#pragma once

#include <QString>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_desk.h"

namespace felt::desktop {

/// For tests: unsaved materials of other tests are forgotten, and those of this one afterwards. The
/// first member.
struct Clean {
  Clean() { forget(); }
  ~Clean() { forget(); }
  static void forget() { Settings::the().reset(QString::fromLatin1(material_keys::kUnsaved)); }
};

}  // namespace felt::desktop
