#include "felt/document/history.h"

#include <gtest/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"

namespace felt::history_test {
namespace {

Edit draw(const Document& d, const char* label = "Draw") {
  EditBuilder edit(d);
  edit.add(d.layers()[0].id,
           std::make_shared<const Stroke>(testing::straight_stroke({0, 0}, {9, 9}, 1, 2)));
  return std::move(edit).build(label);
}

TEST(History, R52_UndoAllGivesTheEmptyDocumentAndRedoAllTheFullOne) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomEdits random(seed);
    Document d;
    History history;
    std::vector<Document> states{d};
    for (int k = 0; k < 40; ++k) {
      const Edit edit = random.next(d);
      ASSERT_TRUE(d.apply(edit));
      history.record(edit);
      if (!edit.empty()) states.push_back(d);
    }
    ASSERT_EQ(history.undo_count(), states.size() - 1);
    for (std::size_t k = states.size() - 1; k-- > 0;) {
      ASSERT_TRUE(history.undo(d));
      ASSERT_EQ(d, states[k]);
    }
    EXPECT_EQ(d, Document());
    EXPECT_FALSE(history.undo(d));
    for (std::size_t k = 1; k < states.size(); ++k) {
      ASSERT_TRUE(history.redo(d));
      ASSERT_EQ(d, states[k]);
    }
    EXPECT_FALSE(history.redo(d));
  }
}

TEST(History, NamesAllStepsWhereverItStands) {
  Document d;
  History history;
  for (const char* label : {"a", "b", "c"}) {
    const Edit edit = draw(d, label);
    ASSERT_TRUE(d.apply(edit));
    history.record(edit);
  }
  const auto labels = [&history] {
    std::string all;
    for (std::size_t i = 0; i < history.step_count(); ++i) all += history.label(i);
    return all;
  };
  EXPECT_EQ(labels(), "abc");
  ASSERT_TRUE(history.undo(d) && history.undo(d));
  EXPECT_EQ(labels(), "abc");
  const Edit edit = draw(d, "d");
  ASSERT_TRUE(d.apply(edit));
  history.record(edit);
  EXPECT_EQ(labels(), "ad");
}

TEST(History, AStepIsExtendedOnlyByAReplacementOfTheSameStrokes) {
  Document d;
  History history;
  const auto apply = [&](const Edit& edit) { ASSERT_TRUE(d.apply(edit)); };
  const Edit drawn = draw(d);
  const StrokeId id = drawn.changes.front().id;
  EXPECT_FALSE(history.extend(drawn)) << "without a step";
  apply(drawn);
  history.record(drawn);
  const auto wider = [&](double width_mm, const char* label) {
    EditBuilder edit(d);
    edit.replace(id, std::make_shared<const Stroke>(
                         testing::straight_stroke({0, 0}, {9, 9}, width_mm, width_mm)));
    return std::move(edit).build(label);
  };
  const Document before = d;
  const Edit first = wider(3, "Move");
  apply(first);
  EXPECT_FALSE(history.extend(first)) << "the step has another label";
  history.record(first);
  const std::uint64_t position = history.position();
  const Edit second = wider(4, "Move");
  apply(second);
  EXPECT_TRUE(history.extend(second));
  EXPECT_EQ(history.undo_count(), 2U);
  EXPECT_NE(history.position(), position) << "the document is not as it was after the first edit";
  const Document after = d;
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(d, before);
  const Edit third = wider(5, "Draw");
  EXPECT_FALSE(history.extend(third)) << "a step is undone";
  ASSERT_TRUE(history.redo(d));
  EXPECT_EQ(d, after);
}

TEST(History, AStepOfLayersIsJoinedByInk) {
  Document d;
  History history;
  const auto layer = [&d](std::string name) {
    const LayerId id = d.new_layer_id();
    return Edit{
        "Add layer", {}, {{id, std::nullopt, LayerState{std::move(name)}, 0, d.layers().size()}}};
  };
  const auto apply = [&](const Edit& edit) { ASSERT_TRUE(d.apply(edit)); };
  Edit ink = draw(d);
  EXPECT_FALSE(history.join(ink)) << "without a step";
  const Document before = d;
  const Edit added = layer("b");
  apply(added);
  history.record(added);
  const std::uint64_t position = history.position();
  Edit other = layer("c");
  EXPECT_FALSE(history.join(other)) << "it changes layers, too";
  ink = draw(d, "Draw");
  apply(ink);
  EXPECT_TRUE(history.join(ink));
  EXPECT_EQ(history.undo_count(), 1U);
  EXPECT_EQ(history.undo_label(), "Draw");
  EXPECT_NE(history.position(), position);
  const Document after = d;
  Edit second = draw(d, "Draw");
  EXPECT_FALSE(history.join(second)) << "the step does more than change layers";
  EXPECT_EQ(second.layers.size(), 0U);
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(d, before);
  EXPECT_FALSE(history.join(second)) << "a step is undone";
  ASSERT_TRUE(history.redo(d));
  EXPECT_EQ(d, after);
}

/// A step that adds or removes pictures holds their bytes, also if the layers are in a group.
TEST(History, TheBytesOfPicturesCount) {
  auto data = std::make_shared<PictureData>();
  data->png.assign(100'000, 'x');
  const auto state_with = [&data](std::optional<double> x_mm) {
    LayerState state{"Photo"};
    if (x_mm) {
      state.picture =
          std::make_shared<const LayerPicture>(LayerPicture{data, {1, 0, 0, 1, *x_mm, 0}});
    }
    return state;
  };
  const auto memory = [](std::optional<LayerState> before, std::optional<LayerState> after) {
    return memory_of(Edit{"Layer", {}, {{{2}, std::move(before), std::move(after), 0, 0}}});
  };
  EXPECT_GT(memory({}, state_with(0.0)), 100'000U);
  EXPECT_GT(memory(state_with(0.0), {}), 100'000U);
  EXPECT_GT(memory(state_with(0.0), state_with({})), 100'000U);
  EXPECT_LT(memory(state_with(0.0), state_with(5.0)), 10'000U) << "the document has it, too";
  History history(250'000);
  Document document;
  for (int i = 0; i < 6; ++i) {
    const bool adds = i % 2 == 0;
    Edit edit{"Layer", {}, {{{2}, std::nullopt, state_with(0.0), 0, 1}}};
    if (!adds) edit = edit.inverse();
    ASSERT_TRUE(document.apply(edit));
    history.record(edit);
  }
  EXPECT_EQ(history.undo_count(), 2U);
}

TEST(History, R52_ThousandRandomStepsBackAndForth) {
  testing::RandomEdits random(7);
  testing::RandomStroke dice(8);
  Document d;
  History history;
  std::vector<Document> states{d};  // states[k]: the document after k done steps
  for (int k = 0; k < 1000; ++k) {
    const double what = dice.uniform(0, 1);
    if (what < 0.5) {
      const Edit edit = random.next(d);
      ASSERT_TRUE(d.apply(edit));
      states.resize(history.undo_count() + 1);
      history.record(edit);
      if (!edit.empty()) states.push_back(d);
    } else if (what < 0.8) {
      const bool possible = history.can_undo();
      ASSERT_EQ(history.undo(d).has_value(), possible);
    } else {
      const bool possible = history.can_redo();
      ASSERT_EQ(history.redo(d).has_value(), possible);
    }
    ASSERT_EQ(d, states[history.undo_count()]);
  }
}

TEST(History, ReturnsTheEditThatItApplied) {
  Document d;
  History history;
  const Edit edit = draw(d);
  ASSERT_TRUE(d.apply(edit));
  history.record(edit);
  EXPECT_EQ(history.undo(d).value(), edit.inverse());
  EXPECT_EQ(history.redo(d).value(), edit);
}

TEST(History, NamesTheSteps) {
  Document d;
  History history;
  EXPECT_EQ(history.undo_label(), "");
  for (const char* label : {"Draw", "Pull"}) {
    const Edit edit = draw(d, label);
    ASSERT_TRUE(d.apply(edit));
    history.record(edit);
  }
  EXPECT_EQ(history.undo_label(), "Pull");
  EXPECT_EQ(history.redo_label(), "");
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(history.undo_label(), "Draw");
  EXPECT_EQ(history.redo_label(), "Pull");
}

TEST(History, ANewStepForgetsWhatWasUndone) {
  Document d;
  History history;
  for (int k = 0; k < 3; ++k) {
    const Edit edit = draw(d);
    ASSERT_TRUE(d.apply(edit));
    history.record(edit);
  }
  ASSERT_TRUE(history.undo(d));
  ASSERT_TRUE(history.undo(d));
  const std::size_t bytes_of_three = history.memory_bytes();
  const Edit edit = draw(d, "Other");
  ASSERT_TRUE(d.apply(edit));
  history.record(edit);
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_count(), 2u);
  EXPECT_LT(history.memory_bytes(), bytes_of_three);
}

TEST(History, AnEmptyEditIsNoStep) {
  History history;
  history.record({"Nothing", {}});
  EXPECT_FALSE(history.can_undo());
}

TEST(History, BeyondTheMemoryLimitTheOldestStepsGo) {
  Document d;
  const Edit first = draw(d);
  const std::size_t one = memory_of(first);
  EXPECT_GT(one, sizeof(Stroke));
  History history(10 * one);
  for (int k = 0; k < 100; ++k) {
    const Edit edit = draw(d);
    ASSERT_TRUE(d.apply(edit));
    history.record(edit);
    ASSERT_LE(history.memory_bytes(), 10 * one);
  }
  EXPECT_GE(history.undo_count(), 8u);
  EXPECT_EQ(history.undo_count() + history.forgotten_count(), 100u);
  const std::size_t steps = history.undo_count();
  while (history.can_undo()) ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(d.stroke_count(), 100 - steps);
}

TEST(History, TheNewestStepIsKeptHoweverLarge) {
  Document d;
  History history(1);
  for (int k = 0; k < 3; ++k) {
    const Edit edit = draw(d);
    ASSERT_TRUE(d.apply(edit));
    history.record(edit);
    EXPECT_EQ(history.undo_count(), 1u);
  }
  EXPECT_TRUE(history.undo(d));
  EXPECT_EQ(d.stroke_count(), 2u);
}

TEST(History, ADocumentChangedBehindItsBackIsReported) {
  Document d;
  History history;
  const Edit edit = draw(d);
  ASSERT_TRUE(d.apply(edit));
  history.record(edit);
  ASSERT_TRUE(d.apply(edit.inverse()));
  EXPECT_FALSE(history.undo(d));
  EXPECT_EQ(history.undo_count(), 1u);
  EXPECT_EQ(d, Document());
}

TEST(History, ThePositionIsThatOfTheDocumentWhateverWasUndone) {
  Document d;
  History history;
  const auto step = [&] {
    const Edit edit = draw(d);
    EXPECT_TRUE(d.apply(edit));
    history.record(edit);
  };
  const std::uint64_t start = history.position();
  step();
  const std::uint64_t one = history.position();
  EXPECT_NE(one, start);
  ASSERT_TRUE(history.undo(d));
  EXPECT_EQ(history.position(), start);
  ASSERT_TRUE(history.redo(d));
  EXPECT_EQ(history.position(), one);
  ASSERT_TRUE(history.undo(d));
  step();
  EXPECT_NE(history.position(), one) << "another step in its place";
  EXPECT_NE(history.position(), start);
}

}  // namespace
}  // namespace felt::history_test
