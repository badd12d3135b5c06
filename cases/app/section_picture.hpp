#pragma once
#include <filesystem>

namespace velum::cases {

/// The script that draws, of cases/plot.
constexpr char const* section_script = "stl_section.py";

/// Draws the tables of a section with section_script, by the Python that $PYTHON names,
/// by /usr/bin/python3 (where Debian puts matplotlib) or by the first python3 of the path.
/// @return false where none of them can: there is no Python, or no matplotlib
bool draw_section(std::filesystem::path const& lines, std::filesystem::path const& cells,
                  std::filesystem::path const& picture);

}  // namespace velum::cases
