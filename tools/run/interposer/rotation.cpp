#include "run/interposer/rotation.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "run/interposer/report.h"
#include "run/settings.h"

namespace polhode::run {

namespace {

constexpr int kLongestPath = 4096;

// Writes the path of a file in the folder of this library. Returns false if the path is too long.
bool path_beside_this_library(const char* file, char (&path)[kLongestPath]) {
  Dl_info library;
  if (dladdr(reinterpret_cast<void*>(&path_beside_this_library), &library) == 0) return false;
  const char* const slash = std::strrchr(library.dli_fname, '/');
  const int folder = slash == nullptr ? 0 : static_cast<int>(slash + 1 - library.dli_fname);
  const int length = std::snprintf(path, kLongestPath, "%.*s%s", folder, library.dli_fname, file);
  return length > 0 && length < kLongestPath;
}

const Adapter* load_adapter(const char* file) {
  char path[kLongestPath];
  if (!path_beside_this_library(file, path)) return nullptr;
  void* const handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    report(dlerror());
    return nullptr;
  }
  const auto get_adapter = reinterpret_cast<GetAdapter>(dlsym(handle, kGetAdapter));
  return get_adapter == nullptr ? nullptr : get_adapter();
}

void report_other_bullet(const Precision& precision, const void* function) {
  char line[1024];
  const bool has_adapter = *precision.expected_bullet != '\0';
  std::snprintf(line, sizeof line,
                "the program's %s-precision Bullet is in %s, and %s%s; its worlds are left to Bullet",
                precision.name, file_of(function),
                has_adapter ? "expected is " : "this polhode-run was built without that precision",
                precision.expected_bullet);
  report(line);
}

class Lock {
 public:
  Lock() { pthread_mutex_lock(&mutex); }
  ~Lock() { pthread_mutex_unlock(&mutex); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  static pthread_mutex_t mutex;
};

pthread_mutex_t Lock::mutex = PTHREAD_MUTEX_INITIALIZER;

Rotation rotations[] = {Rotation(kSinglePrecision), Rotation(kDoublePrecision)};

}  // namespace

Rotation& rotation_in(int precision_index) {
  return rotations[precision_index];
}

bool Rotation::before_step(void* world) {
  const void* const function = function_behind(precision_.step_function, world);
  {
    const Lock lock;
    if (!is_started_) start(function);
    if (adapter_ == nullptr || function != rotated_function_) {
      ++calls_left_alone_;
      return false;
    }
  }
  return adapter_->before_step(world);
}

void Rotation::start(const void* function) {
  is_started_ = true;
  if (!is_of_expected_bullet(precision_, function)) {
    report_other_bullet(precision_, function);
    return;
  }
  const Adapter* const adapter = load_adapter(precision_.adapter_file);
  if (adapter == nullptr) return;
  const char* const scheme = std::getenv(kSchemeVariable);
  if (!adapter->start(scheme == nullptr ? "exact" : scheme, report)) return;
  adapter_ = adapter;
  rotated_function_ = function;
}

}  // namespace polhode::run
