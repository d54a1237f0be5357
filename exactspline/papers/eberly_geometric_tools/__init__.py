"""D. Eberly, *Geometric Tools*: comments and code of its headers on curves and implicit curves and surfaces."""
