// Writes the texts of the library's tables as a source that lupdate reads. Usage: make_texts FILE.
// translations/update.sh calls it. The library contains these texts only in English; the program
// translates them when it shows them (engine/tool_texts.h).
#include <QtGlobal>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "felt/material/material_fields.h"
#include "felt/material/materials.h"
#include "felt/session/surface_options.h"
#include "felt/tools/tool.h"

namespace felt {
namespace {

/// Labels of the edits that are not made by tools.
constexpr const char* kEdits[] = {
    QT_TRANSLATE_NOOP("edits", "Add layer"),
    QT_TRANSLATE_NOOP("edits", "Delete"),
    QT_TRANSLATE_NOOP("edits", "Duplicate"),
    QT_TRANSLATE_NOOP("edits", "Hide layer"),
    QT_TRANSLATE_NOOP("edits", "Import"),
    QT_TRANSLATE_NOOP("edits", "Lock layer"),
    QT_TRANSLATE_NOOP("edits", "Lower layer"),
    QT_TRANSLATE_NOOP("edits", "Move layer"),
    QT_TRANSLATE_NOOP("edits", "Raise layer"),
    QT_TRANSLATE_NOOP("edits", "Remove layer"),
    QT_TRANSLATE_NOOP("edits", "Rename layer"),
    QT_TRANSLATE_NOOP("edits", "Restyle"),
    QT_TRANSLATE_NOOP("edits", "Show layer"),
    QT_TRANSLATE_NOOP("edits", "Unlock layer"),
    QT_TRANSLATE_NOOP("edits", "Layer opacity"),
    QT_TRANSLATE_NOOP("edits", "Duplicate layer"),
    QT_TRANSLATE_NOOP("edits", "Merge layers"),
    QT_TRANSLATE_NOOP("edits", "Add picture"),
    QT_TRANSLATE_NOOP("edits", "Place picture"),
    QT_TRANSLATE_NOOP("edits", "Export picture"),
    QT_TRANSLATE_NOOP("edits", "Layer blend mode"),
    QT_TRANSLATE_NOOP("edits", "Group layers"),
    QT_TRANSLATE_NOOP("edits", "Ungroup layers"),
    QT_TRANSLATE_NOOP("edits", "Motion timing"),
    QT_TRANSLATE_NOOP("edits", "Correct matches"),
    QT_TRANSLATE_NOOP("edits", "Edit the body"),
    QT_TRANSLATE_NOOP("edits", "Remove edit of the body"),
    QT_TRANSLATE_NOOP("edits", "Remove edits of the body"),
    QT_TRANSLATE_NOOP("edits", "Remove guides"),
    QT_TRANSLATE_NOOP("edits", "Show guides"),
    QT_TRANSLATE_NOOP("edits", "Hide guides"),
    QT_TRANSLATE_NOOP("edits", "Unlink"),
    QT_TRANSLATE_NOOP("edits", "Make exact"),
};

/// The set of texts of one translation context.
using Texts = std::set<std::string, std::less<>>;

void add(Texts& texts, std::string_view text) {
  if (!text.empty()) texts.emplace(text);
}

/// Adds the texts of options and of the fields of materials.
template <class Row>
void add_table(Texts& texts, std::span<const Row> table) {
  for (const Row& row : table) {
    add(texts, row.label);
    add(texts, row.help);
    for (const std::string_view choice : row.choices) add(texts, choice);
  }
}

void add_tool(Texts& texts, const ToolInfo& tool) {
  add(texts, tool.label);
  add(texts, tool.help);
  add(texts, tool.act.title);
  add(texts, tool.act.caption);
  for (const ToolAct& act : tool.more_acts) {
    add(texts, act.title);
    add(texts, act.caption);
  }
  for (const ToolUse& use : tool.uses) {
    for (const std::string_view text :
         {use.hint, use.first_modifier, use.second_modifier, use.third_modifier}) {
      add(texts, text);
    }
  }
  add_table(texts, tool.options);
}

void write(std::ostream& out, const char* context, const Texts& texts) {
  for (const std::string& text : texts) {
    out << "QT_TRANSLATE_NOOP(\"" << context << "\", \"";
    for (const char c : text) out << (c == '"' || c == '\\' ? "\\" : "") << c;
    out << "\"),\n";
  }
}

bool write_all(const char* path) {
  Texts tables, edits(std::begin(kEdits), std::end(kEdits));
  for (const auto& tool : make_tools()) {
    add_tool(tables, tool->info());
    edits.insert(tool->info().edits.begin(), tool->info().edits.end());
  }
  add_table(tables, SurfaceOptions::table());
  add_table(tables, surface_fields());
  add_table(tables, medium_fields());
  for (const SurfaceMaterial& material : surface_materials()) add(tables, material.label);
  std::ofstream out(path);
  out << "const char* const kTexts[] = {\n";
  write(out, "tools", tables);
  write(out, "edits", edits);
  out << "};\n";
  return static_cast<bool>(out.flush());
}

}  // namespace
}  // namespace felt

int main(int argc, char** argv) {
  if (argc == 2 && felt::write_all(argv[1])) return 0;
  std::fprintf(stderr, "usage: make_texts FILE, which must be writable\n");
  return 1;
}
