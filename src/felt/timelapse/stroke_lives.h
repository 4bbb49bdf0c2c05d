#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/fill.h"

namespace felt {

/// A time in which a shape was seen, in DrawingTime.
struct SeenTime {
  std::int64_t from_ns = 0;
  std::optional<std::int64_t> to_ns{};  ///< when it was gone; nullopt: seen at the end
};

/// One shape of a stroke or of a fill, and when it was seen, in DrawingTime.
struct ShapeLife {
  std::variant<StrokePtr, FillPtr> shape;
  std::uint64_t id = 0;  ///< of the stroke or fill
  LayerId layer;
  /// When the pen began to draw it; the beginning of the first time if it was not drawn.
  std::int64_t drawn_from_ns = 0;
  /// In order; at least one. Only the last one may be open. In the first one it is complete.
  std::vector<SeenTime> times;
};

/// Collects the shapes of all strokes and fills that are visible at any time of a session.
class StrokeLives {
 public:
  /// Call first, if the session does not begin with an empty document.
  void see_start(const Document& document);
  /// Call when other layers have come into view, with Session::seen().
  void see_view(const Document& seen, std::int64_t now_ns);
  /// Call after each edit with the document as it is seen after it. `drawn_from_ns` is the time at
  /// which the pen began to draw the strokes that the edit adds; nullopt if it did not draw them.
  void see(const Edit& edit, const Document& document, std::int64_t now_ns,
           std::optional<std::int64_t> drawn_from_ns);

  /// Returns all shapes in the order in which they were seen first. A shape that is seen again in
  /// the same layer, as by switching layers or by undo, has one life with several times.
  [[nodiscard]] const std::vector<ShapeLife>& all() const noexcept { return lives_; }

 private:
  template <class Id, class Ptr>
  void see_shape(std::map<Id, std::size_t>& seen, Id id, const Ptr& shape, const Layer* layer,
                 std::int64_t now_ns, std::int64_t drawn_from_ns);
  void see_layer(const Layer& layer, const Document& document, std::int64_t now_ns);
  void see_layers(const Edit& edit, const Document& document, std::int64_t now_ns);

  std::vector<ShapeLife> lives_;
  std::map<StrokeId, std::size_t> strokes_;  // the lives of those that are seen now
  std::map<FillId, std::size_t> fills_;
  // The lives of all shapes. They keep the shapes, so that no address is used again.
  std::map<std::pair<LayerId, const void*>, std::vector<std::size_t>> known_;
};

}  // namespace felt
