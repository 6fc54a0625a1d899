// Writes the summary when the process calls exit() or returns from main.
#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cinttypes>
#include <cstdlib>
#include <cstring>

#include "run/interposer/report.h"
#include "run/interposer/rotation.h"
#include "run/interposer/text.h"
#include "run/settings.h"

namespace polhode::run {

namespace {

const char* setting(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// "2 worlds", "1 multibody".
void add_count(Text& text, std::uint64_t count, const char* one, const char* several) {
  text.add("%" PRIu64 " %s", count, count == 1 ? one : several);
}

void add_incidents(Text& text, const Counts& counts) {
  if (counts.diverged_bodies == 0 && counts.non_finite_bodies == 0) {
    text.add("  incidents: none\n");
    return;
  }
  text.add("  incidents: ");
  add_count(text, counts.diverged_bodies, "body whose scheme diverged, ", "bodies whose scheme diverged, ");
  add_count(text, counts.non_finite_bodies, "body that was not finite\n", "bodies that were not finite\n");
}

void add_rotated_worlds(Text& text, const Counts& counts) {
  if (counts.rotated_worlds == 0) return;
  text.add("  bodies, most in one world: ");
  add_count(text, counts.most_rigid_bodies, "rigid body, ", "rigid bodies, ");
  add_count(text, counts.most_multibodies, "multibody\n", "multibodies\n");
  text.add("  steps: %" PRIu64 "\n", counts.steps);
  add_incidents(text, counts);
}

void add_precision(Text& text, const Rotation& rotation) {
  const Counts counts = rotation.counts();
  if (counts.rotated_worlds + counts.worlds_left_to_bullet > 0) {
    text.add("  worlds in %s precision: %" PRIu64 " rotated, %" PRIu64 " left to Bullet\n",
             rotation.precision().name, counts.rotated_worlds, counts.worlds_left_to_bullet);
  }
  add_rotated_worlds(text, counts);
  if (rotation.calls_left_alone() > 0) {
    text.add("  left alone in %s precision: %" PRIu64 " calls of stepSimulation\n", rotation.precision().name,
             rotation.calls_left_alone());
  }
}

// Returns a number that grows with each step.
std::uint64_t activity_of(const Rotation& rotation) {
  const Counts counts = rotation.counts();
  return counts.rotated_worlds + counts.worlds_left_to_bullet + counts.steps + rotation.calls_left_alone();
}

std::uint64_t activity() {
  return activity_of(rotation_in(0)) + activity_of(rotation_in(1));
}

bool has_waited_for_other_processes() {
  rusage usage{};
  return getrusage(RUSAGE_CHILDREN, &usage) == 0 && usage.ru_maxrss > 0;
}

void add_reasons_for_no_world(Text& text) {
  text.add("  no world was stepped in this process, so nothing was rotated\n");
  if (has_waited_for_other_processes()) {
    text.add("  processes that it started and that stepped worlds have summaries of their own\n");
    return;
  }
  text.add(
      R"(  possible reasons: the program creates no Bullet world; Bullet is linked statically into it or into
  one of its libraries, or linked with -Bsymbolic; this Bullet has no btDiscreteDynamicsWorld::stepSimulation
)");
}

void write_summary(const char* text) {
  const char* const target = setting(kSummaryVariable);
  if (std::strcmp(target, kToStandardError) == 0) {
    write_all(STDERR_FILENO, text);
    return;
  }
  const int file = open(target, O_WRONLY | O_APPEND | O_CLOEXEC);
  const bool is_written = file >= 0 && write_all(file, text);
  const int reason = errno;
  if (file >= 0) close(file);
  if (is_written) return;
  Text line;
  line.add("%s: the summary cannot be written: %s", target, std::strerror(reason));
  report(line.c_str());
}

// Prevents a forked process that steps nothing from repeating the summary of its parent.
std::uint64_t activity_before_fork = 0;
void note_fork() {
  activity_before_fork = activity();
}

__attribute__((constructor)) void watch_forks() {
  pthread_atfork(nullptr, nullptr, note_fork);
}

// Runs after the program's own exit functions and static destructors.
__attribute__((destructor)) void summarize() {
  if (*setting(kSummaryVariable) == '\0') return;
  const bool is_first_process = std::atoi(setting(kProcessVariable)) == getpid();
  const bool has_stepped = activity() > activity_before_fork;
  if (!is_first_process && !has_stepped) return;
  Text text;
  text.add("polhode-run: %s (process %d), scheme %s", program_invocation_short_name, getpid(),
           setting(kSchemeVariable));
  text.make_printable();
  text.add("\n");
  if (has_stepped) {
    add_precision(text, rotation_in(0));
    add_precision(text, rotation_in(1));
  } else {
    add_reasons_for_no_world(text);
  }
  write_summary(text.c_str());
}

}  // namespace

}  // namespace polhode::run
