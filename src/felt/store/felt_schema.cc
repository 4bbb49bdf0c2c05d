#include "felt/store/felt_schema.h"

#include <algorithm>
#include <array>
#include <utility>

#include "felt/base/check.h"
#include "felt/store/body_edit_table.h"
#include "felt/store/fill_table.h"
#include "felt/store/guide_table.h"
#include "felt/store/key_timing_table.h"
#include "felt/store/layer_group_table.h"
#include "felt/store/layer_look_table.h"
#include "felt/store/material_table.h"
#include "felt/store/stroke_name_table.h"

namespace felt {
namespace {

// The definitions are part of the format: a file contains exactly this text, or this text with
// additional columns after it.
constexpr std::array kTables = {
    OwnTable{
        "drawing",
        "CREATE TABLE drawing(id INTEGER PRIMARY KEY, width_mm REAL NOT NULL, "
        "height_mm REAL NOT NULL, paper INTEGER NOT NULL, material TEXT NOT NULL, "
        "color INTEGER NOT NULL, layer INTEGER NOT NULL, last_stroke INTEGER NOT NULL, "
        "last_layer INTEGER NOT NULL, palette TEXT NOT NULL, palette_columns INTEGER NOT NULL, "
        "checksum INTEGER NOT NULL)",
        12},
    OwnTable{"layer",
             "CREATE TABLE layer(id INTEGER PRIMARY KEY, place INTEGER NOT NULL, "
             "name TEXT NOT NULL, visible INTEGER NOT NULL, locked INTEGER NOT NULL)",
             5},
    OwnTable{"palette",
             "CREATE TABLE palette(id INTEGER PRIMARY KEY, color INTEGER NOT NULL, "
             "name TEXT NOT NULL)",
             3},
    OwnTable{"shown",
             "CREATE TABLE shown(id INTEGER PRIMARY KEY, center_x_mm REAL NOT NULL, "
             "center_y_mm REAL NOT NULL, px_per_mm REAL NOT NULL, angle_deg REAL NOT NULL, "
             "mirrored INTEGER NOT NULL)",
             6},
    OwnTable{"stroke",
             "CREATE TABLE stroke(id INTEGER PRIMARY KEY, layer INTEGER NOT NULL, "
             "place INTEGER NOT NULL, shape BLOB NOT NULL)",
             4}};

constexpr std::array kRecordingTables = {
    OwnTable{"recording",
             "CREATE TABLE recording(id INTEGER PRIMARY KEY, device TEXT NOT NULL, "
             "start_ns INTEGER NOT NULL, period_ns INTEGER NOT NULL, "
             "first_sample INTEGER NOT NULL, samples INTEGER NOT NULL, "
             "first_event INTEGER NOT NULL, events INTEGER NOT NULL, end_ns INTEGER NOT NULL, "
             "checksum INTEGER NOT NULL)",
             10},
    OwnTable{"recording_event",
             "CREATE TABLE recording_event(id INTEGER PRIMARY KEY, before_sample INTEGER NOT NULL, "
             "time_ns INTEGER NOT NULL, kind TEXT NOT NULL, line TEXT NOT NULL)",
             5},
    OwnTable{"recording_sample",
             "CREATE TABLE recording_sample(id INTEGER PRIMARY KEY, late_ns INTEGER NOT NULL, "
             "x_mm REAL NOT NULL, y_mm REAL NOT NULL, z_mm REAL NOT NULL, pressure REAL, "
             "buttons INTEGER NOT NULL, asked_x INTEGER, asked_y INTEGER, asked_z INTEGER, "
             "cut_x INTEGER, cut_y INTEGER, cut_z INTEGER)",
             13}};

/// Columns that exist only if a pen's tilt was recorded: (table, column).
constexpr std::array kTiltColumns = {std::pair{"recording", "lean_checksum INTEGER"},
                                     std::pair{"recording_sample", "lean_deg REAL"}};

constexpr std::array kRecordingViews = {
    "CREATE VIEW recordings AS SELECT id AS recording, device, 1000000000.0 / period_ns AS "
    "rate_hz, "
    "samples, events, 0.000001 * start_ns AS start_ms, 0.000001 * end_ns AS end_ms FROM recording",
    "CREATE VIEW recorded_samples AS SELECT r.id AS recording, s.id - r.first_sample AS sample, "
    "0.000001 * (r.start_ns + (s.id - r.first_sample) * r.period_ns + s.late_ns) AS t_ms, "
    "s.x_mm, s.y_mm, s.z_mm, s.pressure, s.buttons, /tilt/0.0001 * s.asked_x AS asked_x_n, "
    "0.0001 * s.asked_y AS asked_y_n, 0.0001 * s.asked_z AS asked_z_n, "
    "0.0001 * (s.asked_x - s.cut_x) AS sent_x_n, 0.0001 * (s.asked_y - s.cut_y) AS sent_y_n, "
    "0.0001 * (s.asked_z - s.cut_z) AS sent_z_n FROM recording AS r JOIN recording_sample AS s "
    "ON s.id >= r.first_sample AND s.id < r.first_sample + r.samples",
    "CREATE VIEW recorded_events AS SELECT r.id AS recording, e.id - r.first_event AS event, "
    "e.before_sample - r.first_sample AS before_sample, 0.000001 * e.time_ns AS t_ms, e.kind, "
    "e.line FROM recording AS r JOIN recording_event AS e "
    "ON e.id >= r.first_event AND e.id < r.first_event + r.events"};

/// Placeholder for the tilt in the text of a view.
constexpr std::string_view kTiltMark = "/tilt/";

constexpr std::size_t kMaxSchemaRows = 4 * kMaxForeignTables;

bool is_small_letter(char c) noexcept {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

/// Parses a definition from the front.
class Definition {
 public:
  explicit Definition(std::string_view text) noexcept : left_(text) {}

  bool take(std::string_view word) noexcept {
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  std::string_view name() noexcept {
    if (left_.empty() || !is_small_letter(left_.front())) return {};
    return take_while([](char c) { return is_small_letter(c) || is_digit(c) || c == '_'; },
                      kMaxIdentifierBytes);
  }
  bool literal() noexcept {
    if (take("NULL")) return true;
    if (take("'")) {
      take_while([](char c) { return c >= ' ' && c <= '~' && c != '\''; }, left_.size());
      return take("'");
    }
    take("-");
    if (take_while(is_digit, left_.size()).empty()) return false;
    return !take(".") || !take_while(is_digit, left_.size()).empty();
  }
  [[nodiscard]] bool is_done() const noexcept { return left_.empty(); }

 private:
  template <class Fits>
  std::string_view take_while(Fits fits, std::size_t max_count) noexcept {
    const auto* const end = std::find_if_not(left_.begin(), left_.end(), fits);
    const auto size = std::min(static_cast<std::size_t>(end - left_.begin()), max_count);
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }
  std::string_view left_;
};

bool parse_column(Definition& in, FeltTable& table) {
  const std::string_view name = in.name();
  if (name.empty() || table.columns.size() == kMaxColumns) return false;
  table.columns.emplace_back(name);
  if (in.take(" INTEGER PRIMARY KEY")) return table.columns.size() == 1;
  if (!in.take(" INTEGER") && !in.take(" REAL") && !in.take(" TEXT") && !in.take(" BLOB")) {
    return false;
  }
  in.take(" NOT NULL");
  return !in.take(" DEFAULT ") || in.literal();
}

/// Returns true if the table has our columns, with or without additional ones after them.
bool begins_like(const FeltTable& table, const OwnTable& own) {
  const std::string_view sql = table.sql, ours = own.sql;
  return sql == ours || (sql.starts_with(ours.substr(0, ours.size() - 1)) &&
                         sql.substr(ours.size() - 1).starts_with(", "));
}

bool is_core(std::string_view name) {
  return std::any_of(kTables.begin(), kTables.end(),
                     [name](const OwnTable& own) { return own.name == name; });
}

/// Adds a table to its place in the schema.
Result<void> place(FeltSchema& schema, FeltTable table) {
  const auto is_named = [&table](const OwnTable& own) { return own.name == table.name; };
  if (const auto* own = std::find_if(kTables.begin(), kTables.end(), is_named);
      own != kTables.end()) {
    if (!begins_like(table, *own))
      return invalid_data("the table '" + table.name + "' has an unexpected definition");
    const std::array places = {&schema.drawing, &schema.layer, &schema.palette, &schema.shown,
                               &schema.stroke};
    *places[static_cast<std::size_t>(own - kTables.begin())] = std::move(table);
    return {};
  }
  if (const auto* own = std::find_if(kRecordingTables.begin(), kRecordingTables.end(), is_named);
      own != kRecordingTables.end()) {
    if (!begins_like(table, *own))
      return invalid_data("the table '" + table.name + "' has an unexpected definition");
    schema.recordings.push_back(std::move(table));
    return {};
  }
  struct PlainTable {
    std::string_view name, sql;
    bool& has;
  };
  for (const PlainTable& plain :
       {PlainTable{"material", kMaterialTable, schema.has_materials},
        PlainTable{"guide", kGuideTable, schema.has_guides},
        PlainTable{"symmetry", kSymmetryTable, schema.has_symmetries},
        PlainTable{"layer_look", kLayerLookTable, schema.has_layer_looks},
        PlainTable{"picture", kPictureTable, schema.has_pictures},
        PlainTable{"layer_blend", kLayerBlendTable, schema.has_layer_blends},
        PlainTable{"layer_group", kLayerGroupTable, schema.has_layer_groups},
        PlainTable{"key_timing", kKeyTimingTable, schema.has_key_timings},
        PlainTable{"body_edit", kBodyEditTable, schema.has_body_edits},
        PlainTable{"stroke_name", kStrokeNameTable, schema.has_stroke_names}}) {
    if (table.name != plain.name) continue;
    if (table.sql != plain.sql)
      return invalid_data("the table '" + table.name + "' has an unexpected definition");
    plain.has = true;
    return {};
  }
  if (table.name == "fill") {
    if (table.sql != kFillTable)
      return invalid_data("the table 'fill' has an unexpected definition");
    schema.has_fills = true;
    return {};
  }
  if (schema.foreign.size() == kMaxForeignTables) {
    return fail(ErrorCode::kLimitExceeded, "has more than 64 unknown tables");
  }
  schema.foreign.push_back(std::move(table));
  return {};
}

Result<void> take_row(FeltSchema& schema, const Statement& row) {
  const std::string_view type = row.text(0), name = row.text(1), on = row.text(2);
  if (type == "view") return {};
  if (type == "index") {
    return is_core(on) ? invalid_data("has an index by another program") : Result<void>();
  }
  if (type != "table") return invalid_data("has triggers, which are not allowed in a drawing");
  Result<FeltTable> table = parse_table(row.text(3));
  if (!table || table->name != name || name != on) {
    return invalid_data("has an unknown table: '" + std::string(name.substr(0, 100)) + "'");
  }
  return place(schema, *std::move(table));
}

}  // namespace

const OwnTable& own_table(std::string_view name) {
  const auto is_named = [name](const OwnTable& own) { return own.name == name; };
  if (const auto* own = std::find_if(kTables.begin(), kTables.end(), is_named);
      own != kTables.end()) {
    return *own;
  }
  const auto* own = std::find_if(kRecordingTables.begin(), kRecordingTables.end(), is_named);
  FELT_CHECK(own != kRecordingTables.end());
  return *own;
}

std::string FeltTable::beyond(std::size_t ours) const {
  std::string names;
  for (std::size_t i = ours; i < columns.size(); ++i) names += ", \"" + columns[i] + "\"";
  return names;
}

bool FeltSchema::has_extras() const noexcept {
  const auto has_more = [](const FeltTable& table) {
    return table.columns.size() > own_table(table.name).columns;
  };
  return !recordings.empty() || !foreign.empty() || has_more(drawing) || has_more(layer) ||
         has_more(stroke);
}

Result<void> make_tables(Database& database, const FeltSchema* like) {
  for (const OwnTable& own : kTables) {
    std::string sql(own.sql);
    if (like && own.name == "drawing") sql = like->drawing.sql;
    if (like && own.name == "layer") sql = like->layer.sql;
    if (like && own.name == "stroke") sql = like->stroke.sql;
    if (auto ok = database.run(sql.c_str()); !ok) return ok;
  }
  return {};
}

bool has_tilt(const FeltTable& table) {
  for (const auto& [name, column] : kTiltColumns) {
    if (table.name != name) continue;
    const std::string part = std::string(", ") + column;
    return table.sql.ends_with(part + ")") || table.sql.find(part + ", ") != std::string::npos;
  }
  return false;
}

Result<void> make_recording_tables(Database& database, const FeltSchema* like, bool with_tilt) {
  bool has_tilts = false;
  for (std::size_t i = 0; i < kRecordingTables.size(); ++i) {
    FeltTable table{
        std::string(kRecordingTables[i].name), std::string(kRecordingTables[i].sql), {}};
    if (like && i < like->recordings.size()) table.sql = like->recordings[i].sql;
    for (const auto& [name, column] : kTiltColumns) {
      if (!with_tilt || table.name != name || has_tilt(table)) continue;
      table.sql.replace(table.sql.size() - 1, 1, std::string(", ") + column + ")");
    }
    has_tilts = has_tilt(table);  // of the last one, the table of samples
    if (auto ok = database.run(table.sql.c_str()); !ok) return ok;
  }
  for (std::string view : kRecordingViews) {
    if (const std::size_t at = view.find(kTiltMark); at != std::string::npos) {
      view.replace(at, kTiltMark.size(), has_tilts ? "s.lean_deg, " : "");
    }
    if (auto ok = database.run(view.c_str()); !ok) return ok;
  }
  return {};
}

Result<FeltTable> parse_table(std::string_view sql) {
  Definition in(sql);
  FeltTable table;
  table.sql = std::string(sql);
  bool good = in.take("CREATE TABLE ");
  table.name = std::string(in.name());
  good = good && !table.name.empty() && in.take("(");
  do good = good && parse_column(in, table);
  while (good && in.take(", "));
  if (!good || !in.take(")") || !in.is_done()) return invalid_data("is not an ordinary table");
  std::vector<std::string> names = table.columns;
  std::sort(names.begin(), names.end());
  if (std::adjacent_find(names.begin(), names.end()) != names.end())
    return invalid_data("is not a table");
  return table;
}

Result<FeltSchema> read_schema(const Database& database) {
  const auto row =
      database.prepare("SELECT type, name, tbl_name, sql FROM sqlite_schema ORDER BY name");
  if (!row) return tl::unexpected(with_context(row.error(), "is damaged or incomplete"));
  FeltSchema schema;
  for (std::size_t rows = 0;; ++rows) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(with_context(more.error(), "is damaged or incomplete"));
    if (!*more) break;
    if (rows == kMaxSchemaRows) {
      return fail(ErrorCode::kLimitExceeded, "has more tables and views than a drawing may have");
    }
    if (auto ok = take_row(schema, *row); !ok) return tl::unexpected(ok.error());
  }
  for (const FeltTable* table :
       {&schema.drawing, &schema.layer, &schema.palette, &schema.shown, &schema.stroke}) {
    if (table->name.empty()) return invalid_data("does not have the tables of a Feltline drawing");
  }
  if (schema.palette.columns.size() > own_table("palette").columns ||
      schema.shown.columns.size() > own_table("shown").columns) {
    return invalid_data("does not have the tables of a Feltline drawing");
  }
  if (!schema.recordings.empty() && schema.recordings.size() != kRecordingTables.size()) {
    return invalid_data("has only some of the tables of recordings");
  }
  return schema;
}

}  // namespace felt
