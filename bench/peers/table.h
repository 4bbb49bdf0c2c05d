#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench/peers/measure.h"

namespace felt::bench {

/// Prints the comparison at one tolerance as a Markdown table.
void print_table(std::FILE* out, const std::vector<Row>& rows);

/// Prints one Markdown table per source of the data. It shows if a fitter is tuned to one kind of
/// ink.
void print_sources(std::FILE* out, const std::vector<Row>& rows);

/// Writes all rows as CSV, with separate rows for the sources.
void write_csv(const std::string& path, const std::vector<Row>& rows);

}  // namespace felt::bench
