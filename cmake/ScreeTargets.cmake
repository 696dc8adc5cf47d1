# SPDX-License-Identifier: GPL-3.0-or-later
# One static library per folder.
include(GNUInstallDirs)

# What makes a build from nothing faster and changes to a single file slower.
option(SCREE_FAST_BUILD "Parse common headers once, and small sources together" ON)

function(scree_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 and 14 report std::string and std::variant members that are plainly initialised
    # (GCC bugs 105562, 105651).
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict)
  endif()
endfunction()

# GCC forgets that a precompiled header is a system header, and reports sums of std::string in it
# (GCC bugs 105329, 105651); builds without it report what is ours.
function(scree_precompiled_warnings target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-stringop-overread
      -Wno-array-bounds)
  endif()
endfunction()

function(scree_reuse_precompiled_headers target from)
  target_precompile_headers(${target} REUSE_FROM ${from})
  scree_precompiled_warnings(${target})
endfunction()

function(scree_own_precompiled_headers target)
  target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  scree_precompiled_warnings(${target})
endfunction()

if(SCREE_FAST_BUILD)
  add_library(scree_precompiled STATIC ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_compile_features(scree_precompiled PUBLIC cxx_std_20)
  target_compile_options(scree_precompiled PRIVATE -ffp-contract=off)
  target_link_libraries(scree_precompiled PRIVATE Imath::Imath TBB::tbb fmt::fmt)
  scree_warnings(scree_precompiled)
  scree_own_precompiled_headers(scree_precompiled)
endif()

# scree_library(name SOURCES ... LIBRARIES ... PRIVATE_LIBRARIES ... OPTIONS ... [TOGETHER]):
# LIBRARIES are seen by users of the library's headers; PRIVATE_LIBRARIES and OPTIONS only by its own
# files (one door per library). TOGETHER: fast builds compile its sources, which are small, in
# bunches.
function(scree_library name)
  cmake_parse_arguments(arg "TOGETHER" "" "SOURCES;LIBRARIES;PRIVATE_LIBRARIES;OPTIONS" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/scree>)
  target_link_libraries(${name} PUBLIC ${arg_LIBRARIES} PRIVATE ${arg_PRIVATE_LIBRARIES} fmt::fmt)
  # The same bytes on every machine of a kind: no contraction of a * b + c behind our back.
  target_compile_options(${name} PRIVATE -ffp-contract=off ${arg_OPTIONS})
  scree_warnings(${name})
  if(SCREE_FAST_BUILD)
    if(arg_OPTIONS)
      scree_own_precompiled_headers(${name})
    else()
      scree_reuse_precompiled_headers(${name} scree_precompiled)
    endif()
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${arg_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
  endif()
  set_property(GLOBAL APPEND PROPERTY SCREE_LIBRARIES ${name})
endfunction()

# CGAL::CGAL adds -frounding-math to a whole target: its sources stand apart, so that the others keep
# the compiler's usual arithmetic.
function(scree_cgal_sources library)
  add_library(${library}_cgal OBJECT ${ARGN})
  target_include_directories(${library}_cgal PRIVATE
    $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
  target_link_libraries(${library}_cgal PRIVATE scree_core CGAL::CGAL fmt::fmt)
  # Their templates take a minute to optimise fully, for work of milliseconds.
  target_compile_options(${library}_cgal PRIVATE $<$<CONFIG:Release>:-O1>)
  scree_warnings(${library}_cgal)
  target_sources(${library} PRIVATE $<TARGET_OBJECTS:${library}_cgal>)
  target_link_libraries(${library} PRIVATE $<LINK_ONLY:CGAL::CGAL>)
endfunction()
