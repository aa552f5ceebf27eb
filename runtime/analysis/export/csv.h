// Comma-separated values (RFC 4180, with lines that end as Unix' do).
#pragma once

#include <string>
#include <vector>

#include "runtime/analysis/export/episode_table.h"

namespace runtime {

struct TableOfRun {
  std::string run;  // its folder's name among others
  EpisodeTable table;
};

// A line of names, then one for each episode: its run, if there are many, its number, how and why
// it ended, and the columns of all tables. Numbers are the record's own, every digit of them; what
// is not there is empty.
std::string CsvOf(const std::vector<TableOfRun>& runs);

// A line with the columns' names, then the rows, each with a number for each column.
std::string CsvOf(const std::vector<std::string>& columns,
                  const std::vector<std::vector<double>>& rows);

}  // namespace runtime
