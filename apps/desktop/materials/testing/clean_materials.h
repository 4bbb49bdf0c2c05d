#pragma once

#include <QString>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_desk.h"

namespace felt::desktop {

/// For tests: removes unsaved materials of other tests at its start, and those of this test at its
/// end. It must be the first member.
struct Clean {
  Clean() { forget(); }
  ~Clean() { forget(); }
  static void forget() { Settings::the().reset(QString::fromLatin1(material_keys::kUnsaved)); }
};

}  // namespace felt::desktop
