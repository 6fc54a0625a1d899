# Installs a relocatable tree: headers, libraries, find_package(polhode CONFIG) and pkg-config files.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/polhode)

# Each library is a separate export set, so that a user without one of the two Bullets can use the rest.
foreach(component IN ITEMS core bullet bullet_float64)
  if(NOT TARGET polhode_${component})
    continue()
  endif()
  if(NOT APPLE)
    set_target_properties(polhode_${component} PROPERTIES INSTALL_RPATH "$ORIGIN")
  endif()
  install(TARGETS polhode_${component} EXPORT polhode-${component})
  install(EXPORT polhode-${component} NAMESPACE polhode:: DESTINATION ${package_dir})
endforeach()

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/polhodeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/polhodeConfig.cmake cmake/PolhodeBullet.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/polhodeConfigVersion.cmake DESTINATION ${package_dir})

# The pkg-config file requires Bullet's. If the build's Bullet has none, it would find another Bullet, or nothing.
function(polhode_install_pkg_config name library precision bits)
  if(NOT TARGET PolhodeBullet::float${bits})
    return()
  endif()
  get_target_property(bullet_module PolhodeBullet::float${bits} INTERFACE_POLHODE_PKG_CONFIG_MODULE)
  if(NOT bullet_module)
    return()
  endif()
  file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
  configure_file(cmake/polhode.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
polhode_install_pkg_config(polhode bullet single 32)
polhode_install_pkg_config(polhode-float64 bullet_float64 double 64)
