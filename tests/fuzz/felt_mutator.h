#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/testing/random_document.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_recording.h"

namespace felt::fuzz {

/// Makes changes to .felt files that respect the format: to rows, to blobs (with a correct
/// checksum) and to the schema. It usually updates the checksum of the drawing, so that the reader
/// reaches the change. Sometimes it changes any bytes of the pages. If the input is not a .felt
/// file, a small drawing replaces it.
class FeltMutator {
 public:
  explicit FeltMutator(unsigned seed) : random_(seed) {}

  std::string mutated(const std::string& bytes) {
    if (one_in(4)) return with_bytes_changed(bytes);
    sqlite3* db = nullptr;
    sqlite3_open(":memory:", &db);
    const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> owner(db, &sqlite3_close);
    if (one_in(20) || !load(db, bytes)) load(db, fresh());
    for (auto k = 1 + random_() % 3; k > 0; --k) change(db);
    if (!one_in(5)) seal(db);
    sqlite3_int64 size = 0;
    unsigned char* data = sqlite3_serialize(db, "main", &size, 0);
    if (!data) return bytes;
    std::string changed(reinterpret_cast<const char*>(data), static_cast<std::size_t>(size));
    sqlite3_free(data);
    return one_in(10) ? with_bytes_changed(changed) : changed;
  }

 private:
  bool one_in(unsigned n) { return random_() % n == 0; }
  const char* any(const std::vector<const char*>& of) { return of[random_() % of.size()]; }

  /// Returns a small random drawing as a .felt file.
  std::string fresh() {
    const auto seed = random_() % 1000;
    Drawing drawing;
    testing::RandomEdits edits(seed);
    for (auto k = random_() % 4; k > 0; --k) {
      static_cast<void>(drawing.document.apply(edits.next(drawing.document)));
    }
    drawing.palette.colors.resize(random_() % 3);
    if (one_in(2)) drawing.view = Viewport{};
    if (one_in(2)) {
      FeltRecording recording;
      recording.device = "pen";
      for (int i = 0; i < 5; ++i) {
        recording.samples.push_back({1'000'000 * i, {{1.0, 2.0, 0.1 * i}, 0.5, 0}, {}});
      }
      recording.samples[1].forces = RecordedForces{{1, 0, 0}, {0.5, 0, 0}};
      recording.events.push_back({2, {1'500'000, UndoEvent{}}});
      static_cast<void>(add_recording(drawing, recording));
    }
    return felt_bytes(drawing).value();
  }

  static bool load(sqlite3* db, const std::string& bytes) {
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size() + 1));
    std::memcpy(copy, bytes.data(), bytes.size());
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    const unsigned flags = SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE;
    return sqlite3_deserialize(db, "main", copy, size, size, flags) == SQLITE_OK &&
           run(db, "SELECT count(*) FROM stroke, layer, drawing");
  }

  static bool run(sqlite3* db, const std::string& sql) {
    return sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  }

  std::string with_bytes_changed(std::string bytes) {
    if (bytes.empty()) return "S";
    for (auto k = 1 + random_() % 4; k > 0; --k) {
      char& byte = bytes[random_() % bytes.size()];
      byte =
          one_in(2) ? static_cast<char>(random_()) : static_cast<char>(byte ^ 1 << random_() % 8);
    }
    if (one_in(8)) bytes.resize(1 + random_() % bytes.size());
    if (one_in(8) && bytes.size() > 8192)
      bytes.replace(4096 * (random_() % (bytes.size() / 4096)), 4096, bytes.substr(0, 4096));
    return bytes;
  }

  std::string value() {
    switch (random_() % 9) {
      case 0:
        return "NULL";
      case 1:
        return any({"0", "1", "2", "-1", "9007199254740992", "9007199254740993",
                    "9223372036854775807", "-9223372036854775808", "4294967296", "10001"});
      case 2:
        return any({"0.0", "-0.0", "1e308", "9e999", "-9e999", "1e-320", "210.5", "5000.01"});
      case 3:
        return any({"''", "'x'", "x''", "CAST(x'ff' AS TEXT)", "zeroblob(5000)",
                    "printf('%.*c', 5000, 'n')", "x'0100'"});
      default:
        return std::to_string(random_() % 12);
    }
  }

  void change(sqlite3* db) {
    switch (random_() % 6) {
      case 0:
      case 1:
        return change_shape(db);
      case 2:
        return change_schema(db);
      default:
        return change_row(db);
    }
  }

  void change_row(sqlite3* db) {
    struct Table {
      const char* name;
      std::vector<const char*> columns;
    };
    const std::vector<Table> tables = {
        {"drawing",
         {"width_mm", "height_mm", "paper", "material", "color", "layer", "last_stroke",
          "last_layer", "palette", "palette_columns", "id"}},
        {"layer", {"id", "place", "name", "visible", "locked"}},
        {"stroke", {"id", "layer", "place", "shape"}},
        {"palette", {"id", "color", "name"}},
        {"shown", {"center_x_mm", "px_per_mm", "angle_deg", "mirrored", "id"}},
        {"recording",
         {"start_ns", "period_ns", "first_sample", "samples", "first_event", "events", "end_ns",
          "device"}},
        {"recording_sample", {"id", "late_ns", "x_mm", "pressure", "buttons", "asked_x", "cut_z"}},
        {"recording_event", {"id", "before_sample", "time_ns", "kind", "line"}}};
    const Table& table = tables[random_() % tables.size()];
    const std::string row = " WHERE rowid IN (SELECT rowid FROM " + std::string(table.name) +
                            " LIMIT 1 OFFSET " + std::to_string(random_() % 4) + ")";
    if (one_in(8)) {
      run(db, "DELETE FROM " + std::string(table.name) + row);
    } else {
      run(db, "UPDATE OR REPLACE " + std::string(table.name) + " SET " + any(table.columns) + "=" +
                  value() + row);
    }
  }

  void change_shape(sqlite3* db) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(db, "SELECT id, shape FROM stroke LIMIT 1 OFFSET ?", -1, &statement,
                       nullptr);
    sqlite3_bind_int64(statement, 1, static_cast<sqlite3_int64>(random_() % 4));
    std::string shape;
    sqlite3_int64 id = 0;
    if (sqlite3_step(statement) == SQLITE_ROW && sqlite3_column_bytes(statement, 1) > 5) {
      id = sqlite3_column_int64(statement, 0);
      shape.assign(static_cast<const char*>(sqlite3_column_blob(statement, 1)),
                   static_cast<std::size_t>(sqlite3_column_bytes(statement, 1)));
    }
    sqlite3_finalize(statement);
    if (shape.empty()) return;
    shape.resize(shape.size() - 4);
    for (auto k = 1 + random_() % 3; k > 0; --k) {
      shape[random_() % shape.size()] ^= static_cast<char>(1 << random_() % 8);
    }
    if (one_in(6)) shape.resize(1 + random_() % shape.size());
    ByteWriter(shape).u32(crc32c(shape));
    sqlite3_prepare_v2(db, "UPDATE stroke SET shape=? WHERE id=?", -1, &statement, nullptr);
    sqlite3_bind_blob64(statement, 1, shape.data(), shape.size(), SQLITE_STATIC);
    sqlite3_bind_int64(statement, 2, id);
    sqlite3_step(statement);
    sqlite3_finalize(statement);
  }

  void change_schema(sqlite3* db) {
    run(db, any({"ALTER TABLE stroke ADD COLUMN glow REAL",
                 "ALTER TABLE layer ADD COLUMN opacity REAL NOT NULL DEFAULT 1.0",
                 "ALTER TABLE drawing ADD COLUMN title TEXT DEFAULT 'a'",
                 "UPDATE stroke SET glow = id * 0.1", "UPDATE stroke SET glow = zeroblob(100)",
                 "CREATE TABLE note(id INTEGER PRIMARY KEY, stroke INTEGER, words TEXT)",
                 "INSERT INTO note(stroke, words) SELECT id, 'n' || id FROM stroke",
                 "CREATE TABLE guide(layer INTEGER NOT NULL DEFAULT 1, x BLOB)",
                 "INSERT INTO guide VALUES(1, 2.5), (7, NULL)",
                 "CREATE VIEW v AS SELECT randomblob(9) FROM stroke", "DROP TABLE recording",
                 "CREATE INDEX i ON note(words)", "CREATE INDEX j ON recording_sample(x_mm)",
                 "CREATE INDEX s ON stroke(place)",
                 "CREATE TRIGGER t AFTER INSERT ON note BEGIN SELECT 1; END",
                 "CREATE TABLE g(a INTEGER, b INTEGER AS (a + 1))",
                 "CREATE TABLE k(a INTEGER CHECK(a > length(a)))"}));
    if (!one_in(4)) return;
    // Changes the text of a definition in the schema.
    run(db, "PRAGMA writable_schema=ON");
    run(db, "UPDATE sqlite_schema SET " +
                std::string(any({"sql", "name", "tbl_name", "rootpage"})) + "=" +
                any({"substr(sql, 2)", "sql || ' '", "replace(sql, 'REAL', 'TEXT')",
                     "replace(sql, ')', ', z INTEGER)')", "'stroke'", "2", "3", "99", "NULL"}) +
                " WHERE rowid = " + std::to_string(1 + random_() % 9));
  }

  static std::vector<std::vector<std::string>> rows(sqlite3* db, const char* sql) {
    std::vector<std::vector<std::string>> all;
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(db, sql, -1, &statement, nullptr);
    while (statement && sqlite3_step(statement) == SQLITE_ROW) {
      auto& row = all.emplace_back();
      for (int i = 0; i < sqlite3_column_count(statement); ++i) {
        const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, i));
        row.emplace_back(text ? text : "",
                         static_cast<std::size_t>(sqlite3_column_bytes(statement, i)));
      }
    }
    sqlite3_finalize(statement);
    return all;
  }

  /// Writes the checksum of the drawing as docs/formats/felt.md defines it.
  static void seal(sqlite3* db) {
    const auto number = [](const std::string& text) {
      return static_cast<std::uint64_t>(std::strtoll(text.c_str(), nullptr, 10));
    };
    const auto real = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
    const auto drawing =
        rows(db,
             "SELECT printf('%!.17g', width_mm), printf('%!.17g', height_mm), paper, material, "
             "color, layer, last_stroke, last_layer, palette, palette_columns FROM drawing");
    if (drawing.size() != 1) return;
    const auto& d = drawing[0];
    std::string bytes;
    ByteWriter out(bytes);
    out.f64(real(d[0]));
    out.f64(real(d[1]));
    out.u32(static_cast<std::uint32_t>(number(d[2])));
    out.text(d[3]);
    out.u32(static_cast<std::uint32_t>(number(d[4])));
    out.u64(number(d[5]));
    out.u64(number(d[6]) + 1);
    out.u64(number(d[7]) + 1);
    for (const auto& layer :
         rows(db, "SELECT id, name, visible, locked FROM layer ORDER BY place, id")) {
      out.u64(number(layer[0]));
      out.text(layer[1]);
      out.u8(static_cast<std::uint8_t>(number(layer[2]) | number(layer[3]) << 1));
      const auto strokes =
          rows(db, ("SELECT id FROM stroke WHERE layer=" + layer[0] + " ORDER BY place").c_str());
      out.u64(strokes.size());
      for (const auto& stroke : strokes) out.u64(number(stroke[0]));
    }
    out.text(d[8]);
    out.u32(static_cast<std::uint32_t>(number(d[9])));
    const auto colors = rows(db, "SELECT color, name FROM palette");
    out.u32(static_cast<std::uint32_t>(colors.size()));
    for (const auto& color : colors) {
      out.u32(static_cast<std::uint32_t>(number(color[0])));
      out.text(color[1]);
    }
    const auto shown = rows(db,
                            "SELECT printf('%!.17g', center_x_mm), printf('%!.17g', center_y_mm), "
                            "printf('%!.17g', px_per_mm), printf('%!.17g', angle_deg), mirrored "
                            "FROM shown");
    out.u8(shown.empty() ? 0 : 1);
    if (!shown.empty()) {
      for (std::size_t i = 0; i < 4; ++i) out.f64(real(shown[0][i]));
      out.u8(static_cast<std::uint8_t>(number(shown[0][4])));
    }
    run(db, "UPDATE drawing SET checksum = " + std::to_string(crc32c(bytes)));
  }

  std::mt19937 random_;
};

}  // namespace felt::fuzz
