#pragma once

#include <string>

#include "felt/formats/drawing_reader.h"
#include "format.h"
#include "output.h"
#include "picture.h"

namespace felt::cli {

/// Where a whole drawing goes once it is there. What it holds beyond strokes comes along where the
/// format can say it: layers, hidden ones too, its sheet, its page unless the picture options ask
/// for another, and the texts of its materials.
class DrawingOutput {
 public:
  /// Nothing shows under that name before `write`. Error: the place cannot be written.
  static Result<DrawingOutput> create(const std::string& path, Format format,
                                      const PictureOptions& picture);

  /// Call once. Error: what the format cannot hold, a sheet whose grain is asked for and not known,
  /// or the disk; messages begin with the path where they are about the file.
  Result<void> write(OpenedDrawing drawing);

 private:
  DrawingOutput(std::string path, Format format, PictureOptions picture, Output output);

  std::string path_;
  Format format_;
  PictureOptions picture_;
  Output output_;
};

}  // namespace felt::cli
