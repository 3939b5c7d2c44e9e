# The programs: facet (the command line), facet-bench (timings).
function(facet_program name main)
  if(EXISTS ${PROJECT_SOURCE_DIR}/src/${main})
    add_executable(${name} ${PROJECT_SOURCE_DIR}/src/${main})
    target_link_libraries(${name} PRIVATE facet_cli facet_options facet_seldom_run)
  endif()
endfunction()
facet_program(facet cli/main.cpp)
facet_program(facet-bench cli/bench_main.cpp)

# OpenImageIO in a shared object of its own, opened with dlopen at first need (docs/decisions).
file(GLOB oiio_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/image/module_oiio/*.cpp)
if(oiio_sources)
  # Not by its CMake config: Debian's names the folder of OpenCV's headers, which nothing here needs.
  find_path(FACET_OIIO_INCLUDE OpenImageIO/imageio.h REQUIRED)
  find_library(FACET_OIIO_LIBRARY OpenImageIO REQUIRED)
  find_library(FACET_OIIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
  add_library(facet_oiio MODULE ${oiio_sources})
  set_target_properties(facet_oiio PROPERTIES PREFIX "lib" OUTPUT_NAME "facet_oiio")
  target_link_libraries(facet_oiio PRIVATE ${FACET_OIIO_LIBRARY} ${FACET_OIIO_UTIL_LIBRARY}
    facet_base facet_options)
  target_include_directories(facet_oiio SYSTEM PRIVATE ${FACET_OIIO_INCLUDE})
  target_include_directories(facet_oiio PRIVATE ${PROJECT_SOURCE_DIR}/src)
  if(TARGET facet)
    add_dependencies(facet facet_oiio)
  endif()
endif()
