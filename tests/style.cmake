# The rules of layout, and the check that the checker sees what it should.
add_test(NAME style.layers COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_layers.py ${CMAKE_SOURCE_DIR})
add_test(NAME style.layers_self_test
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_layers.py --self-test)
set_tests_properties(style.layers style.layers_self_test PROPERTIES LABELS style)
