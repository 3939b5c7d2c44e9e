# Every third-party library, named once; a room asks for the facet_dep_* it uses. All are Debian packages
# (scripts/packages.txt). Optional rooms of later issues add theirs here.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)

find_package(spdlog REQUIRED)
add_library(facet_dep_log INTERFACE)
target_link_libraries(facet_dep_log INTERFACE spdlog::spdlog Threads::Threads ${CMAKE_DL_LIBS})

add_library(facet_dep_expected INTERFACE)  # header only: <tl/expected.hpp>

add_library(facet_dep_glm INTERFACE)       # header only
target_compile_definitions(facet_dep_glm INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_EXPLICIT_CTOR)

# The hot path of reading and writing pictures: about 1 ms of start-up together, where libOpenImageIO
# costs 170 ms; that one is linked by src/image/oiio alone, a module opened at first need.
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
pkg_check_modules(webp REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(deflate REQUIRED IMPORTED_TARGET libdeflate)
find_package(OpenEXR CONFIG REQUIRED)
add_library(facet_dep_codecs INTERFACE)
target_link_libraries(facet_dep_codecs INTERFACE
  PNG::PNG JPEG::JPEG PkgConfig::webp PkgConfig::deflate OpenEXR::OpenEXR)

pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
add_library(facet_dep_hash INTERFACE)
target_link_libraries(facet_dep_hash INTERFACE PkgConfig::nettle)

find_package(nlohmann_json REQUIRED)
add_library(facet_dep_json INTERFACE)
target_link_libraries(facet_dep_json INTERFACE nlohmann_json::nlohmann_json)

pkg_check_modules(tinygltf REQUIRED IMPORTED_TARGET tinygltf)
add_library(facet_dep_tinygltf INTERFACE)
target_link_libraries(facet_dep_tinygltf INTERFACE PkgConfig::tinygltf)

# Compressed geometry. A build without one of them says so (exit 4) of files that need it.
option(FACET_MESHOPT "Read geometry compressed with meshoptimizer" ON)
option(FACET_DRACO "Read geometry compressed with Draco" ON)
# facet_codec(NAME OPTION HEADER LIBRARY): facet_dep_NAME, and FACET_HAS_NAME on or off.
function(facet_codec name option header library)
  string(TOUPPER ${name} upper)
  add_library(facet_dep_${name} INTERFACE)
  set(FACET_HAS_${upper} OFF PARENT_SCOPE)
  if(NOT ${option})
    return()
  endif()
  find_path(FACET_${upper}_INCLUDE ${header})
  find_library(FACET_${upper}_LIBRARY ${library})
  if(FACET_${upper}_INCLUDE AND FACET_${upper}_LIBRARY)
    set(FACET_HAS_${upper} ON PARENT_SCOPE)
    target_include_directories(facet_dep_${name} SYSTEM INTERFACE ${FACET_${upper}_INCLUDE})
    target_link_libraries(facet_dep_${name} INTERFACE ${FACET_${upper}_LIBRARY})
  else()
    message(STATUS "${library} is not there: files that need it will not load")
  endif()
endfunction()
facet_codec(meshopt FACET_MESHOPT meshoptimizer.h meshoptimizer)
facet_codec(draco FACET_DRACO draco/compression/decode.h draco)

# Headers only: entry points come from the context's own loader, so neither libGL nor libOSMesa is linked.
find_path(FACET_GL_INCLUDE GL/glcorearb.h REQUIRED)
add_library(facet_dep_gl_headers INTERFACE)
target_include_directories(facet_dep_gl_headers SYSTEM INTERFACE ${FACET_GL_INCLUDE})

# Markdown of lessons; the parser alone.
pkg_check_modules(md4c REQUIRED IMPORTED_TARGET md4c)
add_library(facet_dep_markdown INTERFACE)
target_link_libraries(facet_dep_markdown INTERFACE PkgConfig::md4c)

find_package(embree 3 REQUIRED)
add_library(facet_dep_embree INTERFACE)
target_link_libraries(facet_dep_embree INTERFACE embree)

# Dear ImGui is a static library; its own renderer and window code in it stay unused.
pkg_check_modules(imgui REQUIRED imgui)
add_library(facet_dep_imgui INTERFACE)
target_include_directories(facet_dep_imgui SYSTEM INTERFACE ${imgui_INCLUDE_DIRS})
target_link_libraries(facet_dep_imgui INTERFACE ${imgui_STATIC_LIBRARIES})

# Headers only: libglfw.so.3 is opened where a window is wanted, so that no other command needs it.
find_path(FACET_GLFW_INCLUDE GLFW/glfw3.h REQUIRED)
add_library(facet_dep_glfw INTERFACE)
target_include_directories(facet_dep_glfw SYSTEM INTERFACE ${FACET_GLFW_INCLUDE})

find_package(CLI11 REQUIRED)
add_library(facet_dep_cli INTERFACE)
target_link_libraries(facet_dep_cli INTERFACE CLI11::CLI11)
