#include "cases/app/picture.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace velum::cases {
namespace {

std::string setting(char const* variable, char const* otherwise)
{
  char const* value = std::getenv(variable);
  return value && *value ? value : otherwise;
}

/// Exit code of a program, -1 where it could not be run.
int run_program(std::vector<std::string> words)
{
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

void draw(std::string const& script, std::filesystem::path const& folder)
{
  std::string const python = setting("PYTHON", "/usr/bin/python3");
  auto const file = std::filesystem::path(setting("VELUM_PLOT", VELUM_PLOT_DIR)) / script;
  std::fflush(stdout);
  if (run_program({python, file.string(), folder.string()}) == 0) return;
  fmt::print(stderr, "The picture was not drawn; with matplotlib, {} {} {} draws it.\n", python,
             file.string(), folder.string());
}

}  // namespace velum::cases
