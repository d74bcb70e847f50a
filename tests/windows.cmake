# SPDX-License-Identifier: MIT
# What of the tests runs in Windows: those of files/ and those of the C interface, over the DLL. GoogleTest is compiled
# from Debian's sources, as Debian has none for Windows.
set(googletest /usr/src/googletest)
if(NOT EXISTS ${googletest})
  message(STATUS "tests are left out: ${googletest} is not there")
  return()
endif()
add_library(shigusa_gtest STATIC ${googletest}/googletest/src/gtest-all.cc ${googletest}/googlemock/src/gmock-all.cc
                                 ${googletest}/googlemock/src/gmock_main.cc)
target_include_directories(
  shigusa_gtest SYSTEM PUBLIC ${googletest}/googletest/include ${googletest}/googlemock/include
                PRIVATE ${googletest}/googletest ${googletest}/googlemock)
target_compile_options(shigusa_gtest PRIVATE -w)

foreach(room IN ITEMS files c)
  file(GLOB sources CONFIGURE_DEPENDS ${room}/*_test.cpp)
  list(FILTER sources EXCLUDE REGEX "_posix_|/locale_")
  add_executable(test_${room} ${sources})
  target_include_directories(test_${room} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
  target_compile_options(test_${room} PRIVATE ${shigusa_quick_build})
  target_link_libraries(test_${room} PRIVATE shigusa_gtest shigusa::shigusa fmt::fmt nlohmann_json::nlohmann_json)
endforeach()
target_link_libraries(test_c PRIVATE shigusa::c)
