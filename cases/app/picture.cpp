#include "cases/app/picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>

#include "cases/app/plot_script.hpp"

namespace velum::cases {

void draw(std::string const& script, std::filesystem::path const& folder,
          std::vector<std::string> const& more)
{
  std::vector<std::string> words{setting("PYTHON", "/usr/bin/python3"),
                                 plot_script(script).string(), folder.string()};
  words.insert(words.end(), more.begin(), more.end());
  std::fflush(stdout);
  if (succeeds(words, Voice::heard)) return;
  fmt::print(stderr, "The picture was not drawn; with matplotlib, {} draws it.\n",
             fmt::join(words, " "));
}

}  // namespace velum::cases
