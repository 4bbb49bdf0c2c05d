#include "felt/store/felt_page.h"

#include <cmath>
#include <limits>
#include <utility>

#include "felt/base/utf8.h"

namespace felt {
namespace {

bool is_palette_text(std::string_view text) {
  return text.size() <= PaletteLimits::kMaxNameBytes && is_utf8(text);
}

bool is_view(const Viewport& v) noexcept {
  const auto within = [](double value, double smallest, double largest) {
    return value >= smallest && value <= largest;  // false for NaN
  };
  return within(v.center.x, -Viewport::kMaxMm, Viewport::kMaxMm) &&
         within(v.center.y, -Viewport::kMaxMm, Viewport::kMaxMm) &&
         within(v.px_per_mm, Viewport::kMinPxPerMm, Viewport::kMaxPxPerMm) &&
         within(v.angle_deg, -180.0, 180.0);
}

Result<void> read_palette(const Database& db, Palette& palette) {
  const auto row = db.prepare("SELECT id, color, name FROM palette");
  if (!row) return tl::unexpected(row.error());
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    if (palette.colors.size() == PaletteLimits::kMaxColors) {
      return fail(ErrorCode::kLimitExceeded, "has more than 10000 colours in its palette");
    }
    if (row->integer(0) != std::int64_t(palette.colors.size()) + 1 || !row->is_integer(1) ||
        !is_color_number(row->integer(1)) || !row->is_text(2)) {
      return invalid_data("the palette contains an invalid value");
    }
    palette.colors.push_back({color_of(row->integer(1)), std::string(row->text(2))});
  }
}

Result<void> read_view(const Database& db, std::optional<Viewport>& view) {
  const auto row = db.prepare(
      "SELECT center_x_mm, center_y_mm, px_per_mm, angle_deg, mirrored FROM shown LIMIT 2");
  if (!row) return tl::unexpected(row.error());
  const Result<bool> any = row->step();
  if (!any) return tl::unexpected(any.error());
  if (!*any) return {};
  for (const int column : {0, 1, 2, 3}) {
    if (!row->is_real(column)) return invalid_data("the table 'shown' lacks a required number");
  }
  if (!row->is_integer(4) || (row->integer(4) | 1) != 1) {
    return invalid_data("the table 'shown' contains an invalid value");
  }
  view = Viewport{{row->real(0), row->real(1)}, row->real(2), row->real(3), row->integer(4) != 0};
  const Result<bool> more = row->step();
  if (!more) return tl::unexpected(more.error());
  if (*more) return invalid_data("the table 'shown' has more than one row");
  return {};
}

}  // namespace

std::int64_t number_of(Rgba c) noexcept {
  return std::int64_t{c.r} << 24 | std::int64_t{c.g} << 16 | std::int64_t{c.b} << 8 | c.a;
}

Rgba color_of(std::int64_t n) noexcept {
  const auto byte = [n](int shift) { return static_cast<std::uint8_t>((n >> shift) & 0xff); };
  return {byte(24), byte(16), byte(8), byte(0)};
}

bool is_color_number(std::int64_t n) noexcept {
  return n >= 0 && n <= std::numeric_limits<std::uint32_t>::max();
}

Result<void> write_page(const Database& db, const Drawing& drawing) {
  const auto color = db.prepare("INSERT INTO palette VALUES(?,?,?)");
  if (!color) return tl::unexpected(color.error());
  std::int64_t id = 0;
  for (const NamedColor& entry : drawing.palette.colors) {
    color->bind(1, ++id);
    color->bind(2, number_of(entry.color));
    color->bind_text(3, entry.name);
    if (auto done = color->step(); !done) return tl::unexpected(done.error());
    color->reset();
  }
  if (!drawing.view) return {};
  const auto row = db.prepare("INSERT INTO shown VALUES(1,?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  row->bind(1, drawing.view->center.x);
  row->bind(2, drawing.view->center.y);
  row->bind(3, drawing.view->px_per_mm);
  row->bind(4, drawing.view->angle_deg);
  row->bind(5, std::int64_t{drawing.view->mirrored});
  return row->step().map([](bool) {});
}

Result<void> read_page(const Database& db, Drawing& drawing) {
  return read_palette(db, drawing.palette).and_then([&] { return read_view(db, drawing.view); });
}

Result<void> check_page(const Drawing& drawing) {
  const Palette& palette = drawing.palette;
  if (!is_palette_text(palette.name) || palette.columns > PaletteLimits::kMaxColumns) {
    return invalid_data("the palette has an invalid name or number of columns");
  }
  if (palette.colors.size() > PaletteLimits::kMaxColors) {
    return fail(ErrorCode::kLimitExceeded, "has more than 10000 colours in its palette");
  }
  for (const NamedColor& entry : palette.colors) {
    if (!is_palette_text(entry.name))
      return invalid_data("a colour of the palette has an invalid name");
  }
  if (drawing.view && !is_view(*drawing.view)) return invalid_data("its view is invalid");
  return {};
}

void append_page_bytes(ByteWriter& out, const Drawing& drawing) {
  out.text(drawing.palette.name);
  out.u32(static_cast<std::uint32_t>(drawing.palette.columns));
  out.u32(static_cast<std::uint32_t>(drawing.palette.colors.size()));
  for (const NamedColor& entry : drawing.palette.colors) {
    out.u32(static_cast<std::uint32_t>(number_of(entry.color)));
    out.text(entry.name);
  }
  out.u8(drawing.view ? 1 : 0);
  if (!drawing.view) return;
  out.f64(drawing.view->center.x);
  out.f64(drawing.view->center.y);
  out.f64(drawing.view->px_per_mm);
  out.f64(drawing.view->angle_deg);
  out.u8(drawing.view->mirrored ? 1 : 0);
}

}  // namespace felt
