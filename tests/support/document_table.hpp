// document_table: rows of a table in a Markdown document, for tests that keep the document true.
//
//   rows_below(file, "## Formats")   the cells of each row of the first table below that heading, without its header and rule;
//                                    throws std::runtime_error when there is no such file, heading or table
#pragma once
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace relievo::test {

inline std::vector<std::string> cells_of(std::string const& line) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size()) {
      cell += line[++i];
    } else if (line[i] == '|') {
      const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

inline std::vector<std::vector<std::string>> rows_below(std::string const& file, std::string const& heading) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  std::string line;
  while (std::getline(in, line) && line != heading) continue;
  std::vector<std::vector<std::string>> rows;
  while (std::getline(in, line) && line.rfind("## ", 0) != 0) {
    const bool in_table = !line.empty() && line[0] == '|';
    if (in_table)
      rows.push_back(cells_of(line));
    else if (!rows.empty())
      break;
  }
  if (rows.size() < 3) throw std::runtime_error(file + ": no table below '" + heading + "'");
  rows.erase(rows.begin(), rows.begin() + 2);
  return rows;
}

}  // namespace relievo::test
