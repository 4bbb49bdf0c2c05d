#pragma once

#include <string>
#include <vector>

#include "felt/studies/export/data_table.h"
#include "felt/studies/export/hypothesis_results.h"

namespace felt {

/// One row of hypotheses.csv.
struct HypothesisRow {
  std::string text;  ///< "H1: err_mean_mm is smaller in ..."
  SessionKind session = SessionKind::kTrain;
  HypothesisResult result;
};

/// Returns the rows of hypotheses.csv, one for each hypothesis of the study.
std::vector<HypothesisRow> hypothesis_rows(const StudyResults& results);

/// Returns the columns of hypotheses.csv. The scripts read the first seven and test again.
std::vector<DataColumn<HypothesisRow>> hypothesis_columns();

}  // namespace felt
