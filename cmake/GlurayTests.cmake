# gluray_discover_tests(TARGET PREFIX prefix LABEL label [ALONE pattern...] [ONLY pattern...] [EXCEPT pattern...]
#   [TIMEOUT seconds] [PROPERTIES ...])
# registers the cases of a GoogleTest program that links gluray_test_main. One ctest test, and so one process, runs a whole suite
# (PREFIX + Suite); a case that ALONE matches has a process of its own (PREFIX + Suite.Case). ONLY restricts to cases that match,
# EXCEPT leaves cases out. Patterns are GoogleTest's: * and ?. list_tests.py makes the list when the program has been linked;
# link.cases fails where ctest runs fewer cases than the program has.
function(gluray_discover_tests TARGET)
  cmake_parse_arguments(ARG "" "PREFIX;LABEL;TIMEOUT" "ALONE;ONLY;EXCEPT;PROPERTIES" ${ARGN})
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_${ARG_LABEL}_tests.cmake)
  if(ARG_TIMEOUT)
    list(APPEND ARG_PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  endif()
  set(script ${CMAKE_SOURCE_DIR}/cmake/list_tests.py)
  add_custom_command(TARGET ${TARGET} POST_BUILD BYPRODUCTS ${file} VERBATIM
                     COMMAND ${Python3_EXECUTABLE} ${script} $<TARGET_FILE:${TARGET}> ${file} --prefix ${ARG_PREFIX}
                             "--alone=${ARG_ALONE}" "--only=${ARG_ONLY}" "--except=${ARG_EXCEPT}"
                             --properties LABELS ${ARG_LABEL} SKIP_RETURN_CODE 77 ${ARG_PROPERTIES})
  set_property(TARGET ${TARGET} APPEND PROPERTY LINK_DEPENDS ${script})
  # A program that was not built fails by name where ctest runs all labels.
  set(include ${CMAKE_CURRENT_BINARY_DIR}/${TARGET}_${ARG_LABEL}_include.cmake)
  file(WRITE ${include} "if(EXISTS \"${file}\")\n  include(\"${file}\")\nelse()\n"
                        "  add_test(${TARGET}_NOT_BUILT ${TARGET}_NOT_BUILT)\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${include})
endfunction()

# gluray_use_test_headers(TARGET [HEADER]): the sources of a GoogleTest program begin with tests/headers/precompiled.h, which is
# compiled once for all, or with a header of their own. For programs compiled with GLURAY_TEST_OPTIONS. Clang's builds go
# without (CMAKE_DISABLE_PRECOMPILE_HEADERS), so that they find missing includes.
function(gluray_use_test_headers TARGET)
  if(ARGN)
    target_precompile_headers(${TARGET} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${ARGN})
    target_include_directories(${TARGET} PRIVATE ${CMAKE_SOURCE_DIR})
  else()
    target_precompile_headers(${TARGET} REUSE_FROM gluray_test_headers)
  endif()
  # GCC 12 reports joined strings as overrun where <string> is precompiled.
  target_compile_options(${TARGET} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
endfunction()

# gluray_client(TARGET SOURCE): a C program over OpenGL and X11 that tests run under the built GLuRay.
function(gluray_client TARGET SOURCE)
  find_package(X11 REQUIRED)
  find_library(GL_LIBRARY GL REQUIRED)
  add_executable(${TARGET} ${SOURCE})
  set_target_properties(${TARGET} PROPERTIES C_EXTENSIONS ON)
  target_include_directories(${TARGET} PRIVATE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${TARGET} PRIVATE ${GL_LIBRARY} X11::X11 m)
  add_dependencies(${TARGET} gluray gluray-engine gluray-door-glx gluray-door-egl gluray-preload)
endfunction()
