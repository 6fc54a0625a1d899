# refuse_origins(<tree> <folder>...): fails if a file of the tree names one of the folders, where it was built or first
# installed.
function(refuse_origins tree)
  file(GLOB_RECURSE texts ${tree}/*.cmake ${tree}/*.pc ${tree}/*.h)
  foreach(text IN LISTS texts)
    file(READ ${text} content)
    foreach(origin IN LISTS ARGN)
      string(FIND "${content}" "${origin}" position)
      if(NOT position EQUAL -1)
        message(FATAL_ERROR "${text} names ${origin}: it cannot be moved")
      endif()
    endforeach()
  endforeach()
endfunction()
