# Flags that every target of the project is compiled with. Results must not depend on the compiler or on -O,
# so contraction into fused multiply-adds is off; errno and traps are not observed, so those may go.
add_library(texelscope_flags INTERFACE)
target_compile_options(texelscope_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Werror
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  # gcc 12 at -O3 sees overlaps and overflows within std::string that are not there.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
target_include_directories(texelscope_flags INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)

set(TEXELSCOPE_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize takes them: address,undefined")
if(TEXELSCOPE_SANITIZE)
  add_compile_options(-fsanitize=${TEXELSCOPE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${TEXELSCOPE_SANITIZE})
endif()

# What the fuzzers are guided by: which branches of the whole program an input took.
if(TEXELSCOPE_FUZZ)
  add_compile_options(-fsanitize-coverage=inline-8bit-counters,pc-table)
endif()

# TEXELSCOPE_ASSERT is on in Debug, sanitizer and test builds; off in what people run.
if(CMAKE_BUILD_TYPE STREQUAL "Debug" OR TEXELSCOPE_SANITIZE)
  target_compile_definitions(texelscope_flags INTERFACE TEXELSCOPE_ASSERTS=1)
endif()
