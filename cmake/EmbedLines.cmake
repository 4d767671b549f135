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

# embed_keyed_rows(FILE VARIABLE BEGINNING): the same with braces about all cells but the first: `{4,{"S3","3!"}}`.
function(embed_keyed_rows file variable beginning)
  embed_rows(${file} rows "${beginning}")
  string(REGEX REPLACE "{([^,\n]*),([^\n]*)},\n" "{\\1,{\\2}},\n" rows "${rows}")
  set(${variable} "${rows}" PARENT_SCOPE)
endfunction()

# embed_tables(ROOT): writes degrees_data.cpp, groups_data.cpp and family_degrees_data.cpp, which have the tables
# of the project at ROOT, to the current binary folder.
function(embed_tables root)
  embed_rows(${root}/certs/degrees.csv DEGREE_ROWS "#|number,")
  embed_keyed_rows(${root}/certs/groups.csv GROUP_ROWS "#|number,")
  embed_keyed_rows(${root}/certs/family-groups.csv FAMILY_GROUP_ROWS "#|problem,")
  embed_lines(${root}/certs/family-degrees.csv FAMILY_DEGREE_LINES "#|family,")
  embed_lines(${root}/certs/three-views-in-part.csv THREE_VIEW_DEGREE_LINES "#|problem,")
  foreach(name catalogue/degrees_data catalogue/groups_data many_views/family_degrees_data)
    get_filename_component(file ${name} NAME)
    configure_file(${root}/prover/${name}.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${file}.cpp @ONLY)
  endforeach()
endfunction()
