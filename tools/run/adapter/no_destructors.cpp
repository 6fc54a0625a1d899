// Keeps the static objects of this library alive by replacing the C++ runtime's function that registers
// destructors. The library is loaded when the program's first world steps, so its destructors would run
// before those of the program's static objects. Such an object may destroy a world, or even create one, which
// needs the library's list of worlds.
extern "C" __attribute__((visibility("hidden"))) int register_no_destructor(void (*)(void*), void*,
                                                                            void*) __asm__("__cxa_atexit");

int register_no_destructor(void (* /*destructor*/)(void*), void* /*object*/, void* /*library*/) {
  return 0;
}
