// statue.hpp - a mirror statue in a pleated robe, with curls: it stands for the paper's statue, whose
// hair and folds send neighbouring rays everywhere.
#pragma once

#include "model/model.hpp"

namespace bench::paper {

// Of about so many triangles, upright about the origin, 2.3 high. It is one mesh without a seam.
void add_statue(render::Model& model, int64_t triangles);

}  // namespace bench::paper
