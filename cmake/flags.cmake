# Compiler flags live on one interface target: nothing global, nothing leaks to users of the libraries.
add_library(icebow_flags INTERFACE)
target_include_directories(icebow_flags INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/icebow>)
set(warnings -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(ICEBOW_WERROR)
  list(APPEND warnings -Werror)
endif()
target_compile_options(icebow_flags INTERFACE "$<BUILD_INTERFACE:${warnings}>")
if(ICEBOW_ASSERTS)
  string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
endif()
# Tests and fuzzers share the objects. clang has the fuzzer, and g++ 12 at -O2 compiles one file of CGAL for 320 s.
if(ICEBOW_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "ICEBOW_SANITIZE needs clang, and the compiler is ${CMAKE_CXX_COMPILER_ID}: take the preset asan")
  endif()
  target_compile_options(icebow_flags INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined)
  target_link_options(icebow_flags INTERFACE -fsanitize=address,undefined)
endif()

# icebow_library(name SOURCES ... LINKS public libraries ... USES private libraries ...)
function(icebow_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;USES" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC icebow_flags ${ARG_LINKS} PRIVATE ${ARG_USES})
endfunction()

# icebow_plugin(name SOURCES ... USES libraries ... FOR library): a shared library beside the program that
# base/plugin.h loads, with the libraries nothing else needs. Built with `library`, whose functions load it.
function(icebow_plugin name)
  cmake_parse_arguments(ARG "" "FOR" "SOURCES;USES" ${ARGN})
  add_library(${name} MODULE ${ARG_SOURCES} ${PROJECT_SOURCE_DIR}/src/base/errors.cpp)
  target_link_libraries(${name} PRIVATE icebow_flags Eigen3::Eigen nlohmann_json::nlohmann_json ${ARG_USES})
  set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
  add_dependencies(${ARG_FOR} ${name})
endfunction()
