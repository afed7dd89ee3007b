// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/process/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <mutex>
#include <thread>

#include "base/invalid_input.h"

namespace powderlink {

namespace {

using Clock = std::chrono::steady_clock;

// A signal handler may only touch lock-free atomics: one slot per running child.
constexpr std::size_t kMostChildren = 256;
std::array<std::atomic<pid_t>, kMostChildren> running{};
constexpr auto kPoll = std::chrono::milliseconds(5);
constexpr auto kGrace = std::chrono::seconds(3);

extern "C" void end_children(int signal_number) {
  for (auto& pid : running) {
    const pid_t child = pid.load();
    if (child > 0) ::kill(child, SIGTERM);
  }
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

void install_handler() {
  static std::once_flag once;
  std::call_once(once, [] {
    struct sigaction action {};
    action.sa_handler = end_children;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    ::sigaction(SIGHUP, &action, nullptr);
  });
}

/// Keeps the child known to the handler for as long as it runs.
class Slot {
 public:
  explicit Slot(pid_t child) {
    for (auto& place : running) {
      pid_t none = 0;
      if (place.compare_exchange_strong(none, child)) {
        place_ = &place;
        return;
      }
    }
  }
  ~Slot() {
    if (place_ != nullptr) place_->store(0);
  }
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;

 private:
  std::atomic<pid_t>* place_ = nullptr;
};

}  // namespace

ChildOutcome run_child(const std::vector<std::string>& command, const std::filesystem::path& folder,
                       const std::filesystem::path& output_file, double wall_limit_s) {
  install_handler();
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output_file.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int problem = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) {
    throw InvalidInput("starting a program", command[0], "a program that can be run",
                       std::string(std::strerror(problem)) + "; check its path");
  }

  const Slot slot(child);
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  ChildOutcome outcome;
  int status = 0;
  auto kill_at = Clock::time_point::max();
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (!outcome.over_time && seconds() > wall_limit_s) {
      outcome.over_time = true;
      ::kill(child, SIGTERM);
      kill_at = Clock::now() + kGrace;
    } else if (Clock::now() > kill_at) {
      ::kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(kPoll);
  }
  outcome.wall_s = seconds();
  outcome.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

}  // namespace powderlink
