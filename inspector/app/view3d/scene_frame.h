#pragma once

#include <array>
#include <memory>

#include "drawing/angles.h"
#include "drawing/explained_mesh.h"
#include "drawing/ray_mesh.h"
#include "drawing/scene_mesh.h"
#include "state/look.h"
#include "state/picture.h"

namespace raytree::inspector {

/// What stands among the shapes; it is made anew for each view and selection.
struct SceneThings {
    Landmarks marks;
    RayMeshes rays;
    AngleDrawing angles;
    ExplainedMesh explained;
};

/// A scene's picture where the camera sees it.
struct PicturePlace {
    std::array<Point3, 4> corners{};  ///< from the top left one on
    /// Its pixels are squares where they are large enough to be seen, else smoothed.
    bool squares = false;
    bool shown = false;

    friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

/// All that a frame of the 3D view shows. What is the same object in the next frame has not
/// changed.
struct SceneFrame {
    Theme theme = Theme::light;
    std::shared_ptr<const SceneMesh> shapes;
    ShapeStyle style = ShapeStyle::see_through;
    Extent extent;
    std::shared_ptr<const ShownPicture> picture;  ///< null: none yet
    PicturePlace picture_place;
    std::shared_ptr<const SceneThings> things;
    View view;
    double ratio = 1;         ///< the frame's pixels by the view's
    bool whole = false;       ///< no matter how long drawing it takes
    long long many = 20'000;  ///< triangles and lines of shapes that are drawn roughly at first
};

}  // namespace raytree::inspector
