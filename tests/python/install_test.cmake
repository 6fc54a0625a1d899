# Installs the Python package alone and uses it from there, moved.
#   cmake -Dbuild=BUILD -Dfolder=FOLDER -Dpackage=PACKAGE -Dpython=PYTHON -P install_test.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${folder})
run(${CMAKE_COMMAND} --install ${build} --component python --prefix ${folder}/first)
file(RENAME ${folder}/first ${folder}/moved)
get_filename_component(site ${folder}/moved/${package} DIRECTORY)
run(${CMAKE_COMMAND} -E env --unset=POLHODE_SCENARIOS PYTHONPATH=${site} PYTHONDONTWRITEBYTECODE=1 ${python} -c
  "import polhode, os; assert polhode.__file__.startswith('${site}'), polhode.__file__
assert 'tumble' in polhode.scenarios() and os.path.exists('${site}/polhode/py.typed')
print(polhode.compare('tumble', ['exact']))")
