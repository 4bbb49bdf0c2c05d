#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/layer_picture.h"

namespace felt {

/// The pictures of layers as objects of a PDF file: each is an image with its colours, and a second
/// one with its alpha (PDF 1.4, 4.8.4 and 7.5.4).
class PdfPictures {
 public:
  /// Decodes and packs the pictures of the visible layers that `choice` includes. Fails if one is
  /// damaged; the message names its layer. `first_object` is the number of the first object.
  static Result<PdfPictures> create(const Document& document, PictureChoice choice,
                                    std::size_t first_object);

  /// Appends the commands that paint the picture of a layer; nothing if it has none. Their unit is
  /// a step, `steps_per_mm` of them for a mm. The caller sets the alpha.
  void append_commands(std::string& out, const Layer& layer, double steps_per_mm) const;
  /// Returns true if the picture of a layer is in the file.
  [[nodiscard]] bool has(const Layer& layer) const;
  /// Returns the names of all images for the resources of the page: " /I1 6 0 R /I2 8 0 R".
  [[nodiscard]] std::string resources() const;
  /// Returns the bodies of the objects in the order of their numbers.
  [[nodiscard]] const std::vector<std::string>& bodies() const noexcept { return bodies_; }

 private:
  std::map<LayerId, std::size_t> images_;  // of each layer, from 1
  std::map<LayerId, LayerPicturePtr> pictures_;
  std::vector<std::string> bodies_;  // two for each image
  std::size_t first_object_ = 0;
};

}  // namespace felt
