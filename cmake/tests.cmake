# tests/ROOM/NAME.LABEL.cpp: the label is the word before .cpp. All files of one room and label make one
# program, test_ROOM_LABEL; each file is one ctest entry of that program, so that a GL context and its
# shaders are made once per file and not once per claim.
find_package(GTest REQUIRED)

# tests/support is header only: helpers that several rooms' tests share.
function(facet_tests room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${room}/*.cpp)
  foreach(source IN LISTS sources)
    if(source MATCHES "/([a-z0-9_]+)\\.(unit|gl|physics|image|cli|studio|batch|fuzz)\\.cpp$")
      set(label ${CMAKE_MATCH_2})
      list(APPEND labels ${label})
      list(APPEND sources_${label} ${source})
    else()
      message(FATAL_ERROR "${source}: a test is named NAME.LABEL.cpp")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES labels)
  foreach(label IN LISTS labels)
    set(program test_${room}_${label})
    add_executable(${program} ${sources_${label}})
    target_link_libraries(${program} PRIVATE facet_${room} GTest::gtest_main facet_options facet_dep_json)
    target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(${program} PRIVATE
      FACET_SOURCE_DIR="${PROJECT_SOURCE_DIR}" FACET_BINARY_DIR="${PROJECT_BINARY_DIR}")
    if(TARGET facet_oiio)  # opened at run time, beside the program
      add_dependencies(${program} facet_oiio)
    endif()
    if(label MATCHES "^(cli|studio|batch)$" AND TARGET facet)
      add_dependencies(${program} facet)
    endif()
    foreach(source IN LISTS sources_${label})
      get_filename_component(file ${source} NAME)
      string(REGEX REPLACE "\\.[a-z]+\\.cpp$" "" name ${file})
      # The suites a file defines are read off its TEST lines, so a filter can be made without running it.
      file(STRINGS ${source} test_lines REGEX "^(TEST|TEST_F|TEST_P|TYPED_TEST)\\(")
      set(suites "")
      foreach(line IN LISTS test_lines)
        string(REGEX REPLACE "^[A-Z_]+\\(([A-Za-z0-9_]+).*" "\\1" suite "${line}")
        list(APPEND suites "${suite}.*" "*/${suite}.*" "${suite}/*")
      endforeach()
      list(REMOVE_DUPLICATES suites)
      string(REPLACE ";" ":" filter "${suites}")
      add_test(NAME ${room}/${name}.${label} COMMAND ${program} --gtest_filter=${filter} --gtest_brief=1
               WORKING_DIRECTORY /)
      set_tests_properties(${room}/${name}.${label} PROPERTIES LABELS ${label} TIMEOUT 600)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    endforeach()
  endforeach()
endfunction()

foreach(room base math tables image brdf scene gl frame trace render batch explain studio teach cli)
  facet_tests(${room})
endforeach()

# Lessons in a real browser; Debian's python3 has its selenium.
find_program(FACET_SYSTEM_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(TARGET facet AND FACET_SYSTEM_PYTHON)
  add_test(NAME teach/pages.cli COMMAND ${FACET_SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/teach/pages.py $<TARGET_FILE:facet>)
  set_tests_properties(teach/pages.cli PROPERTIES LABELS cli TIMEOUT 900)
endif()

foreach(check check_house check_style)
  if(EXISTS ${PROJECT_SOURCE_DIR}/scripts/${check}.py)
    add_test(NAME ${check} COMMAND python3 ${PROJECT_SOURCE_DIR}/scripts/${check}.py)
    set_tests_properties(${check} PROPERTIES LABELS unit)
  endif()
endforeach()
