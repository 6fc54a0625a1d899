#pragma once

#include <vector>

#include "polhode/scheme_registry.h"
#include "polhode/version.h"

/// Defines a shared library of rotation schemes, which the demos load and show beside the built-in ones:
///
///   #include <polhode/scheme_library.h>
///   class MyScheme final : public polhode::RotationScheme { ... };
///   POLHODE_SCHEME_LIBRARY(std::make_shared<MyScheme>())
///
///   g++ -std=c++17 -O2 -shared -fPIC my_scheme.cpp -o my_scheme.so $(pkg-config --cflags --libs polhode)
///   polhode_compare --scheme-library my_scheme.so
///
/// Use the macro once in a library, outside any namespace. A program loads only libraries compiled with
/// headers of its own major and minor version.

#if defined(_WIN32)
#define POLHODE_SCHEME_LIBRARY_EXPORT __declspec(dllexport)
#else
#define POLHODE_SCHEME_LIBRARY_EXPORT __attribute__((visibility("default")))
#endif

/// @param ... the schemes; each argument is a polhode::SchemePointer, or converts to one
#define POLHODE_SCHEME_LIBRARY(...)                                               \
  extern "C" POLHODE_SCHEME_LIBRARY_EXPORT int polhode_scheme_library_version() { \
    return POLHODE_VERSION;                                                       \
  }                                                                               \
  extern "C" POLHODE_SCHEME_LIBRARY_EXPORT void polhode_scheme_library(           \
      std::vector<polhode::SchemePointer>& schemes) {                             \
    schemes = {__VA_ARGS__};                                                      \
  }
