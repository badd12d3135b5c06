#include "cases/app/section_picture.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace velum::cases {
namespace {

/// Runs a program to its end without letting it speak; true when it says that all went well.
bool succeeds(std::vector<std::string> words)
{
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (int const stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  bool const started = posix_spawnp(&child, argv[0], &quiet, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&quiet);
  int status = 0;
  return started && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

std::vector<std::string> pythons()
{
  if (char const* chosen = std::getenv("PYTHON")) return {chosen};
  return {"/usr/bin/python3", "python3"};
}

}  // namespace

std::filesystem::path section_script() { return VELUM_PLOT_FOLDER "/stl_section.py"; }

bool draw_section(std::filesystem::path const& lines, std::filesystem::path const& cells,
                  std::filesystem::path const& picture)
{
  std::error_code ignored;
  std::filesystem::remove(picture, ignored);  // an older one must not pass for this one
  for (auto const& python : pythons())
    if (succeeds(
            {python, section_script().string(), lines.string(), cells.string(), picture.string()}))
      return true;
  return false;
}

}  // namespace velum::cases
