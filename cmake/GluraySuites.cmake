# Targets that build what one sanitizer runs, and nothing else: the rest would cost time there and find nothing.
# tests/suites_test.py (link.suites) fails where a test with a sanitizer's label runs what its target does not build.

# Labels `unit`, `variant`, `link`, `fuzz`. Everything is in it but these, whose tests have other labels only.
set(without_address reference_tests cluster_scenes_tests fuzz_tests lag_tests threads_tests gluray-scene-player rings live_freeze)
set(without_address_pattern "^door_(a[^b]|[^a])")  # not door_abi
# Label `thread`.
set(thread_programs accel_tests gl_tests parallel_tests)
if(TARGET threads_tests)
  list(APPEND thread_programs threads_tests)
endif()

# programs(OUT DIRECTORY): the executables and shared libraries of DIRECTORY and of those below it.
function(programs OUT DIRECTORY)
  set(found "")
  get_property(targets DIRECTORY ${DIRECTORY} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(EXECUTABLE|SHARED_LIBRARY|MODULE_LIBRARY)$")
      list(APPEND found ${target})
    endif()
  endforeach()
  get_property(directories DIRECTORY ${DIRECTORY} PROPERTY SUBDIRECTORIES)
  foreach(directory ${directories})
    programs(below ${directory})
    list(APPEND found ${below})
  endforeach()
  set(${OUT} ${found} PARENT_SCOPE)
endfunction()

# suites(NAME TARGET...): the target NAME, and suites/NAME.txt with the files that it builds, one a line.
function(suites NAME)
  add_custom_target(${NAME} DEPENDS ${ARGN})
  set(files "")
  foreach(target ${ARGN})
    string(APPEND files "$<TARGET_FILE:${target}>\n")
  endforeach()
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/suites/${NAME}.txt CONTENT "${files}")
endfunction()

programs(release_programs ${CMAKE_SOURCE_DIR})
set(address_programs ${release_programs})
list(FILTER address_programs EXCLUDE REGEX ${without_address_pattern})
list(REMOVE_ITEM address_programs ${without_address})
# The archive is what link.local_look_alone looks at.
suites(address_suites ${address_programs} gluray_render)
suites(thread_suites ${thread_programs})
# What the release suite runs: everything but the benchmarks (their tests stay), and the same archive.
if(GLURAY_BENCH)
  programs(bench_programs ${CMAKE_SOURCE_DIR}/bench)
  list(FILTER bench_programs EXCLUDE REGEX "_tests$")
  list(REMOVE_ITEM release_programs ${bench_programs})
endif()
suites(release_suites ${release_programs} gluray_render)
add_dependencies(release_suites packed_documents)  # of the package
add_test(NAME link.suites COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/suites_test.py ${CMAKE_CTEST_COMMAND}
         ${CMAKE_BINARY_DIR})
add_test(NAME link.cases COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/cases_test.py ${CMAKE_CTEST_COMMAND}
         ${CMAKE_BINARY_DIR})
set_tests_properties(link.suites link.cases PROPERTIES LABELS link TIMEOUT 60)
