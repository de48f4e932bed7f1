# SOURCE must not compile: the first error says SAYS, the compiler names the line that is marked
# wrong - in the first error, where SAYS is deleted function - and all is at most LINES lines.
set(ENV{LC_ALL} C)
execute_process(COMMAND ${COMPILER} ${FLAGS} -fsyntax-only ${SOURCE}
  RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles")
endif()

file(READ ${SOURCE} text)
string(REGEX REPLACE "// wrong.*" "" before "${text}")
string(REGEX MATCHALL "\n" line_ends "${before}")
list(LENGTH line_ends line)
math(EXPR line "${line} + 1")
string(REGEX MATCH "[^\n]*error:[^\n]*" first_error "${output}")
string(FIND "${first_error}" "${SAYS}" said)
if(said EQUAL -1)
  message(FATAL_ERROR "the first error does not say ${SAYS}:\n${output}")
endif()
if(SAYS STREQUAL "deleted function")
  set(output_with_line "${first_error}")
else()
  set(output_with_line "${output}")  # a static_assert stands elsewhere
endif()
if(NOT output_with_line MATCHES "${SOURCE}:${line}:")
  message(FATAL_ERROR "the errors are not about ${SOURCE}:${line}:\n${output}")
endif()

string(REGEX MATCHALL "\n" line_ends "${output}")
list(LENGTH line_ends count)
if(count GREATER LINES)
  message(FATAL_ERROR "${count} lines of errors, more than ${LINES}:\n${output}")
endif()
