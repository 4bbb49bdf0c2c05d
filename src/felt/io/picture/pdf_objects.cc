#include "felt/io/picture/pdf_objects.h"

#include <array>
#include <charconv>
#include <cmath>

#include "felt/io/unpack.h"

namespace felt {
namespace {

constexpr double kHairMm = 5e-4;

const char* pdf_name_of(BlendMode mode) noexcept {
  switch (mode) {
    case BlendMode::kMultiply:
      return "/Multiply";
    case BlendMode::kNormal:
      break;
  }
  return "/Normal";
}

}  // namespace

/// Appends a value with four decimals, without trailing zeros, and a space.
void append_pdf_number(std::string& out, double value) {
  constexpr double kPlaces = 1e4;
  std::array<char, 40> text{};
  const double rounded = std::round(value * kPlaces) / kPlaces;
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(),
                                        rounded == 0.0 ? 0.0 : rounded, std::chars_format::fixed)
                              .ptr);
  out += ' ';
}

std::size_t PdfMasks::add(const GrainMask& mask) {
  const std::string packed =
      zlib_packed({reinterpret_cast<const char*>(mask.seen.data()), mask.seen.size()});
  bodies_.push_back("<< /Type /XObject /Subtype /Image /Width " + std::to_string(mask.width) +
                    " /Height " + std::to_string(mask.height) +
                    " /ColorSpace /DeviceGray /BitsPerComponent 8 /Filter /FlateDecode /Length " +
                    std::to_string(packed.size()) + " >>\nstream\n" + packed + "\nendstream");
  // The unit square of a picture has y up; our page has y down. The picture is slightly smaller
  // than its area, because programs that round a picture outwards to whole pixels, such as
  // poppler, would stretch one that ends on a pixel's edge by a pixel.
  const Rect area = mask.area.inflated(-kHairMm);
  std::string place = "q ";
  for (const double v : {area.width(), 0.0, 0.0, -area.height(), area.x0, area.y1}) {
    append_pdf_number(place, kPdfStepsPerMm * v);
  }
  place += "cm /P Do Q\n";
  std::string group = "<< /Type /XObject /Subtype /Form /BBox [";
  for (const double v : {mask.area.x0, mask.area.y0, mask.area.x1, mask.area.y1}) {
    append_pdf_number(group, kPdfStepsPerMm * v);
  }
  group += "] /Group << /S /Transparency /CS /DeviceGray /I true >> /Resources << /XObject << /P " +
           std::to_string(picture_of(count() + 1)) + " 0 R >> >> /Length " +
           std::to_string(place.size()) + " >>\nstream\n" + place + "endstream";
  bodies_.push_back(std::move(group));
  return count();
}

std::size_t PdfResources::object_of_form(std::size_t number) const {
  return masks.picture_of(masks.count() + 1) + number - 1;
}

std::string PdfResources::text() const {
  std::string out = "<< /ExtGState <<";
  for (const std::uint8_t alpha : alphas) {
    out += " /A" + std::to_string(alpha) + " << /ca ";
    append_pdf_number(out, alpha / 255.0);
    out += ">>";
  }
  for (std::size_t mask = 1; mask <= masks.count(); ++mask) {
    out += " /G" + std::to_string(mask) + " << /SMask << /S /Luminosity /G " +
           std::to_string(masks.picture_of(mask) + 1) + " 0 R >> >>";
  }
  for (std::size_t i = 1; i <= forms.size(); ++i) {
    out += " /L" + std::to_string(i) + " << /ca ";
    append_pdf_number(out, forms[i - 1].opacity);
    out += std::string("/BM ") + pdf_name_of(forms[i - 1].blend) + " >>";
  }
  out += " >>";
  const bool has_objects = !forms.empty() || !pictures.bodies().empty();
  if (has_objects) out += " /XObject <<" + pictures.resources();
  for (std::size_t i = 1; i <= forms.size(); ++i) {
    out += " /F" + std::to_string(i) + ' ' + std::to_string(object_of_form(i)) + " 0 R";
  }
  return out + (has_objects ? " >> >>" : " >>");
}

std::string pdf_page_object(const Rect& area, const PdfResources& resources) {
  std::string out = "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 ";
  append_pdf_number(out, area.width() * kPdfPointsPerMm);
  append_pdf_number(out, area.height() * kPdfPointsPerMm);
  // With this group, transparent colours are blended in the device's RGB space. It is close to
  // sRGB, in which Feltline blends everywhere else.
  return out + "] /Contents 4 0 R /Group << /S /Transparency /CS /DeviceRGB >> /Resources " +
         std::to_string(resources.object()) + " 0 R >>";
}

std::string pdf_form_object(const Rect& area, const PdfForm& form, const PdfResources& resources) {
  const std::string packed = zlib_packed(form.content);
  std::string out = "<< /Type /XObject /Subtype /Form /BBox [";
  for (const double v : {area.x0, area.y0, area.x1, area.y1}) {
    append_pdf_number(out, kPdfStepsPerMm * v);
  }
  return out + "] /Group << /S /Transparency /CS /DeviceRGB /I true >> /Resources " +
         std::to_string(resources.object()) + " 0 R /Filter /FlateDecode /Length " +
         std::to_string(packed.size()) + " >>\nstream\n" + packed + "\nendstream";
}

}  // namespace felt
