#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/io/picture/png.h"
#include "felt/render/image.h"
#include "felt/render/plot_canvas.h"
#include "felt/render/view.h"
#include "felt/stroke/arc_map.h"

namespace felt::bench {
namespace {

// Sizes in units of the plot. A unit is `kScale` pixels.
constexpr double kScale = 2.0, kCell = 150.0, kHeight = 120.0, kTop = 34.0, kLeft = 8.0;

constexpr Rgba kPaper{255, 255, 255, 255}, kInk{20, 20, 20, 255}, kOld{190, 190, 190, 255},
    kNew{0, 90, 170, 255}, kPen{213, 60, 0, 255}, kRule{230, 230, 230, 255};

/// A cell of the picture, which maps the page to plot units.
struct Frame {
  double x = 0.0, y = 0.0;  // top left corner
  Point middle;
  double per_mm = 1.0;
  [[nodiscard]] Vec at(Point p) const {
    return Vec{x + 0.5 * kCell, y + 0.5 * kHeight} + per_mm * (p - middle);
  }
};

std::vector<Vec> line_of(const StrokeData& data, const Frame& frame) {
  constexpr int kChords = 48;
  std::vector<Vec> line{frame.at(data.points.front())};
  for (std::size_t i = 0; 3 * i + 3 < data.points.size(); ++i) {
    const Point* p = &data.points[3 * i];
    const Cubic c{{p[0], p[1], p[2], p[3]}};
    for (int k = 1; k <= kChords; ++k) line.push_back(frame.at(evaluate(c, k / double{kChords})));
  }
  return line;
}

/// Returns the frame around the grab that contains most of the change.
Frame frame_of(const Pull& pull, double radius_mm) {
  const Point from = pull.stroke->position(pull.u);
  const double half = std::max(1.35 * radius_mm, 1.3 * norm(pull.way));
  return {.middle = from + 0.5 * pull.way, .per_mm = 0.5 * kHeight / half};
}

/// Draws ticks across the old line at the ends of the intended span.
void draw_span(PlotCanvas& canvas, const Pull& pull, const Frame& frame, double radius_mm) {
  const ArcMap map(*pull.stroke);
  const double at = map.length_at(pull.u);
  for (const double side : {-radius_mm, radius_mm}) {
    const double s = at + side;
    if (!pull.stroke->closed() && (s < 0.0 || s > map.length_mm())) continue;
    const double u = map.u_at(s);
    const int i = std::min(static_cast<int>(u), pull.stroke->segment_count() - 1);
    const Vec across = 4.0 * perp(tangent(pull.stroke->segment(i), u - i));
    const Vec middle = frame.at(pull.stroke->position(u));
    canvas.line(middle - across, middle + across, {.width = 1.0, .color = kInk});
  }
}

void draw_cell(PlotCanvas& canvas, Method method, const Pull& pull, const Frame& frame,
               double radius_mm) {
  canvas.clip(frame.x + 1.0, frame.y + 1.0, frame.x + kCell - 1.0, frame.y + kHeight - 1.0);
  canvas.polyline(line_of(pull.stroke->data(), frame), {.width = 1.6, .color = kOld});
  draw_span(canvas, pull, frame, radius_mm);
  const Result<StrokeData> now = pulled(method, pull, radius_mm);
  if (now) {
    canvas.polyline(line_of(*now, frame), {.width = 1.6, .color = kNew});
  } else {
    canvas.text({frame.x + 8.0, frame.y + kHeight - 8.0}, "refused", {.size = 7.0, .color = kPen});
  }
  const Vec from = frame.at(pull.stroke->position(pull.u));
  const Vec to = frame.at(pull.stroke->position(pull.u) + pull.way);
  canvas.line(from, to, {.width = 0.8, .color = kPen, .on = 3.0, .off = 2.0});
  for (const double size : {2.5}) {
    canvas.rectangle(to.x - size, to.y - size, to.x + size, to.y + size, kPen);
  }
  canvas.clip_nothing();
}

}  // namespace

Result<void> write_picture(const std::string& path, std::span<const Pull> pulls, double radius_mm) {
  const double width = 2.0 * kLeft + kCell * static_cast<double>(kMethods.size());
  const double height = kTop + kHeight * static_cast<double>(pulls.size()) + kLeft;
  Result<Image> image =
      Image::create(static_cast<int>(kScale * width), static_cast<int>(kScale * height));
  if (!image) return tl::unexpected(image.error());
  fill(image->pixels(), image->pixels().rect(), kPaper);
  {
    PlotCanvas canvas(image->pixels(), kScale);
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      const double x = kLeft + kCell * static_cast<double>(m);
      canvas.text({x + 0.5 * kCell, kTop - 12.0}, name_of(kMethods[m]),
                  {.size = 9.0, .color = kInk, .align = PlotAlign::kCenter});
      for (std::size_t k = 0; k < pulls.size(); ++k) {
        Frame frame = frame_of(pulls[k], radius_mm);
        frame.x = x;
        frame.y = kTop + kHeight * static_cast<double>(k);
        canvas.line({x, frame.y}, {x + kCell, frame.y}, {.width = 0.7, .color = kRule});
        if (m > 0)
          canvas.line({x, frame.y}, {x, frame.y + kHeight}, {.width = 0.7, .color = kRule});
        draw_cell(canvas, kMethods[m], pulls[k], frame, radius_mm);
      }
    }
  }
  return write_png(path, *image, kScale * 72.0);
}

}  // namespace felt::bench
