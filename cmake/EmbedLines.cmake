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

# embed_rows(FILE VARIABLE BEGINNING): the same with each line as a row of an array: `4,64` is {4,64}.
function(embed_rows file variable beginning)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} lines)
  string(REGEX REPLACE "(${beginning})[^\n]*\n" "" lines "${lines}")
  string(REGEX REPLACE "([^\n]*)\n" "        {\\1},\n" lines "${lines}")
  set(${variable} "${lines}" PARENT_SCOPE)
endfunction()
