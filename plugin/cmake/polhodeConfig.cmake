# find_package(polhode CONFIG [COMPONENTS core bullet bullet_float64]) defines
#   polhode::core            schemes and rotation mathematics, no Bullet
#   polhode::bullet          the adapter for single-precision Bullet
#   polhode::bullet_float64  the adapter for double-precision Bullet
# Without COMPONENTS, finds each adapter that is installed and whose Bullet is found. To use your own Bullet, set
# POLHODE_BULLET_FLOAT32_TARGET or POLHODE_BULLET_FLOAT64_TARGET to its target before the call.

include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
include("${CMAKE_CURRENT_LIST_DIR}/PolhodeBullet.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/polhode-core.cmake")
set(polhode_core_FOUND TRUE)

macro(_polhode_find_adapter component bits precision)
  set(polhode_${component}_FOUND FALSE)
  if(EXISTS "${CMAKE_CURRENT_LIST_DIR}/polhode-${component}.cmake")
    polhode_find_bullet(${bits} "${POLHODE_BULLET_FLOAT${bits}_TARGET}")
    if(POLHODE_BULLET_FLOAT${bits}_FOUND)
      include("${CMAKE_CURRENT_LIST_DIR}/polhode-${component}.cmake")
      set(polhode_${component}_FOUND TRUE)
    else()
      set(_polhode_reason_${component} "Bullet in ${precision} precision was not found (pkg-config modules bullet and bullet-float64): install it, or set POLHODE_BULLET_FLOAT${bits}_TARGET to a target of yours")
    endif()
  else()
    set(_polhode_reason_${component} "this installation of polhode was built without it")
  endif()
endmacro()

set(_polhode_components ${polhode_FIND_COMPONENTS})
if(NOT _polhode_components)
  set(_polhode_components core bullet bullet_float64)
endif()
foreach(_polhode_component IN LISTS _polhode_components)
  if(_polhode_component STREQUAL "bullet")
    _polhode_find_adapter(bullet 32 single)
  elseif(_polhode_component STREQUAL "bullet_float64")
    _polhode_find_adapter(bullet_float64 64 double)
  elseif(NOT _polhode_component STREQUAL "core")
    set(polhode_${_polhode_component}_FOUND FALSE)
    set(_polhode_reason_${_polhode_component} "there is no such component; valid are core, bullet, bullet_float64")
  endif()
  if(NOT polhode_${_polhode_component}_FOUND AND polhode_FIND_REQUIRED_${_polhode_component})
    set(polhode_FOUND FALSE)
    string(APPEND polhode_NOT_FOUND_MESSAGE
      "component ${_polhode_component}: ${_polhode_reason_${_polhode_component}}\n")
  elseif(NOT polhode_${_polhode_component}_FOUND AND NOT polhode_FIND_QUIETLY)
    message(STATUS "polhode without ${_polhode_component}: ${_polhode_reason_${_polhode_component}}")
  endif()
endforeach()
