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
