#pragma once

#include "desktop/engine/actions.h"
#include "desktop/files/file_actions.h"
#include "desktop/solid/solid_panel.h"
#include "felt/solid/solid_writer.h"

namespace felt::desktop {

/// Adds the actions "file.export_solid_stl", "..._obj", "..._3mf" and "..._glb", which write the
/// bodies of the solid view. They are enabled while it shows a body. `panel` must live as long as
/// `actions`.
void add_solid_actions(Actions& actions, FileActions& files, SolidPanel& panel, QWidget* window);

/// The bodies, and the ink on them or null.
struct PaintedSolid {
  std::shared_ptr<const Solid> solid;
  std::shared_ptr<const FrontPaint> paint;
};

/// Writes a solid on the thread for files, and emits FileActions::exported, with a sentence if the
/// format has no paint. An error is shown to the user.
void export_solid(FileActions& files, const PaintedSolid& painted, SolidFormat format,
                  const QString& path, QWidget* window);

}  // namespace felt::desktop
