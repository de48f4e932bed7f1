# glint_room(NAME HEADERS h... [SOURCES s...] USES room...): one folder of framework/, a library.
function(glint_room name)
  cmake_parse_arguments(arg "" "" "HEADERS;SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_USES PREPEND glint_)
  if(arg_SOURCES)
    add_library(glint_${name} STATIC ${arg_SOURCES})
    target_link_libraries(glint_${name} PUBLIC glint_options ${arg_USES} PRIVATE glint_exact)
    target_sources(glint_${name} PUBLIC FILE_SET HEADERS
      BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${arg_HEADERS})
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
endfunction()

# glint_test(NAME SOURCES s... USES room...): a doctest executable, run by CTest under its name.
# It is compiled as the code that decides bits is.
function(glint_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES" ${ARGN})
  list(TRANSFORM arg_USES PREPEND glint_)
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE
    ${arg_USES} glint_processor_check glint_exact glint_test_main)
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()
