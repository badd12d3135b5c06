#include "cases/app/history.hpp"

#include <fstream>
#include <sstream>

#include "core/check.hpp"

namespace velum::cases {

History read_history(std::filesystem::path const& file)
{
  History history;
  std::ifstream in(file);
  std::string line, cell;
  core::require(static_cast<bool>(std::getline(in, line)), file.string() + " cannot be read.");
  std::istringstream head(line);
  std::getline(head, cell, ',');  // the time
  while (std::getline(head, cell, ',')) {
    auto const at = cell.find(" [");
    history.columns.push_back({cell.substr(0, at), cell.substr(at + 2, cell.size() - at - 3)});
  }
  while (std::getline(in, line)) {
    std::istringstream row(line);
    std::getline(row, cell, ',');
    history.time.push_back(std::stod(cell));
    auto& values = history.rows.emplace_back();
    while (std::getline(row, cell, ',')) values.push_back(std::stod(cell));
  }
  return history;
}

}  // namespace velum::cases
