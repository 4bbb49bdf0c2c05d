#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/base/csv_value.h"
#include "felt/studies/export/study_results.h"

namespace felt {

/// What a data dictionary says about a column.
struct ColumnInfo {
  std::string name;
  std::string description;
  std::string unit = {};    ///< empty for text; "1" for a number without a unit
  std::string source = {};  ///< a DOI, or empty
  std::vector<std::pair<std::string, std::string>> levels = {};  ///< values and their meaning
};

/// A column of a table with one row for each `Row`. A missing value is an empty text.
template <class Row>
struct DataColumn {
  ColumnInfo info;
  std::function<std::string(const Row&)> text;
};

/// Returns a fingerprint of the study and of the files that it names: "fnv1a-" and 16 hexadecimal
/// digits. The name of the study counts, too; in a folder with results it is kStudyFileName.
std::string study_hash(const StudyFiles& files);

/// Returns the columns of trials.csv, one row for each attempt of a trial. `results` must outlive
/// them.
std::vector<DataColumn<MeasuredTrial>> trial_columns(const StudyResults& results);
/// Returns the columns of answers.csv, one row for each questionnaire.
std::vector<DataColumn<GivenAnswers>> answer_columns(const StudyResults& results);

/// Returns the data dictionary as JSON, in the form of the BIDS sidecar files: for each column its
/// description, unit, levels and source.
std::string dictionary_text(std::span<const ColumnInfo> columns);

template <class Row>
std::string csv_text(const std::vector<DataColumn<Row>>& columns, const std::vector<Row>& rows) {
  std::string out;
  const auto append_line = [&](const auto& value_of) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) out += ',';
      append_csv_value(out, value_of(columns[i]));
    }
    out += '\n';
  };
  append_line([](const DataColumn<Row>& column) { return column.info.name; });
  for (const Row& row : rows) {
    append_line([&](const DataColumn<Row>& column) { return column.text(row); });
  }
  return out;
}

template <class Row>
std::vector<ColumnInfo> infos_of(const std::vector<DataColumn<Row>>& columns) {
  std::vector<ColumnInfo> infos;
  infos.reserve(columns.size());
  for (const DataColumn<Row>& column : columns) infos.push_back(column.info);
  return infos;
}

}  // namespace felt
