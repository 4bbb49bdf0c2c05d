#include "gather_drawing.h"

#include <algorithm>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/gather/line_groups.h"

namespace felt::cli {
namespace {

/// Gathers the layers of a document, one after the other.
class LayerGatherer {
 public:
  LayerGatherer(const Drawing& drawing, const GatherOptions& options)
      : drawing_(drawing),
        document_(drawing.document),
        options_(options),
        edit_(drawing.document) {}

  Result<void> gather(const Layer& layer);
  [[nodiscard]] Edit edit() && { return std::move(edit_).build("Gather"); }
  [[nodiscard]] std::vector<StrokeGroup> groups() && { return std::move(groups_); }

 private:
  Result<void> press(const std::vector<StrokeId>& members);

  const Drawing& drawing_;
  const Document& document_;
  GatherOptions options_;
  EditBuilder edit_;
  std::vector<StrokeGroup> groups_;
  std::uint32_t first_group_ = 1;
};

Result<void> LayerGatherer::press(const std::vector<StrokeId>& members) {
  if (members.size() < 2) return {};
  std::vector<StrokePtr> strokes;
  for (const StrokeId id : members) strokes.push_back(document_.find(id));
  Result<Stroke> gathered = gathered_stroke(strokes, options_);
  if (!gathered) return tl::unexpected(gathered.error());
  edit_.replace(members.front(), std::make_shared<const Stroke>(*std::move(gathered)));
  for (std::size_t i = 1; i < members.size(); ++i) edit_.remove(members[i]);
  return {};
}

Result<void> LayerGatherer::gather(const Layer& layer) {
  std::vector<RoughLine> lines;
  std::vector<StrokePtr> strokes;
  for (const StrokeId id : layer.strokes) {
    strokes.push_back(document_.find(id));
    lines.push_back(rough_line(*strokes.back()));
  }
  const Result<std::vector<std::uint32_t>> groups =
      line_groups(lines, {.ink_mm = usual_width_mm(strokes)});
  if (!groups) return tl::unexpected(groups.error());
  if (groups->empty()) return {};
  std::vector<std::vector<StrokeId>> members(*std::max_element(groups->begin(), groups->end()) + 1);
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    const std::uint32_t group = (*groups)[i];
    members[group].push_back(layer.strokes[i]);
    groups_.push_back({name_in_file(drawing_, layer.strokes[i]), first_group_ + group});
  }
  first_group_ += static_cast<std::uint32_t>(members.size());
  for (const std::vector<StrokeId>& group : members) {
    if (Result<void> pressed = press(group); !pressed) return pressed;
  }
  return {};
}

}  // namespace

Result<GatheredDrawing> gather_drawing(Drawing& drawing, const GatherOptions& options) {
  LayerGatherer gatherer(drawing, options);
  std::size_t left_alone = 0;
  for (const Layer& layer : drawing.document.layers()) {
    if (layer.locked || !layer.visible) {
      left_alone += layer.strokes.size();
      continue;
    }
    if (Result<void> done = gatherer.gather(layer); !done) return tl::unexpected(done.error());
  }
  std::vector<StrokeGroup> groups = std::move(gatherer).groups();
  if (Result<void> applied = drawing.document.apply(std::move(gatherer).edit()); !applied) {
    return tl::unexpected(applied.error());
  }
  return GatheredDrawing{std::move(groups), left_alone};
}

}  // namespace felt::cli
