# lib3mf, by hand: its package has no configuration for CMake, and its headers have a folder of their own.
# HSR_LIB3MF_INCLUDE and HSR_LIB3MF_LIBRARY, and HSR_LIB3MF_FOUND if both are there.
find_path(HSR_LIB3MF_INCLUDE Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
find_library(HSR_LIB3MF_LIBRARY 3MF)
mark_as_advanced(HSR_LIB3MF_INCLUDE HSR_LIB3MF_LIBRARY)
set(HSR_LIB3MF_FOUND OFF)
if(HSR_LIB3MF_INCLUDE AND HSR_LIB3MF_LIBRARY)
  set(HSR_LIB3MF_FOUND ON)
endif()
