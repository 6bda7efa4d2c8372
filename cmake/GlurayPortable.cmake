# With GLURAY_PORTABLE the installed tree runs from any folder, and with C libraries from $GLURAY_C_LIBRARY on: docs/adr/0108.
option(GLURAY_PORTABLE "Install a tree that runs from any folder and with older C and C++ libraries (scripts/package tree)" OFF)
set(GLURAY_C_LIBRARY 2.28)  # the oldest GNU C library that such a tree runs with

if(GLURAY_PORTABLE)
  add_library(gluray_substitutes_object OBJECT ${CMAKE_SOURCE_DIR}/src/portable/substitutes.c)
  set_target_properties(gluray_substitutes_object PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
  add_library(gluray_start_object OBJECT ${CMAKE_SOURCE_DIR}/src/portable/start.c)
  set_target_properties(gluray_start_object PROPERTIES POSITION_INDEPENDENT_CODE ON)
  add_library(gluray-substitutes SHARED ${CMAKE_SOURCE_DIR}/src/portable/substitutes.c)  # for copies of others' libraries
  target_compile_definitions(gluray-substitutes PRIVATE GLURAY_EXPORTED)
  set_target_properties(gluray-substitutes PROPERTIES C_VISIBILITY_PRESET hidden)
  install(TARGETS gluray-substitutes LIBRARY DESTINATION lib/gluray/private)
endif()

# gluray_portable(TARGET): a library or a program of the installed tree.
function(gluray_portable TARGET)
  if(NOT GLURAY_PORTABLE)
    return()
  endif()
  target_sources(${TARGET} PRIVATE $<TARGET_OBJECTS:gluray_substitutes_object>)
  foreach(name arc4random gettid stat lstat fstat stat64 lstat64 fstat64 pthread_cond_clockwait __libc_single_threaded)
    target_link_options(${TARGET} PRIVATE -Wl,--defsym=${name}=${name}_substitute)
  endforeach()
  get_target_property(type ${TARGET} TYPE)
  if(type STREQUAL EXECUTABLE)
    target_sources(${TARGET} PRIVATE $<TARGET_OBJECTS:gluray_start_object>)
    target_link_options(${TARGET} PRIVATE -Wl,-e,glurayStart -Wl,--gc-sections)
  endif()
endfunction()
