# facet_room(NAME DEPENDS ...): one static library over src/NAME, no list of sources kept anywhere.
# What it depends on is visible to it and to whoever depends on it; include paths start at src/.

add_library(facet_options INTERFACE)
target_compile_options(facet_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Werror
  -Wno-missing-field-initializers  # designated initialisers omit what a row does not need
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 sees overlaps in "text" + string that are not there (PR 105651)
  -fno-math-errno -ffp-contract=off)  # contraction would make bytes depend on the compiler
if(FACET_SANITIZE)
  target_compile_options(facet_options INTERFACE -fsanitize=${FACET_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(facet_options INTERFACE -fsanitize=${FACET_SANITIZE})
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Debug" OR FACET_SANITIZE)
  target_compile_definitions(facet_options INTERFACE FACET_ASSERTS=1)
endif()
if(FACET_GL_DEBUG)
  target_compile_definitions(facet_options INTERFACE FACET_GL_DEBUG=1)
endif()

# Where no time is spent at run time, a third of the compiler's time is saved (-O1, which inlines, takes longer than -O3).
add_library(facet_seldom_run INTERFACE)
target_compile_options(facet_seldom_run INTERFACE $<$<CONFIG:Release>:-Og>)

# SELDOM_RUN: nothing in the room loops over pixels, rays or vertices.
function(facet_room name)
  cmake_parse_arguments(ROOM "SELDOM_RUN" "" "DEPENDS" ${ARGN})
  # A folder "module_*" inside a room is a shared object of its own (cmake/programs.cmake).
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/module_|/main\\.cpp$|_main\\.cpp$")
  set(libraries "")
  foreach(dependency IN LISTS ROOM_DEPENDS)
    if(dependency MATCHES "^facet_dep_")
      list(APPEND libraries ${dependency})
    else()
      list(APPEND libraries facet_${dependency})
    endif()
  endforeach()
  if(sources)
    # Tables whose rows have the plainest names stand alone where a room is compiled several files at once.
    set(tables ${sources})
    list(FILTER tables INCLUDE REGEX "/schema_")
    if(tables)
      set_source_files_properties(${tables} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    add_library(facet_${name} STATIC ${sources})
    target_include_directories(facet_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}
                                                    ${PROJECT_SOURCE_DIR}/glsl)
    target_link_libraries(facet_${name} PUBLIC ${libraries} PRIVATE facet_options)
    if(ROOM_SELDOM_RUN)
      target_link_libraries(facet_${name} PRIVATE facet_seldom_run)
    endif()
    add_dependencies(facet_${name} facet_generated)
  else()
    add_library(facet_${name} INTERFACE)
    target_include_directories(facet_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_BINARY_DIR}
                                                       ${PROJECT_SOURCE_DIR}/glsl)
    target_link_libraries(facet_${name} INTERFACE ${libraries})
  endif()
endfunction()
