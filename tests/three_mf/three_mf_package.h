#pragma once

#include <string>

namespace hsr::test {

/// A 3MF file around a model: a zip archive, nothing in it compressed. @param model what is in <model>; @param unit as 3MF names it
std::string three_mf_package(const std::string& model, const std::string& unit = "millimeter");

/// <object> with a tetrahedron: (0, 0, 0) and a corner on each axis, `size` from there.
/// @param attributes of the object @param of_triangle attributes of its last triangle, which has no corner at the origin
std::string tetrahedron(int number, double size, const std::string& attributes = "", const std::string& of_triangle = "");

}  // namespace hsr::test
