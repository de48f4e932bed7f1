# SOURCE must not compile: the first error says deleted function and names the line that is marked
# wrong, and all that the compiler says is at most LINES lines.
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
if(NOT first_error MATCHES "^${SOURCE}:${line}:.*deleted function")
  message(FATAL_ERROR "the first error is not about ${SOURCE}:${line}:\n${output}")
endif()

string(REGEX MATCHALL "\n" line_ends "${output}")
list(LENGTH line_ends count)
if(count GREATER LINES)
  message(FATAL_ERROR "${count} lines of errors, more than ${LINES}:\n${output}")
endif()
