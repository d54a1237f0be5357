"""D. Eberly, *Geometric Tools*: what the comments and the code of its headers say of curves and implicit surfaces."""
