#include "cases/app/plot_script.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace velum::cases {

std::string setting(char const* variable, char const* otherwise)
{
  char const* value = std::getenv(variable);
  return value && *value ? value : otherwise;
}

std::filesystem::path plot_script(std::string const& name)
{
  return std::filesystem::path(setting("VELUM_PLOT", VELUM_PLOT_DIR)) / name;
}

bool succeeds(std::vector<std::string> words, Voice voice)
{
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  if (voice == Voice::silent)
    for (int const stream : {STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  bool const started = posix_spawnp(&child, argv[0], &streams, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&streams);
  int status = 0;
  return started && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

}  // namespace velum::cases
