# SPDX-License-Identifier: GPL-3.0-or-later
# scree_kernel(FILE.cl NAMESPACE ... [AFTER HEADER...]): makes, beside the same path in the build
# folder, FILE_source.h with the kernel's text for OpenCL as `inline constexpr const char*
# FILE_source`, and FILE_as_cpp.h with the same text as C++ in the namespace, after the headers.
# Both are made again when FILE.cl changes.
function(scree_kernel file)
  cmake_parse_arguments(arg "" "NAMESPACE" "AFTER" ${ARGN})
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR}/${file} DIRECTORY)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${folder})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  set(made ${PROJECT_BINARY_DIR}/generated/${folder}/${name})
  file(CONFIGURE OUTPUT ${made}_source.h CONTENT
[[// Made by CMake from @file@.
#pragma once

namespace scree {

inline constexpr const char* @name@_source = R"kernel(@text@)kernel";

} // namespace scree
]] @ONLY)
  set(includes "")
  foreach(header ${arg_AFTER})
    string(APPEND includes "#include \"${header}\"\n")
  endforeach()
  file(CONFIGURE OUTPUT ${made}_as_cpp.h CONTENT
[[// Made by CMake for @file@.
#pragma once

#include "core/kernel_as_cpp.h"
@includes@
#define kernel static
#define global
namespace @arg_NAMESPACE@ {
using namespace scree::kernel_as_cpp;
#include "@folder@/@name@.cl"
} // namespace @arg_NAMESPACE@
#undef kernel
#undef global
]] @ONLY)
endfunction()
