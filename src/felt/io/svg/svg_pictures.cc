#include "felt/io/svg/svg_pictures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "felt/base/base64.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/render/picture_pixels.h"

namespace felt {
namespace {

tl::unexpected<Error> skipped(const std::string& why) {
  return fail(ErrorCode::kUnsupported, "was skipped: " + why);
}

int hex_value(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Replaces "%41" by "A", as in URIs. Other uses of "%" stay as they are.
std::string without_percents(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && i + 2 < text.size() && hex_value(text[i + 1]) >= 0 &&
                         hex_value(text[i + 2]) >= 0;
    clean +=
        is_code ? static_cast<char>(16 * hex_value(text[i + 1]) + hex_value(text[i + 2])) : text[i];
    if (is_code) i += 2;
  }
  return clean;
}

/// Decodes the part of a data URI after "data:" (RFC 2397).
Result<std::string> data_of_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return skipped("its data URI is damaged");
  const std::string_view type = svg_trimmed(uri.substr(0, comma));
  std::string_view coded = uri.substr(comma + 1);
  if (coded.size() > 2 * PictureData::kMaxBytes)
    return skipped("the picture is larger than 48 MiB");
  std::string clean;
  if (coded.find('%') != std::string_view::npos) coded = clean = without_percents(coded);
  constexpr std::string_view kBase64 = ";base64";
  if (!type.ends_with(kBase64)) return std::string(coded);
  std::optional<std::string> bytes = base64_bytes(coded);
  // Some programs leave the padding out.
  for (const char* padding : {"=", "=="}) {
    if (!bytes) bytes = base64_bytes(std::string(coded) + padding);
  }
  if (!bytes) return skipped("its base64 data are damaged");
  return *std::move(bytes);
}

/// Returns the format of a picture by its first bytes.
std::string_view picture_format(std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8\xff")) return "a JPEG picture";
  if (bytes.starts_with("GIF8")) return "a GIF picture";
  if (bytes.starts_with("RIFF") && bytes.substr(0, 16).find("WEBP") == 8) return "a WebP picture";
  if (svg_trimmed(bytes.substr(0, 4096)).starts_with("<")) return "an SVG drawing";
  return "of an unknown format";
}

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

}  // namespace

Result<std::shared_ptr<const PictureData>> SvgPictures::load(std::string_view href) {
  href = svg_trimmed(href);
  const auto known = loaded_.find(href);
  if (known != loaded_.end()) return known->second;
  if (++loads_ > limits::kMaxSvgPictures) return skipped("the file has more than 200 pictures");
  return loaded_.emplace(href, load_new(href)).first->second;
}

Result<std::shared_ptr<const PictureData>> SvgPictures::load_new(std::string_view href) {
  if (href.empty()) return skipped("it names no picture");
  if (!svg_same_word(href.substr(0, 5), "data:")) {
    const bool is_address = href.substr(0, href.find('/')).find(':') != std::string_view::npos;
    if (is_address || href.starts_with("//")) {
      return skipped("it is at another address, which is not opened");
    }
    if (href.size() > 4096) return skipped("the name of its file is too long");
    // A query or a fragment is not a part of the name. A file with such a name is written as %3F.
    return load_file(without_percents(href.substr(0, href.find_first_of("?#"))));
  }
  return data_of_uri(href.substr(5)).and_then([this](std::string bytes) {
    return decoded(std::move(bytes));
  });
}

Result<std::shared_ptr<const PictureData>> SvgPictures::decoded(std::string bytes) {
  const auto has_too_many = [] { return skipped("the pictures of the file have too many pixels"); };
  if (!is_png(bytes)) {
    const std::string format(picture_format(bytes));
    const bool is_picture = format.starts_with("a ");
    if (!is_picture || !to_png_) {
      return skipped("it is " + format + (is_picture ? ", which only the window can read" : ""));
    }
    Result<std::string> png = to_png_(bytes, pixels_left_);
    if (!png && png.error().code == ErrorCode::kLimitExceeded) return has_too_many();
    if (!png) return skipped("it is " + format + " that cannot be read");
    bytes = *std::move(png);
  }
  auto data = make_picture_data(std::move(bytes));
  if (!data) return skipped(data.error().message);
  const std::int64_t pixels = std::int64_t{(*data)->width_px} * (*data)->height_px;
  if (pixels > pixels_left_) return has_too_many();
  pixels_left_ -= pixels;
  if (auto checked = PicturePixels::decode(**data); !checked) {
    return skipped(checked.error().message);
  }
  return data;
}

}  // namespace felt
