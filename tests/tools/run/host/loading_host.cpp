// A simulator without Bullet until it loads its plugins: loading_host LIBRARY...
#include <dlfcn.h>

#include <cstdio>

int main(int argument_count, char** arguments) {
  for (int i = 1; i < argument_count; ++i) {
    void* const library = dlopen(arguments[i], RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      std::fprintf(stderr, "%s\n", dlerror());
      return 1;
    }
    const auto step = reinterpret_cast<double (*)()>(dlsym(library, "step_hidden_world"));
    std::printf("energy ratio %.17g\n", step());
  }
  return 0;
}
