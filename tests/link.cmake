# Linked libraries: exports, constructors, dependencies; and programs while a part is missing.
set(link_check ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/link_check.py)

function(link_test NAME)
  add_test(NAME link.${NAME} COMMAND ${ARGN})
  set_tests_properties(link.${NAME} PROPERTIES LABELS link TIMEOUT 60)
endfunction()

link_test(engine_exports ${link_check} exports $<TARGET_FILE:gluray-engine> glurayEngine glurayAsk glurayForget glurayWorker glurayRender
          glurayExport glurayWriteExr glurayViewOpen glurayViewClose glurayViewShow glurayViewPoint)
link_test(vendor_glx_exports ${link_check} exports $<TARGET_FILE:gluray-door-glx> __glx_Main)
link_test(vendor_egl_exports ${link_check} exports $<TARGET_FILE:gluray-door-egl> __egl_Main)
link_test(preload_exports ${link_check} preload-exports $<TARGET_FILE:gluray-preload>)
foreach(door door-glx door-egl preload)
  link_test(no_constructors.${door} ${link_check} no-constructors $<TARGET_FILE:gluray-${door}>)
  link_test(libc_only.${door} ${link_check} libc-only $<TARGET_FILE:gluray-${door}>)
  link_test(nodelete.${door} ${link_check} nodelete $<TARGET_FILE:gluray-${door}>)
endforeach()
link_test(nodelete.engine ${link_check} nodelete $<TARGET_FILE:gluray-engine>)
link_test(local_look_alone ${link_check} without-integrators $<TARGET_FILE:gluray_render>)
link_test(silent_in_true ${link_check} silent $<TARGET_FILE:gluray-preload>)

add_test(NAME style.gl_coverage COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tools/generate.py --check-coverage
         ${CMAKE_SOURCE_DIR}/docs/gl-coverage.md)
set_tests_properties(style.gl_coverage PROPERTIES LABELS style)

add_test(NAME unit.generator COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/generator_test.py)
set_tests_properties(unit.generator PROPERTIES LABELS unit)
