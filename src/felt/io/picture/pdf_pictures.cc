#include "felt/io/picture/pdf_pictures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "felt/document/visible_strokes.h"
#include "felt/io/picture/png.h"
#include "felt/io/unpack.h"

namespace felt {
namespace {

std::string image_object(const Image& image, std::string_view space, const std::string& more,
                         const std::string& samples) {
  const std::string packed = zlib_packed(samples);
  return "<< /Type /XObject /Subtype /Image /Width " + std::to_string(image.width()) + " /Height " +
         std::to_string(image.height()) + " /ColorSpace /" + std::string(space) +
         " /BitsPerComponent 8" + more + " /Filter /FlateDecode /Length " +
         std::to_string(packed.size()) + " >>\nstream\n" + packed + "\nendstream";
}

/// Returns the colours of a picture without their alpha.
std::string colors_of(const Image& image) {
  std::string colors;
  const std::vector<std::uint8_t>& bytes = image.bytes();
  colors.reserve(bytes.size() / 4 * 3);
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    const int alpha = bytes[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const int color = alpha == 0 ? 0 : std::min(255, (bytes[i + c] * 255 + alpha / 2) / alpha);
      colors += static_cast<char>(color);
    }
  }
  return colors;
}

std::string alphas_of(const Image& image) {
  std::string alphas;
  const std::vector<std::uint8_t>& bytes = image.bytes();
  alphas.reserve(bytes.size() / 4);
  for (std::size_t i = 3; i < bytes.size(); i += 4) alphas += static_cast<char>(bytes[i]);
  return alphas;
}

/// Appends a number with six decimals and a space.
void append_entry(std::string& out, double value) {
  std::array<char, 40> text;
  constexpr int kDecimals = 6;
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                        std::chars_format::fixed, kDecimals)
                              .ptr);
  out += ' ';
}

}  // namespace

Result<PdfPictures> PdfPictures::create(const Document& document, PictureChoice choice,
                                        std::size_t first_object) {
  PdfPictures result;
  result.first_object_ = first_object;
  std::map<const PictureData*, std::size_t> known;
  for (const Layer& layer : document.layers()) {
    const LayerPicture* picture = exported_picture(layer, choice);
    if (!picture) continue;
    std::size_t& image = known[picture->data.get()];
    if (image == 0) {
      const Result<PngPicture> decoded = decode_png(picture->data->png);
      if (!decoded) {
        return tl::unexpected(with_context(decoded.error(), "layer \"" + layer.name + '"'));
      }
      image = known.size();
      const std::size_t alpha_object = first_object + 2 * (image - 1) + 1;
      result.bodies_.push_back(image_object(decoded->image, "DeviceRGB",
                                            " /SMask " + std::to_string(alpha_object) + " 0 R",
                                            colors_of(decoded->image)));
      result.bodies_.push_back(
          image_object(decoded->image, "DeviceGray", {}, alphas_of(decoded->image)));
    }
    result.images_[layer.id] = image;
    result.pictures_[layer.id] = layer.picture;
  }
  return result;
}

void PdfPictures::append_commands(std::string& out, const Layer& layer, double steps_per_mm) const {
  const auto found = images_.find(layer.id);
  if (found == images_.end()) return;
  const LayerPicture& picture = *pictures_.at(layer.id);
  const Affine& m = picture.place;
  const double w = picture.data->width_px, h = picture.data->height_px;
  // An image of PDF is the unit square with y up; the pixels of a picture have y down.
  out += "q ";
  for (const double v : {m.a * w, m.b * w, -m.c * h, -m.d * h, m.e + m.c * h, m.f + m.d * h}) {
    append_entry(out, steps_per_mm * v);
  }
  out += "cm /I" + std::to_string(found->second) + " Do Q\n";
}

bool PdfPictures::has(const Layer& layer) const {
  return images_.contains(layer.id);
}

std::string PdfPictures::resources() const {
  std::string out;
  for (std::size_t i = 0; 2 * i < bodies_.size(); ++i) {
    out += " /I" + std::to_string(i + 1) + " " + std::to_string(first_object_ + 2 * i) + " 0 R";
  }
  return out;
}

}  // namespace felt
