# Runs tools/generate.py and tools/settings.py whenever the build is configured; a change of its inputs configures again. Files whose text
# stays the same keep their date, so that only what changed is compiled.
file(GLOB generator CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tools/*.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${generator} ${CMAKE_SOURCE_DIR}/spec/policy.toml
             ${CMAKE_SOURCE_DIR}/spec/settings.toml ${CMAKE_SOURCE_DIR}/src/intercept/window_systems/osmesa_api.h
             ${CMAKE_SOURCE_DIR}/third_party/khronos/gl.xml ${CMAKE_SOURCE_DIR}/third_party/khronos/glx.xml)
execute_process(COMMAND ${CMAKE_COMMAND} -E env CC=${CMAKE_C_COMPILER} ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/generate.py ${CMAKE_BINARY_DIR}/gen
                RESULT_VARIABLE result ERROR_VARIABLE message)
if(result)
  message(FATAL_ERROR "${message}")
endif()
execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/settings.py ${CMAKE_BINARY_DIR}/gen
                RESULT_VARIABLE result ERROR_VARIABLE message)
if(result)
  message(FATAL_ERROR "${message}")
endif()
set(GLURAY_GENERATED ${CMAKE_BINARY_DIR}/gen)
