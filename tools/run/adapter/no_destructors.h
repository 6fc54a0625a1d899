#pragma once

/// Stands in for the C++ runtime's function of that name within this library, which alone sees it.
extern "C" __attribute__((visibility("hidden"))) int __cxa_atexit(void (*destructor)(void*), void* object,
                                                                  void* library);
