# Finds Bullet in one precision and wraps it in an imported target. Used by the build and, after installation, by
# find_package(polhode).
#
# Tries in this order: the target named by the user, pkg-config, CMake's FindBullet module (single precision only).
# Does not use Bullet's own BulletConfig.cmake: in Debian's package its include directory is relative, and it names
# libraries that are not installed.

# polhode_find_bullet(<bits> <pkg-config module> <user's target or empty>) defines PolhodeBullet::float<bits> and sets
# POLHODE_BULLET_FLOAT<bits>_FOUND.
function(polhode_find_bullet bits module user_target)
  set(target PolhodeBullet::float${bits})
  set(POLHODE_BULLET_FLOAT${bits}_FOUND TRUE PARENT_SCOPE)
  if(TARGET ${target})
    return()
  endif()
  if(user_target)
    if(NOT TARGET ${user_target})
      message(FATAL_ERROR "polhode: the Bullet target \"${user_target}\" does not exist: define it before polhode, "
        "or leave POLHODE_BULLET_FLOAT${bits}_TARGET empty to search for Bullet")
    endif()
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${target} INTERFACE ${user_target})
    return()
  endif()
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(POLHODE_PKG_BULLET_FLOAT${bits} QUIET IMPORTED_TARGET GLOBAL ${module})
  endif()
  if(TARGET PkgConfig::POLHODE_PKG_BULLET_FLOAT${bits})
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(${target} INTERFACE PkgConfig::POLHODE_PKG_BULLET_FLOAT${bits})
    return()
  endif()
  if(bits EQUAL 32)
    find_package(Bullet MODULE QUIET)
    if(BULLET_FOUND)
      add_library(${target} INTERFACE IMPORTED GLOBAL)
      target_include_directories(${target} SYSTEM INTERFACE ${BULLET_INCLUDE_DIRS})
      target_link_libraries(${target} INTERFACE ${BULLET_LIBRARIES})
      return()
    endif()
  endif()
  set(POLHODE_BULLET_FLOAT${bits}_FOUND FALSE PARENT_SCOPE)
endfunction()
