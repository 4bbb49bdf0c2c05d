#pragma once

#include <QString>

/// The stored settings of the solid view (engine/settings.h).
namespace felt::desktop::solid_keys {

/// True if closed lines inside an outline are ignored; the default. False: they are holes.
inline const QString kFillHoles = QStringLiteral("solid/fill_holes");
inline const QString kWireframe = QStringLiteral("solid/wireframe");

}  // namespace felt::desktop::solid_keys
