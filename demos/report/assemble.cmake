# Joins the page of `polhode_compare --report` into one file: wherever page/report.html refers to a style sheet, a script or
# a licence of its own, the file itself is put there, byte for byte. What is left open is the marker @REPORT_DATA@.
# Needs -Dpage=<folder of report.html> -Doutput=<file>.
cmake_minimum_required(VERSION 3.18)

foreach(variable page output)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "-D${variable}=... is missing")
  endif()
endforeach()

# Contents are quoted wherever they are expanded: CMake would take a semicolon or a bracket in them for a list otherwise.
# Nothing here configures text, which would replace what stands between two @.
file(READ "${page}/report.html" rest)
set(joined "")

# Appends all up to and with `tag` to `joined`, the file in the place of the tag; what follows it is the new `rest`.
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

# The tags of the skeleton, in their order; it has no semicolon inside of one.
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
