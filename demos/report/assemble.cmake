# Joins the page of `polhode_compare --report` into one file: replaces each reference of page/report.html to a
# style sheet, a script or a licence with the bytes of that file. The marker @REPORT_DATA@ is left open. Needs
# -Dpage=<folder of report.html> -Doutput=<file>.
cmake_minimum_required(VERSION 3.18)

foreach(variable page output)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "-D${variable}=... is missing")
  endif()
endforeach()

# Contents are quoted wherever they are expanded: otherwise CMake would take a semicolon or a bracket in them
# for a list. Nothing here configures text, since that would replace text between two @.
file(READ "${page}/report.html" rest)
set(joined "")

# Appends the text up to and including `tag` to `joined`, with the file in place of the tag. The rest becomes
# the new `rest`.
macro(take tag before file after forbidden)
  string(FIND "${rest}" "${tag}" position)
  string(SUBSTRING "${rest}" 0 ${position} head)
  string(LENGTH "${tag}" length)
  math(EXPR position "${position} + ${length}")
  string(SUBSTRING "${rest}" ${position} -1 rest)
  file(READ "${page}/${file}" content)
  string(TOLOWER "${content}" lower)
  if(lower MATCHES "${forbidden}" OR lower MATCHES "@report_data@")
    message(FATAL_ERROR "${file} contains '${CMAKE_MATCH_0}', which cannot stand in the page")
  endif()
  string(APPEND joined "${head}" "${before}" "${content}" "${after}")
endmacro()

# The tags of the skeleton, in their order. A tag must not contain a semicolon.
string(REGEX MATCHALL
  "<link rel=\"stylesheet\" href=\"[^\"]*\">|<script src=\"[^\"]*\"></script>|<pre data-file=\"[^\"]*\"></pre>"
  tags "${rest}")
foreach(tag IN LISTS tags)
  string(REGEX MATCH "(href|src|data-file)=\"([^\"]*)\"" matched "${tag}")
  set(kind "${CMAKE_MATCH_1}")
  set(file "${CMAKE_MATCH_2}")
  if(kind STREQUAL "href")
    take("${tag}" "<style>\n" "${file}" "\n</style>" "</style")
  elseif(kind STREQUAL "src")
    take("${tag}" "<script>\n" "${file}" "\n</script>" "</script|<!--")
  else()
    take("${tag}" "<pre>\n" "${file}" "\n</pre>" "[<&]")
  endif()
endforeach()
string(APPEND joined "${rest}")

string(REGEX MATCHALL "@REPORT_DATA@" markers "${joined}")
list(LENGTH markers count)
if(NOT count EQUAL 1)
  message(FATAL_ERROR "the page has the marker @REPORT_DATA@ ${count} times, not once")
endif()
file(WRITE "${output}" "${joined}")
