find_package(PkgConfig REQUIRED)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
find_package(glfw3 REQUIRED)
find_package(OpenGL REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(md4c REQUIRED)
find_package(Boost REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(Threads REQUIRED)
find_package(hwy REQUIRED)
find_package(TBB REQUIRED)

# stb_image and stb_image_write: Debian compiles them into one library.
find_library(TEXELSCOPE_STB stb REQUIRED)

# tinyobjloader: core/geometry/obj.cpp compiles the header, so there is nothing to link.
find_path(TEXELSCOPE_TINYOBJ tiny_obj_loader.h REQUIRED)
