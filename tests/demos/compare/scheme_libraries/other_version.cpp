// A library compiled with headers of another minor version.
#include <polhode/scheme_library.h>

#undef POLHODE_VERSION
#define POLHODE_VERSION 9900  // 0.99
POLHODE_SCHEME_LIBRARY(polhode::default_scheme())
