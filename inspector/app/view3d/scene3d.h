#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "view3d/scene_frame.h"

namespace raytree::inspector {

/// A drawn frame: 0xFFRRGGBB row by row from the top left.
struct FrameImage {
    int width = 0, height = 0;
    std::shared_ptr<std::uint32_t[]> pixels;
};

/// Draws the 3D view by VTK, off the screen. It is made, used and destroyed in one thread.
class Scene3d {
  public:
    Scene3d();
    ~Scene3d();

    /// What is drawn from now on; whether shapes or view are others than before.
    bool show(const SceneFrame& frame);
    void render();
    /// Of the last frame.
    FrameImage image() const;

    /// Shapes and view stay the same for a while: the next frame is drawn in a way that makes those
    /// after it quick.
    void keep();
    bool is_keeping() const;
    /// Whether the last frame was drawn so.
    bool keeps() const;
    /// Whether the last frame showed many shapes roughly: then `draw_more` draws them as they are,
    /// for about so long between frames, and returns whether the next frame may show that.
    bool is_rough() const;
    bool draw_more(std::chrono::milliseconds time);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace raytree::inspector
