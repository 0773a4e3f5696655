# Options of the whole build: warnings, sanitizers, instruction set, tests.
option(TOLMAN_BUILD_TESTS "Build the tests" ON)
option(TOLMAN_MARCH_V3 "Build for x86-64-v3 (AVX2); plugins must then be built so too" OFF)
option(TOLMAN_ASAN "Address and undefined-behaviour sanitizers" OFF)
option(TOLMAN_FUZZ "Instrument for libFuzzer (clang only); see scripts/fuzz" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG") # hot plugins ask for -O3 themselves

# Some libraries ask for it; a precompiled header serves all targets only where all have it.
add_compile_options(-pthread)

if(TOLMAN_MARCH_V3)
  add_compile_options(-march=x86-64-v3)
endif()
if(TOLMAN_ASAN)
  # -O1: with -O2 and all checks the instrumented build takes three times as long.
  set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG")
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=object-size,vptr
                      -fno-sanitize-recover=undefined -fno-omit-frame-pointer -g1)
  add_compile_definitions(_GLIBCXX_ASSERTIONS) # empty optionals and indices, which ASan overlooks
  add_link_options(-fsanitize=address,undefined)
endif()
if(TOLMAN_FUZZ)
  set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG")
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow
                      -fno-sanitize=object-size,vptr -fno-sanitize-recover=all
                      -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=address,undefined)
endif()

# ccache keeps what is compiled with a precompiled header only if it may ignore the header's macros
# and times, and finds what another checkout compiled only by relative paths. CCACHE_DEPEND: two
# headers that differ in comments alone must not share a precompiled header, for #pragma once
# compares whole files.
find_program(TOLMAN_CCACHE ccache)
if(TOLMAN_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
      ${TOLMAN_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()

# The house's warnings; for our own targets only, never for a third party's plugin.
function(tolman_warnings target)
  if(TOLMAN_FUZZ)
    return() # clang warns of other things; clang-tidy reads the sources with them
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12's optimiser sees overflows in inlined std::string that are not there
    # (PR 105329, 105651). The sanitizer build and GCC 13 look for real ones.
    target_compile_options(
      ${target} PRIVATE -Wno-restrict -Wno-array-bounds
                        -Wno-stringop-overflow -Wno-stringop-overread -Wno-free-nonheap-object)
  endif()
endfunction()
