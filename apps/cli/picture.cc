#include "picture.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "commands.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_materials.h"
#include "felt/geometry/height_picture.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/io/picture/png.h"
#include "felt/stroke/color_text.h"
#include "known_materials.h"

namespace felt::cli {
namespace {

constexpr double kMaxPageMm = 1e5;

/// The DIN sizes A0 to A6 in mm, upright.
constexpr std::array<Vec, 7> kSizesA = {Vec{841, 1189}, {594, 841}, {420, 594}, {297, 420},
                                        {210, 297},     {148, 210}, {105, 148}};

std::optional<Vec> named_size(std::string_view text) {
  if (text.size() < 2 || (text[0] != 'A' && text[0] != 'a') || text[1] < '0' || text[1] > '6') {
    return std::nullopt;
  }
  const Vec upright = kSizesA[static_cast<std::size_t>(text[1] - '0')];
  if (text.size() == 2) return upright;
  if (text.substr(2) == "-landscape") return Vec{upright.y, upright.x};
  return std::nullopt;
}

std::optional<double> length_mm(std::string_view text) {
  double length = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!(length > 0.0 && length <= kMaxPageMm)) return std::nullopt;
  return length;
}

std::optional<Vec> written_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const std::optional<double> width = length_mm(text.substr(0, cross));
  const std::optional<double> height = length_mm(text.substr(cross + 1));
  if (!width || !height) return std::nullopt;
  return Vec{*width, *height};
}

}  // namespace

void PictureArguments::add_to(CLI::App& command) {
  CLI::Option* in_dpi = command.add_option("--dpi", dpi, "Resolution of a .png in dots per inch")
                            ->check(number_between(1.0, 4800.0))
                            ->capture_default_str()
                            ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_option("--scale", scale,
                  "Resolution of a .png as a factor, instead of --dpi: 1 is 96 dots per inch")
      ->check(number_between(0.1, 50.0))
      ->excludes(in_dpi)
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_option("--page", page,
                  "What to show: 'fit' (all ink and a margin), A0..A6, A4-landscape, or WxH in\n"
                  "mm; default: the drawing's page, or fit if it has none")
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_option("--paper", paper,
                  "Colour behind the ink: #rrggbb, #rrggbbaa, white or transparent; default:\n"
                  "white in a .png, transparent in an .svg")
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_option(
          "--surface", surface,
          "Surface whose grain shows in dry ink of a .png, the same that the hand feels\n"
          "(feltline replay also draws on it, and the page takes its colour):\n" +
              surface_names() +
              "\n(smooth), a custom surface, or a grey NAME.png: white is high, its width is that\n"
              "of its resolution, or 40 mm; default: solid ink. Ink pen and felt-tip are wet and\n"
              "show no grain")
      ->check(not_empty())
      ->group("Pictures (.svg, .pdf, .png)");
}

void PictureArguments::add_grain_to(CLI::App& command) {
  command
      .add_flag(
          "--grain,--grain-mask", grain,
          "Show the grain of the surface in dry ink: that of --surface, otherwise that of the\n"
          "drawing's surface, otherwise that of paper. An .svg or .pdf shows grain only with\n"
          "this option: its strokes stay outlines, masked by a picture of the grain")
      ->group("Pictures (.svg, .pdf, .png)");
  command
      .add_option("--grain-dpi", grain_dpi,
                  "Dots per inch of that picture in an .svg or .pdf, 20 to 1200")
      ->capture_default_str()
      ->check(CLI::Range(GrainPrint::kMinDpi, GrainPrint::kMaxDpi))
      ->group("Pictures (.svg, .pdf, .png)");
}

Result<PictureOptions> PictureArguments::parse(Console& console) const {
  PictureOptions options;
  // If no grain is shown, errors in materials do not matter.
  if (grain || !surface.empty()) options.materials = known_materials(console).materials;
  options.dpi = scale ? *scale * kScreenDpi : dpi;
  options.wants_grain = grain;
  options.grain_dpi = grain_dpi;
  options.has_surface = !surface.empty();
  const Result<std::optional<Rect>> area = parse_page(page);
  if (!area) return tl::unexpected(area.error());
  options.area = *area;
  options.fit = page == "fit";
  if (const Result<void> known = parse_surface(surface, options); !known) {
    return tl::unexpected(known.error());
  }
  if (paper.empty()) return options;
  const Result<Rgba> color = parse_paper(paper);
  if (!color) return tl::unexpected(color.error());
  options.paper = *color;
  return options;
}

Result<std::optional<Rect>> parse_page(const std::string& text) {
  if (text.empty() || text == "fit") return std::nullopt;
  std::optional<Vec> size = named_size(text);
  if (!size) size = written_size(text);
  if (size) return Rect{0.0, 0.0, size->x, size->y};
  return fail(ErrorCode::kInvalidArgument,
              "--page: '" + text +
                  "' is not a page size; use fit, A0..A6, A4-landscape or WxH in mm (at most 1e5)");
}

Result<Page> page_for(const Rect& area, Rgba paper) {
  const auto fits = [](double mm) { return mm >= Page::kMinMm && mm <= Page::kMaxMm; };
  if (fits(area.width()) && fits(area.height())) {
    return Page{area.width(), area.height(), paper};
  }
  return fail(ErrorCode::kInvalidArgument,
              "--page: the page of a drawing must be 10 to 5000 mm wide and high");
}

Result<Rgba> parse_paper(const std::string& text) {
  if (text == "white") return Rgba{255, 255, 255, 255};
  if (text == "transparent") return Rgba{255, 255, 255, 0};
  if (const std::optional<Rgba> color = color_from_text(text)) return *color;
  return fail(
      ErrorCode::kInvalidArgument,
      "--paper: '" + text + "' is not a colour; use #rrggbb, #rrggbbaa, white or transparent");
}

Rgba usual_color(std::uint32_t rgb) noexcept {
  return {static_cast<std::uint8_t>(rgb >> 16U & 0xFFU),
          static_cast<std::uint8_t>(rgb >> 8U & 0xFFU), static_cast<std::uint8_t>(rgb & 0xFFU),
          255};
}

std::string surface_names() {
  std::string names;
  for (const SurfaceMaterial& surface : surface_materials()) {
    const bool is_last = &surface == &surface_materials().back();
    if (!names.empty()) names += is_last ? " or " : ", ";
    names += surface.id;
  }
  return names;
}

Result<void> parse_surface(const std::string& text, PictureOptions& options) {
  if (text.empty()) return {};
  if (!std::string_view(text).ends_with(".png")) {
    const Result<SurfaceMaterial> surface = find_surface(text, options.materials);
    if (!surface) {
      const bool is_file = text.ends_with(".toml");
      return fail(surface.error().code,
                  "--surface: " + surface.error().message +
                      (is_file ? "" : ", and it is not a .png or .toml file"));
    }
    options.relief = surface_grain(*surface);
    options.grain = Grain(options.relief, options.materials);
    return {};
  }
  const Result<HeightPicture> picture = read_height_png(text);
  if (!picture) {
    return fail(ErrorCode::kInvalidData, "--surface: " + picture.error().message);
  }
  HeightPictureSpec spec;
  if (picture->width_mm >= 5.0 && picture->width_mm <= 500.0) spec.tile_mm = picture->width_mm;
  Result<HeightField> field = height_field_of(*picture, spec);
  if (!field) {
    return fail(ErrorCode::kInvalidData, "--surface: " + text + ": " + field.error().message);
  }
  options.custom_relief = std::make_shared<const HeightField>(*std::move(field));
  options.relief = options.custom_relief.get();
  options.grain = Grain(options.relief, options.materials);
  return {};
}

Result<void> use_surface_of(const Drawing& drawing, PictureOptions& options) {
  if (options.has_surface) {
    options.grain = Grain(options.relief, with_texts(drawing.materials, options.materials));
    return {};
  }
  if (!options.wants_grain) {
    options.grain = Grain::solid(with_texts(drawing.materials, options.materials));
    return {};
  }
  const Result<Grain> grain = grain_of(drawing, options.materials);
  if (!grain) {
    return fail(ErrorCode::kNotFound, "--grain: " + grain.error().message +
                                          "; choose another with --surface: " + surface_names());
  }
  options.grain = *grain;
  return {};
}

}  // namespace felt::cli
