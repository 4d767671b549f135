# With PLC_UNITE each folder of a library's or program's sources is compiled in one piece: most of the
# compiler's time goes to headers and to templates of the standard library, once per piece. Kinds of
# cameras stay alone, as each has the same names inside; and so does what is named after EXCEPT: it has
# names in common with its neighbours, or takes the compiler as long as a folder does.
function(unite target)
  if(NOT PLC_UNITE)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 unite "" "" EXCEPT)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources EXCLUDE REGEX "^${CMAKE_BINARY_DIR}/|/?cameras/[^/]*$|\\$<")
  list(REMOVE_ITEM sources ${unite_EXCEPT})
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${target}_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
