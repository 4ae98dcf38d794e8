#pragma once

#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// A drawing as LaTeX with TikZ, for pdflatex as it is, on a page of the drawing's size, and for \input into a document that has
/// \usepackage{tikz}, as one tikzpicture.
///
/// A scope for each visibility and class that occurs, in a style of that name, "hsr visible outline", after "hsr fill" for the fills.
/// Comments name the objects where these are told apart. Dashes are each line's own.
/// A style that the document defines before, by \tikzset{hsr visible outline/.style={...}}, stays.
std::string tikz(const Drawing& drawing);

}  // namespace hsr::internal
