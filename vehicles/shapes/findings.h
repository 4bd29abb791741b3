#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a mesh or another shape; the first word of each says which one it is.
namespace fourpost {

inline const Finding kMeshFormat{"mesh-format", Severity::kError, "{} is not OBJ, STL, DAE or glTF",
                                 "use .obj, .stl, .dae, .gltf or .glb"};
inline const Finding kMeshUnreadable{"mesh-unreadable", Severity::kError, "{} cannot be read ({})",
                                     "export the mesh again, as STL or OBJ"};
inline const Finding kMeshNotAFile{"mesh-not-a-file", Severity::kError, "{} is a {}, not a file",
                                   "write its content to a file and name that"};
inline const Finding kMeshElsewhere{"mesh-elsewhere", Severity::kError, "{} refers to the file {} outside its folder",
                                    "put that beside the mesh"};
inline const Finding kMeshFileTooLarge{"mesh-file-too-large", Severity::kError,
                                       "{} cannot be read, file {} is larger than {}", "reduce the mesh"};
inline const Finding kMeshVertex{"mesh-vertex", Severity::kError, "{} has a vertex that is not finite",
                                 "the mesh is damaged, so export it again"};
inline const Finding kMeshIndex{"mesh-index", Severity::kError, "{} has an index of a vertex that is out of range",
                                "the mesh is damaged, so export it again"};
inline const Finding kMeshNoScene{"mesh-no-scene", Severity::kError, "{} holds no scene",
                                  "export the mesh again with its triangles"};
inline const Finding kMeshTriangles{"mesh-too-many-triangles", Severity::kError, "{} has more than {} triangles",
                                    "reduce the mesh"};
inline const Finding kMeshEmpty{"mesh-empty", Severity::kError, "{} has no triangles",
                                "export the mesh again with its triangles"};

inline const Finding kShapeLength{"shape-length", Severity::kError, "{} must have lengths above zero",
                                  "correct the one that is not"};
inline const Finding kShapeScale{"shape-scale", Severity::kError, "{} has a scale of zero and thus no volume",
                                 "write three numbers that are not zero"};
inline const Finding kSurfaceOpen{"surface-open", Severity::kError,
                                  "{} is not closed, {} belongs to one triangle alone",
                                  "close the hole in the mesh, or give an <inertial>"};
inline const Finding kSurfaceFlipped{"surface-flipped", Severity::kError,
                                     "{} is partly inside out, the two triangles at {} face opposite sides",
                                     "flip one of them"};
inline const Finding kSurfaceBranches{"surface-branches", Severity::kError,
                                      "{} does not bound a solid, {} triangles, not two, meet at {}",
                                      "split the mesh into closed bodies"};
inline const Finding kSurfaceFlat{"surface-flat", Severity::kError, "{} encloses no volume",
                                  "use a closed mesh, or give an <inertial>"};
inline const Finding kSurfaceInward{"surface-inward", Severity::kError, "{} faces inward", "flip all its triangles"};

}  // namespace fourpost
