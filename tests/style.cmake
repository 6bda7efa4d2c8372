# The rules of layout and of documents, and the checks that the checkers see what they should.
add_test(NAME style.layers COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_layers.py ${CMAKE_SOURCE_DIR})
add_test(NAME style.layers_self_test
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_layers.py --self-test)
add_test(NAME style.documents COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_documents.py ${CMAKE_SOURCE_DIR})
add_test(NAME style.documents_self_test
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/check_documents.py --self-test)
set_tests_properties(style.layers style.layers_self_test style.documents style.documents_self_test PROPERTIES LABELS style)
