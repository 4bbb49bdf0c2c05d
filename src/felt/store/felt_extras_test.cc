// Tests files that our writer does not make: files from a newer Feltline, and hostile files.
#include "felt/store/felt_extras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstring>
#include <memory>

#include "felt/document/testing/random_document.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_schema.h"

namespace felt::felt_extras_test {
namespace {

using ::testing::HasSubstr;

/// A .felt file, opened with plain SQLite as other programs do.
class Sqlite {
 public:
  explicit Sqlite(std::string_view bytes) {
    EXPECT_EQ(sqlite3_open(":memory:", &db_), SQLITE_OK);
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
    std::memcpy(copy, bytes.data(), bytes.size());
    EXPECT_EQ(sqlite3_deserialize(db_, "main", copy, sqlite3_int64(bytes.size()),
                                  sqlite3_int64(bytes.size()),
                                  SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE),
              SQLITE_OK);
  }
  ~Sqlite() { sqlite3_close(db_); }
  Sqlite(const Sqlite&) = delete;
  Sqlite& operator=(const Sqlite&) = delete;

  void run(const std::string& sql) {
    EXPECT_EQ(sqlite3_exec(db_, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sql << ": " << sqlite3_errmsg(db_);
  }
  /// Returns rows as text: "1|a;2|b".
  std::string all(const std::string& sql) {
    std::string text;
    const auto row = [](void* out, int columns, char** values, char**) {
      auto& into = *static_cast<std::string*>(out);
      if (!into.empty()) into += ';';
      for (int i = 0; i < columns; ++i) {
        if (i > 0) into += '|';
        into += values[i] ? values[i] : "NULL";
      }
      return 0;
    };
    EXPECT_EQ(sqlite3_exec(db_, sql.c_str(), row, &text, nullptr), SQLITE_OK)
        << sql << ": " << sqlite3_errmsg(db_);
    return text;
  }
  std::string bytes() {
    sqlite3_int64 size = 0;
    unsigned char* data = sqlite3_serialize(db_, "main", &size, 0);
    std::string bytes(reinterpret_cast<const char*>(data), std::size_t(size));
    sqlite3_free(data);
    return bytes;
  }

 private:
  sqlite3* db_ = nullptr;
};

/// Returns a drawing with strokes 1, 2, 3 in the initial layer.
Drawing three_strokes() {
  Drawing drawing;
  testing::RandomEdits edits(1);
  Edit edit;
  for (std::uint64_t i = 0; i < 3; ++i) {
    edit.changes.push_back({{i + 1}, nullptr, edits.stroke(), {}, {{1}, i}});
  }
  EXPECT_TRUE(drawing.document.apply(edit));
  return drawing;
}

std::string of_a_newer_one() {
  Sqlite db(felt_bytes(three_strokes()).value());
  db.run("ALTER TABLE stroke ADD COLUMN glow REAL");
  db.run("ALTER TABLE stroke ADD COLUMN tag TEXT NOT NULL DEFAULT 'none'");
  db.run("ALTER TABLE layer ADD COLUMN opacity REAL NOT NULL DEFAULT 1.0");
  db.run("ALTER TABLE drawing ADD COLUMN title TEXT");
  db.run("UPDATE stroke SET glow = 0.1 * id, tag = 't' || id");
  db.run("UPDATE layer SET opacity = 0.25; UPDATE drawing SET title = 'Vögel'");
  db.run("CREATE TABLE note(id INTEGER PRIMARY KEY, stroke INTEGER, words TEXT, picture BLOB)");
  db.run("INSERT INTO note VALUES(5, 2, 'two', x'0001'), (6, 3, 'three', NULL), (9, NULL, '', 7)");
  db.run("CREATE TABLE lamp(x_mm REAL NOT NULL, on_layer INTEGER NOT NULL DEFAULT -1)");
  db.run("INSERT INTO lamp(x_mm) VALUES(3.5), (0.1)");
  db.run("CREATE VIEW glowing AS SELECT id FROM stroke WHERE glow > 0");
  db.run("CREATE INDEX note_stroke ON note(stroke)");
  return db.bytes();
}

TEST(FeltExtras, WhatANewerOneKeepsIsCarried) {
  Drawing drawing = parse_felt(of_a_newer_one()).value();
  EXPECT_TRUE(drawing.document == three_strokes().document);
  const std::string written = felt_bytes(drawing).value();
  Sqlite db(written);
  EXPECT_EQ(db.all("SELECT id, round(glow, 3), tag FROM stroke"), "1|0.1|t1;2|0.2|t2;3|0.3|t3");
  EXPECT_EQ(db.all("SELECT opacity FROM layer"), "0.25");
  EXPECT_EQ(db.all("SELECT title FROM drawing"), "Vögel");
  EXPECT_EQ(db.all("SELECT id, stroke, words, hex(picture), typeof(picture) FROM note"),
            "5|2|two|0001|blob;6|3|three||null;9|NULL||37|integer");
  EXPECT_EQ(db.all("SELECT x_mm, on_layer FROM lamp"), "3.5|-1;0.1|-1");
  EXPECT_EQ(db.all("SELECT name FROM sqlite_schema WHERE type <> 'table'"), "");
  // Saving again gives the same bytes.
  const Drawing again = parse_felt(written).value();
  EXPECT_TRUE(again == drawing);
  EXPECT_EQ(felt_bytes(again).value(), written);
}

TEST(FeltExtras, RowsOfStrokesThatAreGoneGoWithThem) {
  Drawing drawing = parse_felt(of_a_newer_one()).value();
  Edit edit;
  edit.changes.push_back({{2}, drawing.document.find({2}), nullptr, {{1}, 1}, {}});
  testing::RandomEdits edits(2);
  edit.changes.push_back({{4}, nullptr, edits.stroke(), {}, {{1}, 2}});
  ASSERT_TRUE(drawing.document.apply(edit));
  const std::string written = felt_bytes(drawing).value();
  Sqlite db(written);
  EXPECT_EQ(db.all("SELECT id, tag FROM stroke"), "1|t1;3|t3;4|none");
  EXPECT_EQ(db.all("SELECT id FROM note"), "6;9");
  EXPECT_FALSE(parse_felt(written).value() == parse_felt(of_a_newer_one()).value());
}

TEST(FeltExtras, PlacesOfLayersHaveNoGapsAndAreNotTakenTwice) {
  Drawing drawing = three_strokes();
  Edit edit;
  edit.layers.push_back({{2}, std::nullopt, LayerState{"upper", true, false}, 0, 1});
  ASSERT_TRUE(drawing.document.apply(edit));
  const std::string plain = felt_bytes(drawing).value();
  const auto read = [&](const std::string& place) {
    Sqlite db(plain);
    db.run("UPDATE layer SET place = " + place + " WHERE id = 2");
    return parse_felt(db.bytes());
  };
  EXPECT_TRUE(read("1").value() == drawing);
  for (const char* place : {"0", "2", "5", "4294967297", "1.5", "'one'"}) {
    const Result<Drawing> refused = read(place);
    ASSERT_FALSE(refused) << place;
    EXPECT_THAT(refused.error().message, HasSubstr("layer 2 contains an invalid value")) << place;
  }
}

TEST(FeltExtras, PlacesOfStrokesThatContradictEachOtherAreDamageAndNotAnEdit) {
  const std::string plain = felt_bytes(three_strokes()).value();
  for (const auto& [change, reason] :
       std::vector<std::pair<std::string, std::string>>{{"place = 0", "is used twice"},
                                                        {"place = place + 5", "is beyond the end"},
                                                        {"layer = 9", "layer 9 does not exist"}}) {
    Sqlite db(plain);
    db.run("UPDATE stroke SET " + change);
    const Result<Drawing> refused = parse_felt(db.bytes());
    ASSERT_FALSE(refused) << change;
    EXPECT_EQ(refused.error().message.substr(0, 12), "is damaged: ") << refused.error().message;
    EXPECT_THAT(refused.error().message, HasSubstr(reason)) << change;
    EXPECT_EQ(refused.error().message.find("edit"), std::string::npos) << refused.error().message;
  }
}

TEST(FeltExtras, NothingThatCouldActIsTaken) {
  const std::string plain = felt_bytes(three_strokes()).value();
  const auto message = [&](const std::string& sql) {
    Sqlite db(plain);
    db.run(sql);
    const Result<Drawing> read = parse_felt(db.bytes());
    return read ? std::string("taken") : read.error().message;
  };
  EXPECT_THAT(message("CREATE TRIGGER t AFTER INSERT ON stroke BEGIN DELETE FROM layer; END"),
              HasSubstr("triggers"));
  EXPECT_THAT(message("CREATE INDEX i ON stroke(place)"), HasSubstr("index"));
  for (const char* sql :
       {"CREATE VIRTUAL TABLE v USING fts5(words)",
        "CREATE TABLE t(a INTEGER, b INTEGER AS (abs(a)) STORED)",
        "CREATE TABLE t(a INTEGER CHECK(a < abs(random())))",
        "CREATE TABLE t(a TEXT DEFAULT (hex(randomblob(9))))",
        "CREATE TABLE t(a TEXT DEFAULT CURRENT_TIMESTAMP)", "CREATE TABLE T(a TEXT)",
        "CREATE TABLE t(a TEXT UNIQUE)", "CREATE TABLE t(a VARCHAR)", "CREATE TABLE t(a)",
        "CREATE TABLE t(a TEXT) STRICT", "CREATE TABLE t(a INTEGER PRIMARY KEY) WITHOUT ROWID",
        "CREATE TABLE t(a TEXT, b INTEGER PRIMARY KEY)", "CREATE TABLE \"a b\"(a TEXT)",
        "CREATE TABLE t(a TEXT COLLATE NOCASE)", "ALTER TABLE stroke ADD COLUMN a INTEGER CHECK(1)",
        "ALTER TABLE stroke ADD COLUMN a AS (zeroblob(1e9))", "ANALYZE"}) {
    EXPECT_THAT(message(sql), HasSubstr("an unknown table")) << sql;
  }
  EXPECT_THAT(message("ALTER TABLE shown ADD COLUMN a INTEGER"),
              HasSubstr("the tables of a Feltline drawing"));
  EXPECT_THAT(message("DROP TABLE palette"), HasSubstr("the tables of a Feltline drawing"));
  EXPECT_THAT(message("DROP TABLE layer; CREATE TABLE layer(id INTEGER PRIMARY KEY)"),
              HasSubstr("'layer' has an unexpected definition"));
  // Views are ignored, whatever they contain, even if they have the name of one of our tables.
  EXPECT_EQ(message("CREATE VIEW v AS SELECT randomblob(1e9)"), "taken");
}

TEST(FeltExtras, AreBounded) {
  const auto with_tables = [](std::size_t count) {
    Sqlite db(felt_bytes(three_strokes()).value());
    for (std::size_t i = 0; i < count; ++i) {
      db.run("CREATE TABLE t" + std::to_string(i) + "(a TEXT)");
    }
    return parse_felt(db.bytes());
  };
  EXPECT_TRUE(with_tables(kMaxForeignTables - 1));
  EXPECT_TRUE(with_tables(kMaxForeignTables));
  EXPECT_EQ(with_tables(kMaxForeignTables + 1).error().code, ErrorCode::kLimitExceeded);
  const auto with_columns = [](std::size_t count) {
    Sqlite db(felt_bytes(three_strokes()).value());
    std::string columns = "c0 REAL";
    for (std::size_t i = 1; i < count; ++i) columns += ", c" + std::to_string(i) + " REAL";
    db.run("CREATE TABLE t(" + columns + ")");
    return parse_felt(db.bytes());
  };
  EXPECT_TRUE(with_columns(kMaxColumns - 1));
  EXPECT_TRUE(felt_bytes(with_columns(kMaxColumns).value()));
  EXPECT_FALSE(with_columns(kMaxColumns + 1));
  const auto with_name = [](std::size_t size) {
    Sqlite db(felt_bytes(three_strokes()).value());
    db.run("CREATE TABLE " + std::string(size, 'n') + "(a TEXT)");
    return parse_felt(db.bytes());
  };
  EXPECT_TRUE(with_name(kMaxIdentifierBytes));
  EXPECT_FALSE(with_name(kMaxIdentifierBytes + 1));
}

}  // namespace
}  // namespace felt::felt_extras_test
