#pragma once

#include <QString>

/// The settings of files (engine/settings.h), with their defaults.
namespace felt::desktop::files_keys {

/// Folder of the last file that was opened or saved; "" means the user's documents folder.
inline const QString kLastFolder = QStringLiteral("files/last_folder");
/// Recent files, the newest first: a list of absolute paths.
inline const QString kRecent = QStringLiteral("files/recent");
inline constexpr int kRecentCount = 10;

/// The last choices in the export dialog: the format such as "svg", the resolution, whether the
/// background is exported (true by default), whether only the area of the ink is exported, and
/// whether an .svg is made small (both false by default).
inline const QString kExportFormat = QStringLiteral("files/export_format");
inline const QString kExportDpi = QStringLiteral("files/export_dpi");
inline constexpr double kExportDpiDefault = 300.0;
inline const QString kExportBackground = QStringLiteral("files/export_background");
inline const QString kExportInkOnly = QStringLiteral("files/export_ink_only");
inline const QString kExportCompact = QStringLiteral("files/export_compact");

/// The last choices in the dialog for films: the extension such as ".webm", the length in seconds
/// (0: automatic), and the longer side in pixels.
inline const QString kTimelapseFormat = QStringLiteral("files/timelapse_format");
inline const QString kTimelapseSeconds = QStringLiteral("files/timelapse_seconds");
inline const QString kTimelapseSize = QStringLiteral("files/timelapse_size");
inline constexpr double kTimelapseSizeDefault = 1280.0;
/// The last choice in the dialog for animations: a number of AnimationFormat.
inline const QString kAnimationFormat = QStringLiteral("files/animation_format");

}  // namespace felt::desktop::files_keys
