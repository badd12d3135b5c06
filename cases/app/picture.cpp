#include "cases/app/picture.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cases/app/plot_script.hpp"

namespace velum::cases {

void draw(std::string const& script, std::filesystem::path const& folder)
{
  std::string const python = setting("PYTHON", "/usr/bin/python3");
  auto const file = plot_script(script);
  std::fflush(stdout);
  if (succeeds({python, file.string(), folder.string()}, Voice::heard)) return;
  fmt::print(stderr, "The picture was not drawn; with matplotlib, {} {} {} draws it.\n", python,
             file.string(), folder.string());
}

}  // namespace velum::cases
