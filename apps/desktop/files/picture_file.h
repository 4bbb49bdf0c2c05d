#pragma once

#include <QByteArray>
#include <QImage>
#include <QSizeF>
#include <QString>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/page.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// Longest side of an imported picture, in pixels. A larger picture is made smaller, because a
/// picture to draw over does not need more.
inline constexpr int kPictureSidePx = 4096;
/// Files with a side of more pixels are refused.
inline constexpr int kPictureFileSidePx = 32'000;

/// A picture read from a file or a clipboard.
struct ReadPicture {
  QImage image;
  QSizeF size_mm{};  ///< its true size; empty if the file does not state one
};

/// Returns true if the file is a picture that an import does not read as strokes: PNG, JPEG, WebP,
/// PDF and others by their endings.
[[nodiscard]] bool is_picture_path(const QString& path);

/// Returns the filter of a file dialog for pictures.
[[nodiscard]] QString picture_filter();

/// Reads a picture, or a page of a PDF file, at most kPictureSidePx pixels long. SVG files are
/// painted as other programs show them. `page` counts from 1 and matters only for PDF files. The
/// error names the file and the reason.
Result<ReadPicture> read_picture(const QString& path, int page = 1);

/// Converts the bytes of a JPEG, WebP, GIF or BMP file to a PNG file at most kPictureSidePx pixels
/// long (ImportOptions::to_png). Fails with ErrorCode::kLimitExceeded, before it decodes the
/// picture, if the file has more than `max_pixels`. Does not read SVG files, because they may refer
/// to other files. Safe to call from any thread.
Result<std::string> png_of_picture(std::string_view bytes, std::int64_t max_pixels);

/// Returns the number of pages of a PDF file; 1 for another file. Fails if the file is damaged, or
/// if the program pdfinfo of poppler-utils is missing.
Result<int> page_count(const QString& path);

/// Returns the event that adds the picture to the middle of the page: in its true size if that is
/// known and fits, otherwise as large as 80 % of the page. Fails if the picture is empty, or if its
/// PNG file would be larger than 48 MiB.
Result<AddPicture> add_picture_event(const QString& name, const ReadPicture& picture,
                                     const Page& page);

}  // namespace felt::desktop
