#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "desktop/canvas/ink_tiles.h"
#include "felt/document/document.h"

namespace felt::desktop {

/// The state of an InkWorker: the scene, the planes with their tiles, and the choice of the next
/// piece of work. Not thread-safe.
class InkTileStore {
 public:
  /// The urgency of the next piece of work.
  enum class Need { kRepair, kMissing, kAround, kNone };

  /// `max_bytes` is the approximate memory limit of all tiles. Tiles of the view are kept even if
  /// they need more memory.
  explicit InkTileStore(std::size_t max_bytes = std::size_t{256} << 20U) : max_bytes_(max_bytes) {}

  void open(const Document& document);
  void apply(const Edit& edit);
  void show(const std::optional<Edit>& preview);
  /// Sets the view. `over` is a plane of the same view that shows only the layers above a given
  /// layer; its tiles are made after those of `plane`.
  void look(const PlaneSpec& plane, const PlaneRect& seen,
            const std::optional<PlaneSpec>& over = {});
  void forget(std::uint64_t plane);

  /// Chooses the work for the next call of work() and returns how urgent it is.
  Need plan();
  /// Makes or repairs the tile that plan() chose. Calls `should_stop` between strokes. The next
  /// call resumes interrupted work unless something else has become more urgent. `order` becomes
  /// TileNews::order.
  void work(std::uint64_t order, const std::function<bool()>& should_stop,
            std::vector<TileNews>& news);
  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] std::size_t tile_count() const noexcept;

 private:
  struct Tile {
    TilePtr picture;
    PixelRect dirty;
    bool is_made = false;
    bool must_finish = false;  // an interrupted attempt became outdated, so the next attempt must
                               // not be interrupted
    std::uint64_t damages = 0;
    std::uint64_t used = 0;
    std::unique_ptr<TileSplit> split;
  };
  struct Plane {
    PlaneSpec spec;
    std::map<TilePlace, Tile> tiles;
  };
  /// A tile whose painting was interrupted.
  struct Begun {
    std::uint64_t plane = 0;
    TilePlace place;
    std::uint64_t damages = 0;
    PixelRect part;
    std::shared_ptr<TilePicture> picture;
    InkJob job;
  };
  struct Choice {
    Need need = Need::kNone;
    std::uint64_t plane = 0;
    TilePlace place;
  };

  void damage(const InkDamage& areas);
  static void damage(Plane& plane, const Rect& area);
  static void damage(Tile& tile, PixelRect part);
  [[nodiscard]] Choice choose() const;
  [[nodiscard]] std::optional<Choice> choose_over() const;
  [[nodiscard]] std::optional<Choice> nearest(const Plane& plane, const PlaneRect& area,
                                              bool only_made) const;
  [[nodiscard]] Begun begin(const Choice& choice, Plane& plane, Tile& tile);
  bool paint(Plane& plane, Tile& tile, Begun& begun, const std::function<bool()>& should_stop);
  void drop_old(std::vector<TileNews>& news);
  void drop_splits();

  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  std::uint64_t uses_ = 0;
  std::unique_ptr<InkScene> scene_ = std::make_unique<InkScene>();
  TilePainter painter_;
  std::map<std::uint64_t, Plane> planes_;
  std::uint64_t current_ = 0;
  std::uint64_t over_ = 0;  // id of the plane `over`, or 0
  PlaneRect seen_;
  Choice choice_;
  std::optional<Begun> begun_;
};

}  // namespace felt::desktop
