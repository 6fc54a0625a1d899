#include "demos/compare/command.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

namespace polhode::demos {

namespace {

void redirect(int descriptor, const std::filesystem::path& file) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(opened, descriptor);
  ::close(opened);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

[[noreturn]] void become(std::vector<std::string> words, std::vector<std::string> environment) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  for (std::string& setting : environment) ::putenv(setting.data());
  ::execv(pointers[0], pointers.data());
  ::_exit(127);
}

}  // namespace

void expect_refused_in_one_line(const CommandResult& result) {
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(std::count(result.standard_error.begin(), result.standard_error.end(), '\n'), 1)
      << result.standard_error;
}

Command::Command(const std::string& program, const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment, const std::function<void()>& prepare) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  process_ = ::fork();
  if (process_ != 0) return;
  redirect(STDOUT_FILENO, output_ / "out");
  redirect(STDERR_FILENO, output_ / "err");
  prepare();
  become(words, environment);
}

void Command::send_signal(int signal) const {
  ::kill(process_, signal);
}

CommandResult Command::wait() {
  int status = 0;
  rusage usage{};
  ::wait4(process_, &status, 0, &usage);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_file(output_ / "out"),
          read_file(output_ / "err"), seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024.0};
}

}  // namespace polhode::demos
