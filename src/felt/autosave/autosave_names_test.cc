// An autosave keeps the names that strokes had in the file from which they came.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "felt/autosave/autosave_rows.h"
#include "felt/autosave/recovery.h"
#include "felt/autosave/testing/autosave_fixture.h"
#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"
#include "felt/store/byte_writer.h"
#include "felt/store/stroke_name_table.h"

namespace felt::autosave_names_test {
namespace {

using ::testing::StartsWith;
using testing::TestFolder;

/// Returns a drawing of at least four strokes, the names of which begin with `name`.
Drawing named_drawing(const std::string& name, std::uint64_t seed = 4) {
  Drawing drawing;
  testing::RandomEdits edits(seed);
  while (drawing.document.stroke_count() < 4) {
    EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  }
  StrokeNames names;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) names[id] = name + std::to_string(id.value);
  }
  drawing.names = std::make_shared<const StrokeNames>(std::move(names));
  return drawing;
}

Drawing without_names(Drawing drawing) {
  drawing.names = nullptr;
  return drawing;
}

/// An autosave of a drawing that has no edits yet.
AutosaveDatabase autosave_of(const Drawing& drawing, const std::string& folder,
                             const std::string& path) {
  AutosaveDatabase store = AutosaveDatabase::create(folder, "a").value();
  EXPECT_TRUE(store.write_base(drawing));
  EXPECT_TRUE(store.put_info({"a", path, true, {}}));
  return store;
}

/// Returns what recovery reads after a crash of the process that wrote this autosave.
Recovered recovered_from(AutosaveDatabase store) {
  EXPECT_TRUE(store.commit());
  const std::string folder = store.folder();
  { const AutosaveDatabase closed = std::move(store); }
  const Result<Recovered> recovered = recover_autosave(folder);
  EXPECT_TRUE(recovered) << (recovered ? "" : recovered.error().message);
  return recovered.value_or(Recovered{});
}

TEST(AutosaveNames, AnImportedDrawingWithoutAFileKeepsThem) {
  const TestFolder folder;
  const Drawing drawing = named_drawing("cat-");
  const Recovered recovered = recovered_from(autosave_of(drawing, folder.at("state"), ""));
  EXPECT_TRUE(recovered.problems.empty());
  EXPECT_EQ(used_names(recovered.drawing), *drawing.names);
}

TEST(AutosaveNames, AnotherDrawingInTheFileGivesNoneOfItsNames) {
  const TestFolder folder;
  const std::string path = folder.at("a.felt");
  ASSERT_TRUE(write_felt(path, named_drawing("other-")));
  const Drawing named = named_drawing("cat-");
  for (const Drawing& drawing : {named, without_names(named)}) {
    const Recovered recovered =
        recovered_from(autosave_of(drawing, folder.at(drawing.names ? "b" : "c"), path));
    EXPECT_EQ(used_names(recovered.drawing), used_names(drawing));
  }
}

TEST(AutosaveNames, AStrokeThatIsDeletedAndRestoredKeepsItsName) {
  const TestFolder folder;
  const Drawing drawing = named_drawing("cat-");
  const StrokeId id = drawing.names->begin()->first;
  Drawing smaller = drawing;
  EditBuilder edit(smaller.document);
  edit.remove(id);
  const Edit removal = std::move(edit).build("Delete");
  ASSERT_TRUE(smaller.document.apply(removal));
  AutosaveDatabase store = autosave_of(smaller, folder.at("state"), "");
  ASSERT_TRUE(store.add_edit(removal.inverse()));
  const Recovered recovered = recovered_from(std::move(store));
  EXPECT_TRUE(recovered.problems.empty());
  EXPECT_EQ(used_names(recovered.drawing), *drawing.names);
}

/// The session of a program that draws on a named drawing and then crashes.
TEST(AutosaveNames, NewStrokesHaveNone) {
  const TestFolder folder;
  testing::AutosaveFixture fixture({.roots = {folder.path}});
  fixture.draw(3, 4);
  Drawing drawing = fixture.drawing();
  StrokeNames names;
  for (const StrokeId id : drawing.document.layers().front().strokes) {
    names[id] = "cat-" + std::to_string(id.value);
  }
  ASSERT_EQ(names.size(), 4u);
  drawing.names = std::make_shared<const StrokeNames>(names);
  fixture.autosave->session_began(*fixture.session, std::move(drawing), "a", "", false);
  fixture.autosave->process();
  fixture.draw(7);
  fixture.autosave->process();
  const Recovered recovered = fixture.crashed();
  EXPECT_EQ(recovered.drawing.document.stroke_count(), 5u);
  EXPECT_EQ(used_names(recovered.drawing), names);
}

RC_GTEST_PROP(AutosaveNames, EveryNameThatAFileMayHaveComesBack, (std::string name)) {
  Drawing drawing = named_drawing("cat-");
  StrokeNames names = *drawing.names;
  StrokeNames wanted = names;
  const StrokeId id = names.begin()->first;
  names[id] = name;
  if (is_stroke_name(name)) {
    wanted[id] = name;
  } else {
    wanted.erase(id);
  }
  drawing.names = std::make_shared<const StrokeNames>(names);
  RC_ASSERT(*read_base_head(base_head_bytes(drawing).value()).value().names == wanted);
}

// Programs from before names must read the head of a base, and this one must read theirs.
TEST(BaseHead, NamesFollowWhatOlderProgramsRead) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Drawing named = named_drawing("cat-", seed);
    const std::string plain = base_head_bytes(without_names(named)).value();
    const std::string bytes = base_head_bytes(named).value();
    EXPECT_THAT(bytes, StartsWith(plain));
    const Drawing old = read_base_head(plain).value();
    EXPECT_EQ(old.names, nullptr);
    const Drawing read = read_base_head(bytes).value();
    EXPECT_TRUE(read.document == old.document);
    EXPECT_EQ(*read.names, *named.names);
  }
}

TEST(BaseHead, DamagedNamesAreAnError) {
  const Drawing named = named_drawing("cat-");
  const std::string bytes = base_head_bytes(named).value();
  std::string names;
  ByteWriter out(names);
  for (const auto& [id, name] : *named.names) {
    out.u64(id.value);
    out.text(name);
  }
  ASSERT_TRUE(bytes.ends_with(names));
  for (std::size_t missing = 1; missing <= names.size(); ++missing) {
    EXPECT_FALSE(read_base_head(bytes.substr(0, bytes.size() - missing))) << missing;
  }
  const std::size_t first = bytes.size() - names.size();
  const std::vector<std::pair<std::size_t, char>> changes{{first, '\0'},
                                                          {first + 12, '\0'},
                                                          {first + 12, '\xff'},
                                                          {first + 1, '\x7f'},
                                                          {first + 8, '\0'}};
  for (const auto& [at, byte] : changes) {
    std::string damaged = bytes;
    damaged[at] = byte;
    EXPECT_FALSE(read_base_head(damaged)) << at - first;
  }
}

}  // namespace
}  // namespace felt::autosave_names_test
