# SPDX-License-Identifier: MIT
# Flags for all targets; those that a user's build must share are beside the
# library target. -march=native and -ffast-math are never among them: results are the same on every
# machine.

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
  endif()
  find_program(SHIGUSA_CCACHE ccache)
  if(SHIGUSA_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    # ccache reuses files compiled with precompiled headers only if it may ignore their definitions
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${SHIGUSA_CCACHE})
  endif()
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
endif()

set(CMAKE_CXX_EXTENSIONS OFF)

add_compile_options(-Wall -Wextra -Wconversion -Wshadow -Wsign-conversion
                    $<$<BOOL:${SHIGUSA_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # from -O2 on it warns of impossible overlaps in std::string's operator+ (GCC bug 105651)
  add_compile_options(-Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # otherwise it stores neighbours one by one and reads them as a pair, which waits for both stores
  add_compile_options(-fno-tree-slp-vectorize)
endif()

# Flags for targets that wait for files more than they compute: they compile in two thirds of the time.
set(shigusa_quick_build $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<CONFIG:Release>>:-O1>)

if(WIN32)
  add_compile_definitions(UNICODE WIN32_LEAN_AND_MEAN NOMINMAX _WIN32_WINNT=0x0A00)
  # g++ takes the registers that its own copy of an inline function changes for those of the copy that the
  # linker keeps, which may be another file's
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-ipa-ra>)
endif()

if(SHIGUSA_SANITIZE)
  # without two checks that take a fifth of the compile time: the address sanitizer knows the sizes
  # that object-size estimates, and no class is cast to another, which vptr checks
  set(shigusa_sanitizer_flags -fsanitize=${SHIGUSA_SANITIZE} -fno-sanitize=object-size,vptr
                              -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_options(${shigusa_sanitizer_flags})
  add_link_options(${shigusa_sanitizer_flags})
endif()
