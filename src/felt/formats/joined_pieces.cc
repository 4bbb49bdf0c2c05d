#include "felt/formats/joined_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/document/symmetry_group.h"
#include "felt/io/ink_of_points.h"
#include "felt/stroke/edit/corner_trips.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

constexpr double kMeetMm = 0.02;  // files round coordinates
constexpr double kWidthToleranceMm = 0.005;
constexpr int kPointsPerPiece = 8;  // of a piece that is not straight; even

/// Returns true if the stroke is one curve of constant width and has no tone of its own.
bool is_piece(const Stroke& stroke) {
  const auto widths = stroke.widths();
  return stroke.segment_count() == 1 && !stroke.closed() && !has_own_tone(widths) &&
         std::all_of(widths.begin(), widths.end(), [&](const WidthKnot& knot) {
           return knot.width_mm == widths.front().width_mm;
         });
}

bool follows(const Stroke& before, const Stroke& after) {
  return distance(before.position(1.0), after.position(0.0)) <= kMeetMm &&
         before.color() == after.color() && before.medium() == after.medium();
}

bool is_line(const Cubic& c) {
  const Vec along = normalized(c.p[3] - c.p[0]);
  return std::max(std::fabs(cross(along, c.p[1] - c.p[0])),
                  std::fabs(cross(along, c.p[2] - c.p[0]))) < 1e-6;
}

/// Returns the points of pieces that follow each other. In the middle of each piece, the line has
/// its width; in between, the width changes linearly.
std::vector<WidePoint> line_of(const std::vector<StrokePtr>& pieces) {
  std::vector<WidePoint> line{{pieces.front()->position(0.0), pieces.front()->width_mm(0.0)}};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Stroke& piece = *pieces[i];
    const double own_mm = piece.width_mm(0.5);
    const double before_mm = i > 0 ? pieces[i - 1]->width_mm(0.5) : own_mm;
    const double next_mm = i + 1 < pieces.size() ? pieces[i + 1]->width_mm(0.5) : own_mm;
    const int step = is_line(piece.segment(0)) ? kPointsPerPiece / 2 : 1;
    for (int k = step; k <= kPointsPerPiece; k += step) {
      const double t = static_cast<double>(k) / kPointsPerPiece;
      const double width_mm =
          t < 0.5 ? std::lerp(before_mm, own_mm, 0.5 + t) : std::lerp(own_mm, next_mm, t - 0.5);
      line.push_back({piece.position(t), width_mm});
    }
  }
  return line;
}

/// Returns the strokes that other objects of the document refer to by their parameters.
std::set<StrokeId> referred_strokes(const Document& document) {
  std::set<StrokeId> referred;
  for (const Layer& layer : document.layers()) {
    for (const FillId id : layer.fills) {
      for (const FillLoop& loop : document.find_fill(id)->loops) {
        for (const FillPiece& piece : loop.pieces) referred.insert(piece.stroke);
      }
    }
    if (!layer.timing) continue;
    for (const KeyPair& pair : layer.timing->pairs) {
      referred.insert(pair.from);
      referred.insert(pair.to);
    }
  }
  for (const auto& [id, group] : document.symmetries()) {
    for (const SymmetryImage& image : group->images) referred.insert(image.stroke);
  }
  return referred;
}

/// Joins the pieces of a document.
class Joiner {
 public:
  explicit Joiner(const Document& document)
      : document_(document),
        edit_(document),
        referred_(referred_strokes(document)),
        ink_({}, kWidthToleranceMm) {}

  Result<void> add(const Layer& layer) {
    for (const StrokeId id : layer.strokes) {
      StrokePtr stroke = document_.find(id);
      if (std::optional<Stroke> plain = without_corner_trips(*stroke)) {
        stroke = std::make_shared<const Stroke>(*std::move(plain));
      }
      const bool is_next = is_piece(*stroke) && !referred_.contains(id);
      if (!is_next || pieces_.empty() || !follows(*pieces_.back(), *stroke)) {
        if (Result<void> done = finish(); !done) return done;
      }
      if (!is_next) continue;
      ids_.push_back(id);
      pieces_.push_back(std::move(stroke));
    }
    return finish();
  }
  [[nodiscard]] std::size_t joined() const { return joined_; }
  [[nodiscard]] Edit edit() && { return std::move(edit_).build("Join"); }

 private:
  /// Replaces the collected pieces by one stroke.
  Result<void> finish() {
    const std::vector<StrokeId> ids = std::exchange(ids_, {});
    const std::vector<StrokePtr> pieces = std::exchange(pieces_, {});
    if (ids.size() < 2) return {};
    Result<StrokeData> data = ink_.of_line(line_of(pieces));
    if (!data) return tl::unexpected(data.error());
    data->color = pieces.front()->color();
    data->medium = pieces.front()->medium();
    Result<Stroke> stroke = Stroke::create(*std::move(data));
    if (!stroke) return tl::unexpected(stroke.error());
    edit_.replace(ids.front(), std::make_shared<const Stroke>(*std::move(stroke)));
    for (std::size_t i = 1; i < ids.size(); ++i) edit_.remove(ids[i]);
    joined_ += ids.size();
    return {};
  }

  const Document& document_;
  EditBuilder edit_;
  std::set<StrokeId> referred_;
  InkOfPoints ink_;
  std::vector<StrokeId> ids_;
  std::vector<StrokePtr> pieces_;
  std::size_t joined_ = 0;
};

}  // namespace

Result<std::size_t> join_pieces(Drawing& drawing) {
  Joiner joiner(drawing.document);
  for (const Layer& layer : drawing.document.layers()) {
    if (Result<void> added = joiner.add(layer); !added) return tl::unexpected(added.error());
  }
  const std::size_t joined = joiner.joined();
  if (Result<void> applied = drawing.document.apply(std::move(joiner).edit()); !applied) {
    return tl::unexpected(applied.error());
  }
  return joined;
}

}  // namespace felt
