#include "core/log.hpp"

#include "core/check.hpp"

#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <utility>

namespace velum::core {
namespace {

/// Says of a warning, and of what is worse, what it is; says nothing of all else.
class Warning : public spdlog::custom_flag_formatter {
 public:
  void format(spdlog::details::log_msg const& message, std::tm const&,
              spdlog::memory_buf_t& to) override
  {
    if (message.level < spdlog::level::warn) return;
    std::string const word = fmt::format("{}: ", spdlog::level::to_string_view(message.level));
    to.append(word.data(), word.data() + word.size());
  }
  std::unique_ptr<spdlog::custom_flag_formatter> clone() const override
  {
    return std::make_unique<Warning>();
  }
};

}  // namespace

void start_log(std::filesystem::path const& folder, Console console, bool append)
{
  auto const file_name = folder / "log.txt";
  auto to_console = std::make_shared<spdlog::sinks::stdout_sink_mt>();
  auto words = std::make_unique<spdlog::pattern_formatter>();
  words->add_flag<Warning>('*').set_pattern("%*%v");
  to_console->set_formatter(std::move(words));
  to_console->set_level(console == Console::quiet ? spdlog::level::warn : spdlog::level::trace);

  std::shared_ptr<spdlog::sinks::basic_file_sink_mt> to_file;
  try {
    to_file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file_name.string(), !append);
  } catch (spdlog::spdlog_ex const&) {
    throw InputError("The log " + file_name.string() + " cannot be written.");
  }
  to_file->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");

  auto logger = std::make_shared<spdlog::logger>(
      "velum", spdlog::sinks_init_list{std::move(to_console), std::move(to_file)});
  logger->flush_on(spdlog::level::trace);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace velum::core
