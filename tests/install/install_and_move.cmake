# Installs the build into a folder, moves what it installed to another one, and refuses files that remember where they
# were built or first installed. Variables: build, source, configuration, folder.
file(REMOVE_RECURSE ${folder})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} --config "${configuration}" --prefix ${folder}/installed
  OUTPUT_QUIET RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the build cannot be installed: ${result}")
endif()
file(RENAME ${folder}/installed ${folder}/moved)

file(GLOB_RECURSE texts ${folder}/moved/*.cmake ${folder}/moved/*.pc ${folder}/moved/*.h)
foreach(text IN LISTS texts)
  file(READ ${text} content)
  foreach(origin IN ITEMS ${build} ${source} ${folder}/installed)
    string(FIND "${content}" "${origin}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${text} names ${origin}: it cannot be moved")
    endif()
  endforeach()
endforeach()

# The same tree as a machine has it that built single precision only.
file(COPY ${folder}/moved/ DESTINATION ${folder}/moved_single)
file(GLOB_RECURSE double ${folder}/moved_single/polhode-bullet_float64*.cmake)
file(REMOVE ${double})
