# embed_lines(FILE VARIABLE [BEGINNING]): sets the variable to the lines of a text file, each as a string literal
# of C++ and a comma, for configure_file. Leaves out the lines that begin with what matches BEGINNING.
function(embed_lines file variable)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} lines)
  if(ARGC GREATER 2)
    string(REGEX REPLACE "(${ARGV2})[^\n]*\n" "" lines "${lines}")
  endif()
  string(REGEX REPLACE "([^\n]*)\n" "        R\"csv(\\1)csv\"sv,\n" lines "${lines}")
  set(${variable} "${lines}" PARENT_SCOPE)
endfunction()
