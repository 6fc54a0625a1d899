#include "run/adapter/no_destructors.h"

// Keeps the static objects of this library alive. It is loaded when the program's first world steps, so its
// destructors would run before those of the program's static objects; a world among these tells its plugin of
// its end, and the plugin needs the library's list of worlds.
int __cxa_atexit(void (* /*destructor*/)(void*), void* /*object*/, void* /*library*/) {
  return 0;
}
