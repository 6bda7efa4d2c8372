# Compiler settings shared by every target: C++20, position independent, hidden symbols, warnings (errors where GLURAY_WERROR).
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 11)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_compile_options(-Wall -Wextra -Wno-missing-field-initializers)
if(GLURAY_WERROR)
  add_compile_options(-Werror)
endif()
# The tests' own code compiles in three quarters of the time with -O1. What it tests is optimised in full, except in headers.
set(GLURAY_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)
# So does code that runs once, or waits for people, files and sockets.
set(GLURAY_CALM_OPTIONS $<$<CONFIG:Release>:-O1>)
if(GLURAY_SANITIZE MATCHES "undefined")
  # Nor is it looked at for undefined behaviour, which takes a quarter of its time.
  list(APPEND GLURAY_TEST_OPTIONS -fno-sanitize=undefined)
endif()
if(GLURAY_SANITIZE)
  add_compile_options(-fsanitize=${GLURAY_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${GLURAY_SANITIZE})
  if(GLURAY_SANITIZE MATCHES "undefined")
    # The address sanitizer reports what these two would, at the access itself; without them builds take less time.
    add_compile_options(-fno-sanitize=null,object-size)
  endif()
  # One instruction set: the code is the same for all, and compiles in a quarter of the time.
  add_compile_definitions(HWY_COMPILE_ONLY_STATIC)
  # GCC's flow warnings misfire on sanitizer instrumentation.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
