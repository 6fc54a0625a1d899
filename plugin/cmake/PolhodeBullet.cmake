# Finds Bullet in one precision and wraps it in an imported target. Used by the build and, after installation, by
# find_package(polhode).
#
# Tries in this order: the target named by the user; pkg-config's modules bullet and bullet-float64, whose flags state
# their precision; for single precision, if pkg-config has no module bullet, CMake's FindBullet module. Does not use Bullet's
# own BulletConfig.cmake: in Debian's package its include directory is relative, and it names libraries that are not
# installed.

# polhode_find_bullet(<bits> <user's target or empty>) defines PolhodeBullet::float<bits> and sets
# POLHODE_BULLET_FLOAT<bits>_FOUND. The target's property INTERFACE_POLHODE_PKG_CONFIG_MODULE is the module that was found.
function(polhode_find_bullet bits user_target)
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
    foreach(module IN ITEMS bullet bullet-float64)
      string(MAKE_C_IDENTIFIER "POLHODE_PKG_${module}" found)
      pkg_check_modules(${found} QUIET IMPORTED_TARGET GLOBAL ${module})
      set(found_bits 32)
      if("${${found}_CFLAGS}" MATCHES "-DBT_USE_DOUBLE_PRECISION")
        set(found_bits 64)
      endif()
      if(TARGET PkgConfig::${found} AND bits EQUAL found_bits)
        add_library(${target} INTERFACE IMPORTED GLOBAL)
        set_target_properties(${target} PROPERTIES INTERFACE_POLHODE_PKG_CONFIG_MODULE ${module})
        target_link_libraries(${target} INTERFACE PkgConfig::${found})
        return()
      endif()
    endforeach()
  endif()
  # If pkg-config has a module bullet, FindBullet would find the libraries of that module, in either precision.
  if(bits EQUAL 32 AND NOT TARGET PkgConfig::POLHODE_PKG_bullet)
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
