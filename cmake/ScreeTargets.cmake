# One static library per folder. scree_library(name SOURCES ... LIBRARIES ... PRIVATE_LIBRARIES ...
# OPTIONS ...): LIBRARIES are seen by users of the library's headers, PRIVATE_LIBRARIES and OPTIONS
# only by its own files (one door per library).
include(GNUInstallDirs)

function(scree_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 and 14 report std::string and std::variant members that are plainly initialised
    # (GCC bugs 105562, 105651).
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict)
  endif()
endfunction()

option(SCREE_PRECOMPILED_HEADERS "Parse the headers that most sources include once" ON)
if(SCREE_PRECOMPILED_HEADERS)
  add_library(scree_precompiled STATIC ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_compile_features(scree_precompiled PUBLIC cxx_std_20)
  target_compile_options(scree_precompiled PRIVATE -ffp-contract=off)
  target_link_libraries(scree_precompiled PRIVATE Imath::Imath TBB::tbb fmt::fmt)
  scree_warnings(scree_precompiled)
  target_precompile_headers(scree_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
endif()

# Targets whose options are those of scree_library share one; OWN is for those with others.
function(scree_precompiled_headers target)
  if(NOT SCREE_PRECOMPILED_HEADERS)
    return()
  endif()
  target_link_libraries(${target} PRIVATE Imath::Imath TBB::tbb fmt::fmt)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC forgets that a precompiled header is a system header, and reports sums of std::string in
    # it (GCC bugs 105329, 105651); builds without it report what is ours.
    target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds)
  endif()
  if("OWN" IN_LIST ARGN)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  else()
    target_precompile_headers(${target} REUSE_FROM scree_precompiled)
  endif()
endfunction()

function(scree_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES;PRIVATE_LIBRARIES;OPTIONS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/scree>)
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES} PRIVATE ${arg_PRIVATE_LIBRARIES})
  # The same bytes on every machine of a kind: no contraction of a * b + c behind our back.
  target_compile_options(${name} PRIVATE -ffp-contract=off ${arg_OPTIONS})
  scree_warnings(${name})
  if(arg_OPTIONS)
    scree_precompiled_headers(${name} OWN)
  else()
    scree_precompiled_headers(${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY SCREE_LIBRARIES ${name})
endfunction()
