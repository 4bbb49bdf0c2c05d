#include "felt/io/drawing_parts.h"

#include <cmath>
#include <utility>

#include "felt/io/unpack.h"

namespace felt {
namespace {

class GzipParts final : public DrawingParts {
 public:
  explicit GzipParts(std::unique_ptr<DrawingParts> text) : text_(std::move(text)) {}

  [[nodiscard]] std::size_t count() const override { return text_->count(); }
  [[nodiscard]] bool any_order() const override { return text_->any_order(); }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    DrawingPart text;
    if (auto ok = text_->make(i, text); !ok) return ok;
    out.clear();
    if (i == 0) out.bytes = gzip_head();
    append_deflated(out.bytes, text.bytes);
    out.raw_bytes = text.bytes.size();
    out.checksum = crc32_of(text.bytes);
    return {};
  }

  void add(const DrawingPart& part) override {
    checksum_ = crc32_joined(checksum_, part.checksum, part.raw_bytes);
    raw_bytes_ += part.raw_bytes;
  }

  std::string tail() override {
    const std::string text = text_->tail();
    DrawingPart last;
    append_deflated(last.bytes, text);
    last.raw_bytes = text.size();
    last.checksum = crc32_of(text);
    add(last);
    append_deflate_end(last.bytes);
    append_gzip_tail(last.bytes, checksum_, raw_bytes_);
    return std::move(last.bytes);
  }

 private:
  std::unique_ptr<DrawingParts> text_;
  std::uint32_t checksum_ = 0;
  std::uint64_t raw_bytes_ = 0;
};

}  // namespace

Result<void> write_parts(DrawingParts& parts, const ByteSink& sink) {
  DrawingPart part;
  for (std::size_t i = 0; i < parts.count(); ++i) {
    if (auto ok = parts.make(i, part); !ok) return ok;
    parts.add(part);
    if (auto ok = sink(part.bytes); !ok) return ok;
  }
  return sink(parts.tail());
}

Result<std::string> bytes_of(DrawingParts& parts) {
  std::string all;
  const Result<void> done = write_parts(parts, [&all](std::string_view bytes) -> Result<void> {
    all += bytes;
    return {};
  });
  if (!done) return tl::unexpected(done.error());
  return all;
}

std::vector<StrokeRange> stroke_ranges(const Document& document, LayerChoice layers) {
  std::vector<StrokeRange> ranges;
  std::size_t before = 0;
  for (std::size_t l = 0; l < document.layers().size(); ++l) {
    const Layer& layer = document.layers()[l];
    if (layers == LayerChoice::kVisible && !layer.visible) continue;
    std::size_t first = 0, points = 0;
    for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
      const std::size_t more = document.find(layer.strokes[i])->data().points.size();
      if (i > first && (i - first == kPartStrokes || points + more > kPartPoints)) {
        ranges.push_back({l, first, i, before + first});
        first = i;
        points = 0;
      }
      points += more;
    }
    ranges.push_back({l, first, layer.strokes.size(), before + first});
    before += layer.strokes.size();
  }
  return ranges;
}

Rect picture_area(const Rect& ink, const std::optional<Rect>& page, double margin_mm) noexcept {
  if (page) return *page;
  const Rect area = (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(margin_mm);
  return {std::floor(area.x0 * 100.0) / 100.0, std::floor(area.y0 * 100.0) / 100.0,
          std::ceil(area.x1 * 100.0) / 100.0, std::ceil(area.y1 * 100.0) / 100.0};
}

std::unique_ptr<DrawingParts> gzip_parts(std::unique_ptr<DrawingParts> text) {
  return std::make_unique<GzipParts>(std::move(text));
}

}  // namespace felt
