#include "cases/app/section_picture.hpp"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "cases/app/plot_script.hpp"

namespace velum::cases {
namespace {

std::vector<std::string> pythons()
{
  if (char const* chosen = std::getenv("PYTHON")) return {chosen};
  return {"/usr/bin/python3", "python3"};
}

}  // namespace

bool draw_section(std::filesystem::path const& lines, std::filesystem::path const& cells,
                  std::filesystem::path const& picture)
{
  std::error_code ignored;
  std::filesystem::remove(picture, ignored);  // an older one must not pass for this one
  std::string const script = plot_script(section_script).string();
  for (auto const& python : pythons())
    if (succeeds({python, script, lines.string(), cells.string(), picture.string()}, Voice::silent))
      return true;
  return false;
}

}  // namespace velum::cases
