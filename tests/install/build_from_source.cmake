# Builds the library within an application's project: added by add_subdirectory or FetchContent, static or shared, without
# and with its installation. Leaves the shared libraries that were installed in ${folder}/moved_shared.
# Variables: source, folder, generator, compiler, flags, adapter, version.
include(${CMAKE_CURRENT_LIST_DIR}/relocatable.cmake)
set(build ${folder}/from_source)
file(REMOVE_RECURSE ${build} ${folder}/installed_static ${folder}/installed_shared ${folder}/moved_shared)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${result}\n${output}")
  endif()
endfunction()

function(build_and_run from)
  run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/from_source -B ${build} -G ${generator} -Dpolhode_from=${from} ${ARGN})
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/consumer)
endfunction()

build_and_run(add_subdirectory -DFETCHCONTENT_SOURCE_DIR_POLHODE=${source} -DCMAKE_CXX_COMPILER=${compiler}
  "-DCMAKE_CXX_FLAGS=${flags}" -Dpolhode_adapter=${adapter} -Dpolhode_version=${version})
build_and_run(FetchContent)
run(${CMAKE_COMMAND} --install ${build} --prefix ${folder}/installed_static)
file(GLOB_RECURSE installed RELATIVE ${folder}/installed_static ${folder}/installed_static/*)
if(NOT installed STREQUAL "bin/consumer")
  message(FATAL_ERROR "the application installs files that are not its own: ${installed}")
endif()

build_and_run(add_subdirectory -DBUILD_SHARED_LIBS=ON)
build_and_run(FetchContent -DPOLHODE_INSTALL=ON)
run(${CMAKE_COMMAND} --install ${build} --prefix ${folder}/installed_shared)
file(RENAME ${folder}/installed_shared ${folder}/moved_shared)
file(REMOVE_RECURSE ${build})
refuse_origins(${folder}/moved_shared ${build} ${source} ${folder}/installed_shared)
