/// Applies any edits to the bodies of two outlines, a ball and a ring. Every body must stay closed,
/// and every edit must be applied or refused with a sentence.

#include <cstdint>
#include <vector>

#include "felt/base/check.h"
#include "felt/solid/body_edits.h"
#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt {
namespace {

constexpr std::size_t kMaxEdits = 4, kMaxPathPoints = 60;

/// Reads numbers from the input. After its end, all bytes are 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool empty() const { return at_ >= size_; }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : data_[at_++]; }
  /// A coordinate, -64..64 mm, in steps of a half.
  double coordinate() { return 0.5 * static_cast<std::int8_t>(byte()); }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

std::vector<Vec3> take_path(Bytes& in) {
  std::vector<Vec3> path;
  const std::size_t count = in.byte() % kMaxPathPoints;
  for (std::size_t i = 0; i < count && !in.empty(); ++i) {
    const double x = in.coordinate(), y = in.coordinate();
    path.push_back({x, y, in.coordinate()});
  }
  return path;
}

/// Reads an edit. It has the invariants of check_body_edit().
std::optional<BodyEdit> take_edit(Bytes& in) {
  BodyEdit edit;
  edit.kind = static_cast<BodyEditKind>(in.byte() % 4);
  const Vec3 view{in.coordinate(), in.coordinate(), in.coordinate()};
  if (norm(view) > 0.0) edit.view = (1.0 / norm(view)) * view;
  edit.width_mm = 0.25 * in.byte();
  edit.amount = in.byte() / 255.0;
  edit.path_mm = take_path(in);
  if (edit.kind == BodyEditKind::kExtrude) edit.profile_mm = take_path(in);
  return check_body_edit(edit) ? std::optional(edit) : std::nullopt;
}

Solid ball_and_ring() {
  testing::SolidDrawing drawing;
  drawing.circle({-30, 0}, 20.0);
  drawing.circle({30, 0}, 25.0);
  drawing.circle({30, 0}, 10.0);
  const Result<InflatedDrawing> inflated = inflate(drawing.document, {.triangles = 300});
  FELT_CHECK(inflated.has_value());
  return inflated->solid;
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  static const Solid solid = ball_and_ring();
  Bytes in(data, size);
  std::vector<BodyEdit> edits;
  while (!in.empty() && edits.size() < kMaxEdits) {
    if (const std::optional<BodyEdit> edit = take_edit(in)) edits.push_back(*edit);
  }
  const EditedSolid edited = apply_body_edits(solid, edits);
  FELT_CHECK(edited.refusals.size() == edits.size());
  for (const SolidBody& body : edited.solid.bodies) {
    FELT_CHECK(check_body(body, edited.solid.origin).has_value());
    FELT_CHECK(body.paint.empty() || body.paint.size() == body.points.size());
    FELT_CHECK(volume_mm3(body) > 0.0);
  }
  return 0;
}
