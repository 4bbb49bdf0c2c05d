#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/drawing_builder.h"
#include "felt/io/import.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_pictures.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/io/svg/svg_sharp_line.h"

namespace felt {

/// Layer for content that is in no layer of the file.
inline constexpr const char* kSvgLayerName = "Ink";

/// Converts a scene to ink: the second step of reading SVG. Pass an SvgInk to read_svg_scene(),
/// then call take().
class SvgInk final : public SvgSceneSink {
 public:
  /// Maximum number of layers that are added so that a fill covers the lines painted before it, or
  /// so that a group is transparent as a whole.
  static constexpr int kMaxCoverLayers = 200;

  explicit SvgInk(const ImportOptions& options = {}) : pictures_(options) {}

  void root(const SvgRoot& root) override;
  void layer(const SvgLayer& layer) override;
  void shape(SvgShape shape) override;
  void image(const SvgImage& image) override;
  void paper(Rgba color) override;
  void end() override;
  void notice(std::int64_t line, std::string element, std::string what) override;

  /// Returns the drawing and the report. Call it once.
  Imported take();

 private:
  /// The transparent group of the last shape. Its shapes wait until two of them overlap. Then the
  /// group becomes a layer of its own; otherwise its shapes become transparent one by one.
  struct Group {
    std::size_t number = 0;  ///< 0: no group
    double opacity = 1.0;
    std::vector<SvgShape> waiting{};
    std::vector<Rect> boxes{};
    bool has_layer = false;
  };
  static constexpr std::size_t kMaxWaiting = 1000;

  void say(const SvgShape& shape, std::string what);
  void begin_layer(const SvgLayer& layer);
  void add_layer(LayerState state);
  void ready_layer();
  void add_shape(SvgShape shape);
  bool overlaps_group(const SvgShape& shape);
  void begin_group_layer();
  void end_group();
  bool add_picture(const SvgImage& image, LayerPicturePtr picture);
  static void set_page_around_ink(Drawing& drawing);
  /// Returns true if the frame of a shape hides it. Resets the frame if it hides nothing of it.
  bool outside_frame(SvgShape& shape);
  bool take_as_paper(const SvgShape& shape);
  bool add_wide(const SvgShape& shape);
  void add_line(SvgShape& shape);
  void add_fill(const SvgShape& shape);
  void begin_cover_layer(const SvgShape& shape, const Rect& box);
  void add_contour(const SvgShape& shape, SvgContour contour, Rgba color, double width);
  void add_part(const SvgShape& shape, SvgContour moved, Rgba color, double width);
  void add_moved(const SvgShape& shape, SvgContour moved, Rgba color, double width);
  void notice_ends(const SvgShape& shape);
  /// Adds a stroke. If `is_written`, it has the names that Feltline wrote.
  void push(const SvgShape& shape, StrokeData data, bool is_written);

  DrawingBuilder builder_;
  ImportReport report_;
  std::size_t dashes_left_ = limits::kMaxSvgDashes;
  SvgPictures pictures_;
  Group group_;
  LayerState layer_state_;       ///< of the layer of the file
  LayerState top_state_;         ///< of the layer that was added last
  std::vector<Rect> layer_ink_;  ///< bounds of the strokes in that layer
  bool top_is_empty_ = false;    ///< that layer has no strokes, fills or picture yet
  bool needs_layer_ = false;     ///< what follows must not be in that layer
  bool has_size_ = true;         ///< the file says how large it is
  int cover_layers_ = 0;
  std::optional<SvgSharpForm> sharp_;  ///< of the line of the current shape
  bool has_part_ = false;              ///< a stroke of the current shape was already added
  bool is_ours_ = false;
  bool has_page_attribute_ = false;
  bool may_be_paper_ = true;  ///< only the lowest shape can be the paper
};

/// Returns `text` as a valid name: characters that XML cannot hold are replaced, and it is
/// truncated to limits::kMaxNameBytes.
std::string svg_clean_name(std::string_view text);

}  // namespace felt
