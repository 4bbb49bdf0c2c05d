// Nothing is lost in silence: what a written file does not give back is what lost_objects() counts.
#include "felt/formats/lost_objects.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "felt/document/testing/random_document.h"
#include "felt/document/testing/small_picture.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/import.h"

namespace felt::lost_objects_test {
namespace {

/// Returns a drawing that may have objects of every kind.
Drawing drawing_with_everything(std::uint64_t seed) {
  Drawing drawing;
  testing::RandomEdits edits(seed);
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  }
  testing::RandomStroke random(seed + 9);
  Edit edit{"Look", {}, {}};
  std::size_t index = 0;
  std::map<GroupId, LayerGroupPtr> groups;
  for (const Layer& layer : drawing.document.layers()) {
    LayerState state = layer.state();
    if (random.chance(0.5)) state.opacity = 0.5;
    state.visible = random.chance(0.7);
    state.locked = random.chance(0.3);
    if (random.chance(0.3)) state.blend = BlendMode::kMultiply;
    if (random.chance(0.3)) state.picture = testing::red_blue_picture(10.0, 10.0);
    if (state.group) {
      LayerGroupPtr& group = groups[state.group->id];
      if (!group) {
        LayerGroup changed = *state.group;
        if (random.chance(0.5)) changed.opacity = 0.25;
        group = std::make_shared<const LayerGroup>(std::move(changed));
      }
      state.group = group;
    }
    edit.layers.push_back({layer.id, layer.state(), std::move(state), index, index});
    ++index;
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  StrokeNames names;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (random.chance(0.4)) names[id] = (random.chance(0.5) ? "a-" : "\x01") + stroke_name(id);
    }
  }
  drawing.names = std::make_shared<const StrokeNames>(std::move(names));
  if (random.chance(0.5)) drawing.materials = {"kind = \"surface\"\nid = \"my-paper\"\n"};
  return drawing;
}

/// The numbers of objects that a drawing has.
struct Objects {
  explicit Objects(const Drawing& drawing) {
    const Document& document = drawing.document;
    strokes = document.stroke_count();
    fills = document.fill_count();
    guides = document.guides().size();
    symmetries = document.symmetries().size();
    body_edits = document.body_edits().size();
    materials = drawing.materials.size();
    names = used_names(drawing).size();
    std::set<GroupId> seen;
    for (const Layer& layer : document.layers()) {
      pictures += layer.picture ? 1 : 0;
      timings += layer.timing ? 1 : 0;
      blends += layer.blend == BlendMode::kNormal ? 0 : 1;
      opacities += layer.opacity < 1.0 ? 1 : 0;
      locks += layer.locked ? 1 : 0;
      if (!layer.visible) hidden += layer.strokes.size();
      for (const StrokeId id : layer.strokes) {
        media += document.find(id)->medium() == kSolidMedium ? 0 : 1;
      }
      if (!layer.group || !seen.insert(layer.group->id).second) continue;
      ++groups;
      blends += layer.group->blend == BlendMode::kNormal ? 0 : 1;
      opacities += layer.group->opacity < 1.0 ? 1 : 0;
    }
  }
  std::size_t strokes = 0, fills = 0, pictures = 0, blends = 0, groups = 0, timings = 0;
  std::size_t body_edits = 0, guides = 0, symmetries = 0, opacities = 0, locks = 0, hidden = 0;
  std::size_t media = 0, materials = 0, names = 0;
};

/// Returns the drawing without its hidden layers, as a format without layers sees it.
Drawing visible_part(const Drawing& drawing) {
  Drawing part = drawing;
  Edit edit{"Remove", {}, {}};
  std::size_t index = 0;
  for (const Layer& layer : drawing.document.layers()) {
    if (!layer.visible) {
      edit.layers.push_back({layer.id, layer.state(), std::nullopt, index, 0});
      for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
        edit.changes.push_back({layer.strokes[i],
                                drawing.document.find(layer.strokes[i]),
                                nullptr,
                                {layer.id, i},
                                {}});
      }
      for (std::size_t i = 0; i < layer.fills.size(); ++i) {
        edit.fills.push_back({layer.fills[i],
                              drawing.document.find_fill(layer.fills[i]),
                              nullptr,
                              {layer.id, i},
                              {}});
      }
    }
    ++index;
  }
  return part.document.apply(edit) ? part : drawing;
}

RC_GTEST_PROP(LostObjects, R66_AreExactlyThoseThatAreNotReadBack, ()) {
  const Drawing drawing = drawing_with_everything(*rc::gen::arbitrary<std::uint64_t>());
  const bool has_visible =
      std::any_of(drawing.document.layers().begin(), drawing.document.layers().end(),
                  [](const Layer& layer) { return layer.visible; });
  RC_PRE(has_visible);
  for (const FormatTraits& traits : format_table()) {
    if (!traits.writes || !traits.reads) continue;
    const auto bytes =
        drawing_bytes(drawing, traits.format, {.dpi = 72.0, .pictures = PictureChoice::kAll});
    RC_ASSERT(bytes.has_value());
    if (bytes->empty()) continue;  // lines of no stroke
    const auto back = parse_drawing(*bytes, "file" + std::string(traits.endings.front()));
    if (!back) RC_FAIL(std::string(traits.name) + ": " + back.error().message);
    const LostObjects lost = lost_objects(drawing, traits.format);
    const Objects all(drawing), read(back->drawing);
    const Objects had(traits.layers ? drawing : visible_part(drawing));
    RC_ASSERT(all.strokes - read.strokes == lost.hidden_strokes);
    RC_ASSERT(had.fills - read.fills == lost.fills);
    RC_ASSERT(had.pictures - read.pictures == lost.pictures);
    RC_ASSERT(had.blends - read.blends == lost.blends);
    RC_ASSERT(had.timings - read.timings == lost.timings);
    RC_ASSERT(had.body_edits - read.body_edits == lost.body_edits);
    RC_ASSERT(had.guides - read.guides == lost.guides);
    RC_ASSERT(had.symmetries - read.symmetries == lost.symmetries);
    RC_ASSERT(had.opacities - read.opacities == lost.opacities);
    RC_ASSERT(had.materials - read.materials == lost.materials);
    RC_ASSERT(had.media - read.media == lost.media);
    RC_ASSERT(had.names - read.names == lost.names);
    if (traits.layers) {
      RC_ASSERT(had.groups - read.groups == lost.groups);
      RC_ASSERT(had.locks - read.locks == lost.locks);
      RC_ASSERT(had.hidden - read.hidden == lost.shown_strokes);
      RC_ASSERT(back->drawing.document.layers().size() == drawing.document.layers().size());
    }
    RC_ASSERT(loss_texts(lost).empty() == (lost == LostObjects()));
  }
}

TEST(LossTexts, NameEachKindOnceWithItsCount) {
  EXPECT_EQ(loss_texts({.guides = 3}),
            std::vector<std::string>{"3 guides were left out, because the format has none"});
  const LostObjects all = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
  const std::vector<std::string> texts = loss_texts(all);
  ASSERT_EQ(texts.size(), 17U);
  for (int count = 1; count <= 17; ++count) {
    EXPECT_EQ(std::count_if(texts.begin(), texts.end(),
                            [&](const std::string& text) {
                              return (" " + text).find(" " + std::to_string(count) + " ") !=
                                     std::string::npos;
                            }),
              1)
        << count;
  }
}

}  // namespace
}  // namespace felt::lost_objects_test
