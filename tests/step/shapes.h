#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

namespace hsr::shapes {

/// A plate, 60 x 40 x 8, with rounded corners and upper rim, and 3 x 2 holes of radius 4 through it.
TopoDS_Shape plate();
/// A bottle with a neck, open at the top and hollow; its lower body is rounded everywhere.
TopoDS_Shape bottle();
/// A square tower whose sides bend by three degrees half way up.
TopoDS_Shape loft();
/// A pipe along a bent line, with a torus where it bends.
TopoDS_Shape pipe();
/// A cylinder of radius 10 and height 30, whose seam is in front.
TopoDS_Shape cylinder();
/// 16 teeth of module 2 with involute flanks, 8 thick, and a bore.
TopoDS_Shape gear();
/// A disc of radius 35 with a hub that narrows, a groove at its foot, a bore and six holes.
TopoDS_Shape flange();
/// Wire of radius 2 in 2.5 turns of radius 12.
TopoDS_Shape spring();
/// A barrel roof on four walls, of two surfaces that meet smoothly in the middle. The parameters of both run as slowly there as the first
/// step between their poles is short, a share of the width.
TopoDS_Shape ridge(double first_step);
/// plate() and four bolts in one compound.
TopoDS_Shape assembly();

/// @param unit as Open CASCADE names it: "MM", "INCH"; of the shape's coordinates
void write_step(const TopoDS_Shape& shape, const std::string& file, const std::string& unit = "MM");
void write_iges(const TopoDS_Shape& shape, const std::string& file);
/// The plate and the bolts: one blue definition, four instances, the second in red; the plate is green with a yellow face.
void write_assembly(const std::string& file);

/// A pin of the radius of a hole in a block, turned about its axis, that sticks out by 5.
void write_pin_in_block(const std::string& file);

}  // namespace hsr::shapes
