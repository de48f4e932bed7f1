# With GLINT_PRECOMPILE what most files include is compiled once for all of them, once with each
# rounding. Files that set the rounding themselves must have SKIP_PRECOMPILE_HEADERS.
function(glint_precompile target rounding)
  if(NOT GLINT_PRECOMPILE)
    return()
  endif()
  if(NOT TARGET glint_precompiled_${rounding})
    file(WRITE ${PROJECT_BINARY_DIR}/precompiled_${rounding}.cpp "")
    add_library(glint_precompiled_${rounding} OBJECT
      ${PROJECT_BINARY_DIR}/precompiled_${rounding}.cpp)
    target_link_libraries(glint_precompiled_${rounding} PRIVATE glint_math glint_${rounding})
    target_precompile_headers(glint_precompiled_${rounding} PRIVATE
      ${PROJECT_SOURCE_DIR}/framework/math/lanes.hpp ${PROJECT_SOURCE_DIR}/framework/math/vec.hpp
      ${PROJECT_SOURCE_DIR}/framework/math/error.hpp
      <algorithm> <filesystem> <functional> <iostream> <map> <span> <sstream> <vector>)
  endif()
  target_precompile_headers(${target} REUSE_FROM glint_precompiled_${rounding})
endfunction()

# glint_room(NAME HEADERS h... [SOURCES s...] USES room...): one folder of framework/, a library.
# Each header is compiled alone: by the .cpp of its name, which it opens, or by header verification.
function(glint_room name)
  cmake_parse_arguments(arg "" "" "HEADERS;SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_USES PREPEND glint_)
  list(TRANSFORM arg_SOURCES REPLACE "\\.cpp$" ".hpp" OUTPUT_VARIABLE opened)
  list(REMOVE_ITEM arg_HEADERS ${opened})
  if(arg_SOURCES)
    add_library(glint_${name} STATIC ${arg_SOURCES})
    target_link_libraries(glint_${name} PUBLIC glint_options ${arg_USES} PRIVATE glint_exact)
    target_sources(glint_${name} PUBLIC FILE_SET HEADERS
      BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
    glint_precompile(glint_${name} exact)
  else()
    add_library(glint_${name} INTERFACE)
    target_link_libraries(glint_${name} INTERFACE glint_options ${arg_USES})
    target_sources(glint_${name} INTERFACE FILE_SET HEADERS
      BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
  endif()
  set_target_properties(glint_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()

# glint_program(NAME SOURCES s... USES room...): an executable build/bin/NAME that shades.
function(glint_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_USES PREPEND glint_)
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_USES} glint_processor_check glint_shading)
  glint_precompile(${name} shading)
endfunction()

# glint_test(NAME SOURCES s... USES room...): a doctest executable, run by CTest under its name.
# It is compiled as the code that decides bits is.
function(glint_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_USES PREPEND glint_)
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE
    ${arg_USES} glint_processor_check glint_exact glint_test_main)
  if(CMAKE_CROSSCOMPILING_EMULATOR)
    list(JOIN CMAKE_CROSSCOMPILING_EMULATOR " " emulator)
    target_compile_definitions(${name} PRIVATE EMULATOR="${emulator}")
  endif()
  # Files of tests help themselves to the same names.
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  glint_precompile(${name} exact)
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()
