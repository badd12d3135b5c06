#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace velum::core {

/// What a run assumed or chose by itself, in words: name -> sentence.
using Assumptions = std::map<std::string, std::string>;

/// One figure of a run's verdict. The unit is SI, "1" for a plain number.
struct Figure {
  std::string name;
  double value;
  std::string unit;
};

/// What summary.json holds.
struct Summary {
  std::vector<Figure> figures;
  Assumptions assumptions;
};

/// The summary as JSON: {"name": {"value": 0.9999, "unit": "1"}, ..., "assumptions": {...}}, the
/// figures in their order. Numbers have every digit needed to read the same double back; null where
/// the value is not finite.
/// @throws InputError  two figures of one name
std::string to_json(Summary const& summary);

/// Writes to_json() at once (see write_atomically).
void write_summary(std::filesystem::path const& file, Summary const& summary);

/// Reads back what write_summary() wrote; a figure that is null there is not a number.
/// @throws InputError  the file cannot be read, or is no such summary
Summary read_summary(std::filesystem::path const& file);

}  // namespace velum::core
