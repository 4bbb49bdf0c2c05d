#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "felt/document/blend_mode.h"
#include "felt/geometry/rect.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/io/picture/pdf_pictures.h"

namespace felt {

/// The bodies of the objects of a PDF file, except for its content. Private to pdf_writer.cc.

inline constexpr double kPdfPointsPerMm = 72.0 / 25.4;
inline constexpr double kPdfStepsPerMm = 1e3;  ///< a step of coordinates is 1e-3 mm

/// Appends a value with four decimals, without trailing zeros, and a space.
void append_pdf_number(std::string& out, double value);

/// The number of the first object after the page's content. The pictures of layers come first, then
/// the masks, then the forms.
inline constexpr std::size_t kFirstPdfObject = 6;

/// Collects the objects of each mask as bodies of PDF objects: the picture, and the group that
/// places it on the page.
class PdfMasks {
 public:
  explicit PdfMasks(std::size_t first_object) noexcept : first_object_(first_object) {}

  [[nodiscard]] std::size_t first_object() const noexcept { return first_object_; }
  /// Returns the number of the object with the picture of a mask; its group follows.
  [[nodiscard]] std::size_t picture_of(std::size_t mask) const noexcept {
    return first_object_ + 2 * (mask - 1);
  }
  [[nodiscard]] std::size_t count() const noexcept { return bodies_.size() / 2; }
  [[nodiscard]] const std::vector<std::string>& bodies() const noexcept { return bodies_; }

  /// Adds a mask and returns its number, from 1.
  std::size_t add(const GrainMask& mask);

 private:
  std::size_t first_object_;
  std::vector<std::string> bodies_;
};

/// A layer or a group of layers that is drawn as a whole: a form with a transparency group
/// (PDF 1.4, 7.3.6).
struct PdfForm {
  std::string content;
  double opacity = 1.0;
  BlendMode blend = BlendMode::kNormal;
};

/// The named objects that the page and the forms use. They are one object, to which all of these
/// refer: written into each form, they would make the file grow with the square of the number of
/// layers.
struct PdfResources {
  const std::set<std::uint8_t>& alphas;
  const PdfPictures& pictures;
  const PdfMasks& masks;
  const std::vector<PdfForm>& forms;

  /// Returns the number of the object of a form, which follow those of the masks.
  [[nodiscard]] std::size_t object_of_form(std::size_t number) const;
  /// Returns the number of the object with the resources, which follows the forms.
  [[nodiscard]] std::size_t object() const { return object_of_form(forms.size() + 1); }
  [[nodiscard]] std::string text() const;
};

/// Return the bodies of the objects of the page and of a form.
std::string pdf_page_object(const Rect& area, const PdfResources& resources);
std::string pdf_form_object(const Rect& area, const PdfForm& form, const PdfResources& resources);

}  // namespace felt
