// A library whose scheme has the name of a built-in one.
#include <polhode/scheme_library.h>

POLHODE_SCHEME_LIBRARY(polhode::find_scheme("rk4"))
