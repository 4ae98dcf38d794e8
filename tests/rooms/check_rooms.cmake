# Checks by the #include lines of the library that each room includes only itself and rooms below it, so that what is below can be
# built, understood and installed without what is above.
# cmake -DSOURCE=... -P check_rooms.cmake
cmake_minimum_required(VERSION 3.23)

# Each room, then those that it stands on. What these stand on may be included too.
set(rooms
  "geometry"
  "hsr geometry"             # the headers beside the rooms: model.h, image.h
  "view geometry"
  "symbols view"
  "scene symbols hsr"
  "visibility_map scene"
  "lines visibility_map"
  "surfaces lines hsr"       # visible fragments are bounded by visible lines
  "painter visibility_map"
  "drawing surfaces painter"
  "coordinates drawing"      # rounds as a drawing does
  "raster painter hsr"
  "check drawing raster"
  "sheet drawing"            # several views on one page
  "tiles drawing hsr"        # one scene in tiles of the image
  "io coordinates"
  "study io check sheet"
  "step io"
  "three_mf io"
  "cli study step three_mf tiles")

# From the bottom up, so that what is below a room is known when the room is reached.
foreach(line IN LISTS rooms)
  separate_arguments(line)
  list(POP_FRONT line room)
  set(below_${room} ${room})
  foreach(other IN LISTS line)
    if(NOT DEFINED below_${other})
      message(FATAL_ERROR "room ${room} stands on ${other}, which is not below it")
    endif()
    list(APPEND below_${room} ${below_${other}})
  endforeach()
endforeach()

# hsr/lines/plan.h is in the room lines, hsr/model.h in the room hsr, geometry/mesh.h in the room geometry.
function(room_of path result)
  if(path MATCHES "^hsr/([^/]+)/")
    set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
  else()
    string(REGEX REPLACE "/.*" "" room ${path})
    set(${result} ${room} PARENT_SCOPE)
  endif()
endfunction()

file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/geometry/*.h ${SOURCE}/geometry/*.cpp ${SOURCE}/hsr/*.h ${SOURCE}/hsr/*.cpp
  ${SOURCE}/study/*.h ${SOURCE}/study/*.cpp)
set(count 0)
set(wrong "")
foreach(file IN LISTS files)
  # The headers that include all of a component stand on every room of it.
  if(file MATCHES "^hsr/(check|eigen|hsr|io|raster|step|three_mf)\\.h$")
    continue()
  endif()
  room_of(${file} room)
  if(NOT DEFINED below_${room})
    string(APPEND wrong "${file} is in no room of the list\n")
    continue()
  endif()
  file(STRINGS ${SOURCE}/${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*\"(.*)\".*" "\\1" included ${line})
    room_of(${included} other)
    math(EXPR count "${count} + 1")
    if(NOT other IN_LIST below_${room})
      string(APPEND wrong "${file} includes ${included}: ${other} is not below ${room}\n")
    endif()
  endforeach()
endforeach()
if(count EQUAL 0)
  message(FATAL_ERROR "no #include line found below ${SOURCE}")
endif()
if(NOT wrong STREQUAL "")
  message("${wrong}")
  message(FATAL_ERROR "includes that do not run downward")
endif()
message("${count} #include lines, each of a room below")
