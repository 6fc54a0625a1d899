# Installs the build into a folder, moves the installation to another one, and rejects files that contain the path of
# the build or of the first installation. Variables: build, source, configuration, folder.
include(${CMAKE_CURRENT_LIST_DIR}/relocatable.cmake)
file(REMOVE_RECURSE ${folder}/installed ${folder}/moved ${folder}/moved_single)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} --config "${configuration}" --prefix ${folder}/installed
  OUTPUT_QUIET RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the build cannot be installed: ${result}")
endif()
file(RENAME ${folder}/installed ${folder}/moved)

refuse_origins(${folder}/moved ${build} ${source} ${folder}/installed)

# The same tree, as on a machine that built single precision only.
file(COPY ${folder}/moved/ DESTINATION ${folder}/moved_single)
file(GLOB_RECURSE double ${folder}/moved_single/polhode-bullet_float64*.cmake)
file(REMOVE ${double})
